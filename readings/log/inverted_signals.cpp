#include "readings/log/inverted_signals.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "numerics/robust.hpp"
#include "readings/inverted.hpp"
#include "readings/load_sign.hpp"

namespace reeve::readings {
namespace {

double size_of(double tension_N) { return std::isnan(tension_N) ? 0 : std::abs(tension_N); }

// Of each sample, over the tensions but the one that is left out.
std::vector<double> sums_without(const LoggedSeries& series, const LoggedSignal& left_out) {
  std::vector<double> sums_N(series.size(), 0);
  for (const LoggedSignal& tension : series.tensions_N) {
    if (&tension == &left_out) continue;
    for (std::size_t i = 0; i < sums_N.size(); ++i) sums_N[i] += size_of(tension.values[i]);
  }
  return sums_N;
}

std::vector<double> what_pulls(const LoggedSeries& series, const LoggedSignal& signal) {
  const LoggedSignal& motor = series.motor_tension_N;
  if (!motor.is_logged() || &signal == &motor) return sums_without(series, signal);
  std::vector<double> sizes_N;
  for (const double tension_N : motor.values) sizes_N.push_back(size_of(tension_N));
  return sizes_N;
}

bool is_below_zero_under_load(const LoggedSignal& signal, const std::vector<double>& loads_N) {
  const double half_N = median(loads_N);
  SignCount signs;
  for (std::size_t i = 0; i < loads_N.size(); ++i) {
    if (loads_N[i] >= half_N && !std::isnan(signal.values[i])) signs.add(signal.values[i]);
  }
  return signs.nearly_all_below();
}

bool is_inverted_signal(const LoggedSeries& series, const LoggedSignal& signal) {
  if (!signal.is_logged()) return false;
  const std::vector<double> loads_N = what_pulls(series, signal);
  if (!is_below_zero_under_load(signal, loads_N)) return false;
  std::vector<LoadedRows> by_label(series.labels.size());
  for (std::size_t i = 0; i < loads_N.size(); ++i) {
    if (!std::isnan(signal.values[i])) by_label[series.label[i]].add(loads_N[i], signal.values[i]);
  }
  return falls_with_load(by_label);
}

}  // namespace

std::optional<DataNote> inverted_signals(const LoggedSeries& series) {
  std::vector<std::string> names;
  if (is_inverted_signal(series, series.motor_tension_N))
    names.push_back(series.motor_tension_N.name);
  for (const LoggedSignal& tension : series.tensions_N) {
    if (is_inverted_signal(series, tension)) names.push_back(tension.name);
  }
  return note_on_inverted(names);
}

}  // namespace reeve::readings
