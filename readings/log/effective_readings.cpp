#include "readings/log/effective_readings.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reeve::readings {
namespace {

// Lags beyond are of too few pairs.
constexpr std::size_t least_pairs_share = 3;
constexpr double window = 5;  // times τ
constexpr int rounds = 4;

double sum_of_squares(std::span<const double> values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return sum;
}

// Autocorrelation pooled over stretches, each scaled to variance 1.
class PooledAutocorrelation {
 public:
  explicit PooledAutocorrelation(std::vector<std::vector<double>> residuals)
      : stretches_(std::move(residuals)) {
    std::erase_if(stretches_, [](const auto& stretch) { return sum_of_squares(stretch) == 0; });
    for (std::vector<double>& stretch : stretches_) {
      const auto count = static_cast<double>(stretch.size());
      const double deviation = std::sqrt(sum_of_squares(stretch) / count);
      for (double& residual : stretch) residual /= deviation;
      longest_ = std::max(longest_, stretch.size());
    }
  }

  bool is_empty() const { return stretches_.empty(); }
  std::size_t longest() const { return longest_; }

  // Computed when it is first asked for: mostly a few lags are enough.
  double at(std::size_t lag) {
    while (known_.size() <= lag) known_.push_back(computed(known_.size()));
    return known_[lag].correlation;
  }

  // Returns the autocovariance that the fitted line removes at this lag, over σ² τ.
  double taken(std::size_t lag) {
    at(lag);
    return known_[lag].taken;
  }

 private:
  struct Lag {
    double correlation = 0;
    double taken = 0;
  };

  Lag computed(std::size_t lag) const {
    Lag result;
    double pairs = 0;
    for (const std::vector<double>& stretch : stretches_) {
      if (stretch.size() <= lag) continue;
      const auto count = static_cast<double>(stretch.size());
      const double u = static_cast<double>(lag) / count;
      for (std::size_t i = lag; i < stretch.size(); ++i) {
        result.correlation += stretch[i] * stretch[i - lag];
      }
      pairs += count * (1 - u);
      result.taken += (1 - u) * (1 + (1 - u) * (1 - u) - 3 * u * u);
    }
    return {result.correlation / pairs, result.taken / pairs};
  }

  std::vector<std::vector<double>> stretches_;
  std::size_t longest_ = 0;
  std::vector<Lag> known_;
};

// Returns the next τ, with the correction by the τ of the round before.
double next_time(PooledAutocorrelation& correlation, double time) {
  const std::size_t lags = std::max<std::size_t>(2, correlation.longest() / least_pairs_share);
  const double variance = 1 / (1 - std::min(0.5, time * correlation.taken(0)));
  const auto corrected = [&](std::size_t lag) {
    return correlation.at(lag) / variance + time * correlation.taken(lag);
  };
  double before = corrected(0) + 1;
  double sum = 0;
  for (std::size_t lag = 0; lag + 1 < lags; lag += 2) {
    const double pair = corrected(lag) + corrected(lag + 1);
    if (pair <= 0 || static_cast<double>(lag) > window * std::max(1.0, 2 * sum - 1)) break;
    before = std::min(before, pair);
    sum += before;
  }
  return std::max(1.0, 2 * sum - 1);
}

}  // namespace

double correlation_time(std::vector<std::vector<double>> residuals) {
  PooledAutocorrelation correlation(std::move(residuals));
  if (correlation.is_empty()) return 1;
  double time = 0;
  for (int round = 0; round < rounds; ++round) time = next_time(correlation, time);
  return time;
}

double deviation_of_samples(std::span<const double> residuals, double correlation_time) {
  constexpr double of_a_line = 2;  // parameters
  const auto count = static_cast<double>(residuals.size());
  return std::sqrt(sum_of_squares(residuals) /
                   std::max(count - of_a_line * correlation_time, count / 2));
}

}  // namespace reeve::readings
