#include "readings/log/log_words.hpp"

#include <algorithm>

#include "readings/log/wall_clock.hpp"

namespace reeve::readings {
void LogWords::add(std::string_view word, std::size_t samples) {
  auto found = known_.find(word);
  if (found == known_.end()) {
    found = known_.emplace(word, static_cast<std::uint32_t>(words_.size())).first;
    words_.push_back(&found->first);
  }
  ids_.insert(ids_.end(), samples, found->second);
}

bool LogWords::are_labels() const {
  constexpr std::size_t least_samples = 5;
  return changes() * least_samples <= ids_.size() && !are_times_of_day();
}

std::size_t LogWords::changes() const {
  std::size_t count = 0;
  for (std::size_t i = 1; i < ids_.size(); ++i) count += ids_[i] != ids_[i - 1] ? 1 : 0;
  return count;
}

bool LogWords::are_times_of_day() const {
  bool any = false;
  for (const std::string* word : words_) {
    if (word->empty()) continue;
    if (!is_time_of_day(*word)) return false;
    any = true;
  }
  return any;
}

}  // namespace reeve::readings
