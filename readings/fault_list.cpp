#include "readings/fault_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace reeve::readings {

namespace {

constexpr std::size_t most_kinds = 8;

}  // namespace

void FaultList::add(std::size_t line, const std::string& kind, InputFault fault) {
  ++count_;
  ++kinds_[kind];
  const auto place =
      std::upper_bound(first_.begin(), first_.end(), line,
                       [](std::size_t at, const LineFault& other) { return at < other.line; });
  if (place == first_.end() && first_.size() == most_listed_faults) return;
  first_.insert(place, {line, std::move(fault)});
  if (first_.size() > most_listed_faults) first_.pop_back();
}

void FaultList::add(const FaultList& others) {
  const std::size_t sum = count_ + others.count_;
  auto kinds = kinds_;
  for (const auto& [kind, count] : others.kinds_) kinds[kind] += count;
  for (const LineFault& fault : others.first_) add(fault.line, "", fault.fault);
  count_ = sum;
  kinds_ = std::move(kinds);
}

void FaultList::throw_any(const std::string& file) const {
  if (count_ == 0) return;
  if (count_ == 1) throw InputError(first_.front().fault);
  InputFault all{.where = file, .what = head()};
  for (const LineFault& fault : first_) all.parts.push_back(fault.fault);
  throw InputError(std::move(all));
}

std::string FaultList::head() const {
  std::string text = fmt::format("{} faults", count_);
  if (count_ <= first_.size()) return text;
  std::vector<std::pair<std::size_t, std::string>> kinds;
  for (const auto& [kind, count] : kinds_) kinds.emplace_back(count, kind);
  std::stable_sort(kinds.begin(), kinds.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::size_t told = 0;
  for (std::size_t i = 0; i < kinds.size() && i < most_kinds; ++i) {
    text += fmt::format("{} {} {}", i == 0 ? ":" : ",", kinds[i].first, kinds[i].second);
    told += kinds[i].first;
  }
  if (told < count_) text += fmt::format(", {} elsewhere", count_ - told);
  return text + fmt::format("; the first {}, and {} more", first_.size(), count_ - first_.size());
}

}  // namespace reeve::readings
