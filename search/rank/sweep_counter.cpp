#include "search/rank/sweep_counter.hpp"

#include <algorithm>
#include <functional>
#include <utility>

namespace reeve::search {

SweepCounter::SweepCounter(std::vector<double> values) : falling_(std::move(values)) {
  std::sort(falling_.begin(), falling_.end(), std::greater<>());
  falling_.erase(std::unique(falling_.begin(), falling_.end()), falling_.end());
  sums_.assign(falling_.size() + 1, 0);
}

std::size_t SweepCounter::rank(double value) const {
  const auto place = std::upper_bound(falling_.begin(), falling_.end(), value, std::greater<>());
  return static_cast<std::size_t>(place - falling_.begin());
}

void SweepCounter::add(double value) {
  for (std::size_t i = rank(value); i < sums_.size(); i += i & (~i + 1)) ++sums_[i];
}

Eigen::Index SweepCounter::not_less(double value) const {
  Eigen::Index sum = 0;
  for (std::size_t i = rank(value); i > 0; i -= i & (~i + 1)) sum += sums_[i];
  return sum;
}

}  // namespace reeve::search
