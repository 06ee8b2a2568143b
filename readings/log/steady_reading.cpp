#include "readings/log/steady_reading.hpp"

#include <algorithm>
#include <cmath>

#include "numerics/robust.hpp"
#include "readings/log/effective_readings.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_samples = 5;
constexpr double spike_deviations = 6;

using Indices = std::vector<std::size_t>;

std::vector<double> values_at(const std::vector<double>& values, const Indices& samples) {
  std::vector<double> result;
  for (const std::size_t i : samples) result.push_back(values[i]);
  return result;
}

double mean_of(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

struct SignalLine {
  double mean = 0;
  double slope = 0;
  std::vector<double> residuals;
};

SignalLine least_squares(const std::vector<double>& times, const std::vector<double>& values) {
  SignalLine line;
  const double time = mean_of(times);
  line.mean = mean_of(values);
  double covariance = 0;
  double variance = 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    covariance += (times[i] - time) * (values[i] - line.mean);
    variance += (times[i] - time) * (times[i] - time);
  }
  line.slope = variance > 0 ? covariance / variance : 0;
  for (std::size_t i = 0; i < times.size(); ++i) {
    line.residuals.push_back(values[i] - line.mean - line.slope * (times[i] - time));
  }
  return line;
}

// About a line that no wild value moves.
std::vector<double> resistant_residuals(const std::vector<double>& times,
                                        const std::vector<double>& values) {
  const auto third = static_cast<std::ptrdiff_t>(std::max<std::size_t>(1, times.size() / 3));
  const auto first = [&](const std::vector<double>& all) {
    return median({all.begin(), all.begin() + third});
  };
  const auto last = [&](const std::vector<double>& all) {
    return median({all.end() - third, all.end()});
  };
  const double seconds = last(times) - first(times);
  const double slope = seconds > 0 ? (last(values) - first(values)) / seconds : 0;
  std::vector<double> residuals;
  for (std::size_t i = 0; i < times.size(); ++i) residuals.push_back(values[i] - slope * times[i]);
  const double middle = median(residuals);
  for (double& residual : residuals) residual -= middle;
  return residuals;
}

class Averaging {
 public:
  Averaging(const LoggedSeries& series, std::size_t begin, std::size_t end, double tolerance,
            std::vector<SampleUse>& uses)
      : series_(series), begin_(begin), end_(end), tolerance_(tolerance), uses_(uses) {
    for (std::size_t i = begin; i < end; ++i) kept_.push_back(i);
    for (const LoggedSignal* sensor : series.sensors()) {
      if (most_samples_have(*sensor)) chosen_.push_back(sensor);
    }
  }

  std::optional<AveragedStretch> average() {
    leave_out(SampleUse::incomplete, [&](std::size_t i) { return is_incomplete(i); });
    if (series_.position_mm.is_logged()) {
      leave_out(SampleUse::copy, [&](std::size_t i) { return is_copy(i); });
    }
    if (chosen_.empty() || kept_.size() < least_samples) return nothing();
    leave_out_spikes();
    if (kept_.size() < least_samples) return nothing();
    for (const std::size_t i : kept_) uses_[i] = SampleUse::taken;
    return reading();
  }

 private:
  bool most_samples_have(const LoggedSignal& signal) const {
    const auto given = std::count_if(kept_.begin(), kept_.end(),
                                     [&](std::size_t i) { return !std::isnan(signal.values[i]); });
    return 2 * static_cast<std::size_t>(given) >= kept_.size();
  }

  template <typename Test>
  void leave_out(SampleUse use, Test test) {
    Indices left;
    for (const std::size_t i : kept_) {
      if (test(i)) {
        uses_[i] = use;
      } else {
        left.push_back(i);
      }
    }
    kept_ = std::move(left);
  }

  bool is_incomplete(std::size_t i) const {
    return std::any_of(chosen_.begin(), chosen_.end(),
                       [&](const LoggedSignal* signal) { return std::isnan(signal->values[i]); });
  }

  bool is_copy(std::size_t i) const {
    if (i == begin_) return false;
    const auto repeats = [&](const LoggedSignal& signal) {
      return signal.values[i] == signal.values[i - 1];
    };
    return repeats(series_.position_mm) &&
           std::all_of(chosen_.begin(), chosen_.end(),
                       [&](const LoggedSignal* signal) { return repeats(*signal); });
  }

  void leave_out_spikes() {
    const std::vector<double> times = values_at(series_.time_s, kept_);
    std::vector<bool> wild(end_ - begin_, false);
    for (const LoggedSignal* signal : chosen_) {
      const std::vector<double> values = values_at(signal->values, kept_);
      const std::vector<double> residuals = resistant_residuals(times, values);
      const double allowed = std::max(spike_deviations * mad_about_zero(residuals),
                                      tolerance_ * std::abs(median(values)));
      for (std::size_t i = 0; i < kept_.size(); ++i) {
        if (std::abs(residuals[i]) > allowed) wild[kept_[i] - begin_] = true;
      }
    }
    leave_out(SampleUse::spike, [&](std::size_t i) { return wild[i - begin_]; });
  }

  std::optional<AveragedStretch> nothing() {
    for (const std::size_t i : kept_) uses_[i] = SampleUse::too_few;
    return std::nullopt;
  }

  AveragedStretch reading() {
    SteadyReading& result = stretch_.reading;
    times_ = values_at(series_.time_s, kept_);
    result.begin = begin_;
    result.end = end_;
    result.time_s = mean_of(times_);
    result.samples = kept_.size();
    result.motor_tension_N = averaged(series_.motor_tension_N);
    for (const LoggedSignal& tension : series_.tensions_N) {
      result.tensions_N.push_back(averaged(tension));
    }
    for (const LoggedSignal& other : series_.others) result.others.push_back(mean_given(other));
    result.speed_mm_s = speed();
    return std::move(stretch_);
  }

  std::optional<AveragedTension> averaged(const LoggedSignal& signal) {
    stretch_.residuals_N.emplace_back();
    if (std::find(chosen_.begin(), chosen_.end(), &signal) == chosen_.end()) return std::nullopt;
    SignalLine line = least_squares(times_, values_at(signal.values, kept_));
    stretch_.residuals_N.back() = std::move(line.residuals);
    return AveragedTension{line.mean, 0};
  }

  std::optional<double> mean_given(const LoggedSignal& signal) const {
    if (!signal.is_logged()) return std::nullopt;
    std::vector<double> values = values_at(signal.values, kept_);
    std::erase_if(values, [](double value) { return std::isnan(value); });
    if (values.empty()) return std::nullopt;
    return mean_of(values);
  }

  // Uses the position if it is logged.
  std::optional<double> speed() const {
    if (series_.position_mm.is_logged()) {
      const std::vector<double> positions = values_at(series_.position_mm.values, kept_);
      const double slope = least_squares(times_, positions).slope;
      if (!std::isnan(slope)) return std::abs(slope);
    }
    const std::optional<double> logged = mean_given(series_.speed_mm_s);
    if (!logged) return std::nullopt;
    return std::abs(*logged);
  }

  const LoggedSeries& series_;
  std::size_t begin_;
  std::size_t end_;
  double tolerance_;
  std::vector<SampleUse>& uses_;
  std::vector<const LoggedSignal*> chosen_;
  Indices kept_;
  std::vector<double> times_;
  AveragedStretch stretch_;
};

std::optional<AveragedTension>& tension_of(SteadyReading& reading, std::size_t signal) {
  return signal == 0 ? reading.motor_tension_N : reading.tensions_N[signal - 1];
}

}  // namespace

std::optional<AveragedStretch> average(const LoggedSeries& series, std::size_t begin,
                                       std::size_t end, double tolerance,
                                       std::vector<SampleUse>& uses) {
  return Averaging(series, begin, end, tolerance, uses).average();
}

std::vector<SteadyReading> with_scatter(std::vector<AveragedStretch> stretches) {
  const std::size_t signals = stretches.empty() ? 0 : stretches[0].residuals_N.size();
  double longest = 1;
  for (std::size_t signal = 0; signal < signals; ++signal) {
    std::vector<std::vector<double>> residuals;
    for (const AveragedStretch& stretch : stretches) {
      residuals.push_back(stretch.residuals_N[signal]);
    }
    const double time = correlation_time(std::move(residuals));
    longest = std::max(longest, time);
    for (AveragedStretch& stretch : stretches) {
      if (std::optional<AveragedTension>& tension = tension_of(stretch.reading, signal)) {
        tension->deviation_N = deviation_of_samples(stretch.residuals_N[signal], time);
      }
    }
  }
  std::vector<SteadyReading> readings;
  for (AveragedStretch& stretch : stretches) {
    const double worth = static_cast<double>(stretch.reading.samples) / longest;
    stretch.reading.readings = std::max<std::size_t>(1, static_cast<std::size_t>(worth));
    readings.push_back(std::move(stretch.reading));
  }
  return readings;
}

}  // namespace reeve::readings
