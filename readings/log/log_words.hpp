// A column of a log that has words: labels, which stay for a while, or what goes with the samples,
// such as a clock on the wall. A log that is cut where the latter change has no steady stretch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

class LogWords {
 public:
  // Of the next samples.
  void add(std::string_view word, std::size_t samples = 1);

  std::size_t size() const { return ids_.size(); }
  // Equal for equal words.
  std::uint32_t id(std::size_t sample) const { return ids_[sample]; }
  const std::string& word(std::size_t sample) const { return *words_[ids_[sample]]; }

  // Whether they label: no times of day, alone or behind a date, and on average each stays over as
  // many samples as the shortest reading has.
  bool are_labels() const;

 private:
  std::size_t changes() const;
  bool are_times_of_day() const;

  std::map<std::string, std::uint32_t, std::less<>> known_;
  std::vector<const std::string*> words_;  // by id
  std::vector<std::uint32_t> ids_;
};

}  // namespace reeve::readings
