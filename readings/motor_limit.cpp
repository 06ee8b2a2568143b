#include "readings/motor_limit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "numerics/robust.hpp"

namespace reeve::readings {
namespace {

// ln of the sum of the readings over the motor tension. NaN if it is of no use.
double carried_part(const Reading& reading) {
  double sum_N = 0;
  for (const auto& tension : reading.tension_N) sum_N += tension.value_or(0);
  return std::log(sum_N / reading.motor_tension_N.value_or(0));
}

// Differences of rows from the first one that is alike.
class Differences {
 public:
  void add(const Reading& reading) {
    const double part = carried_part(reading);
    if (!std::isfinite(part)) return;
    std::vector<bool> has;
    for (const auto& tension : reading.tension_N) has.push_back(tension.has_value());
    const auto [first, is_first] = first_.try_emplace(
        {reading.routing, reading.grasp.held, reading.direction, std::move(has)}, part);
    if (!is_first) sizes_.push_back(std::abs(part - first->second));
  }
  bool tells() const { return sizes_.size() >= 6; }
  double middle() const { return median(sizes_); }

 private:
  std::map<std::tuple<std::size_t, std::uint64_t, Direction, std::vector<bool>>, double> first_;
  std::vector<double> sizes_;
};

}  // namespace

void free_motor_tensions_at_their_limit(MeasuredData& data) {
  constexpr double same = 1e-3;
  constexpr double clearly = 3;
  double greatest_N = 0;
  for (const Reading& reading : data.readings) {
    greatest_N = std::max(greatest_N, reading.motor_tension_N.value_or(0));
  }
  const auto is_at_limit = [&](const Reading& reading) {
    return reading.motor_tension_N && *reading.motor_tension_N >= (1 - same) * greatest_N;
  };
  Differences at_limit, below;
  for (const Reading& reading : data.readings) {
    (is_at_limit(reading) ? at_limit : below).add(reading);
  }
  if (!at_limit.tells() || !below.tells()) return;
  if (!(at_limit.middle() > clearly * below.middle())) return;
  auto lines = lines_where(data, is_at_limit);
  for (Reading& reading : data.readings) {
    if (!is_at_limit(reading)) continue;
    reading.motor_tension_N.reset();
    reading.motor_error_N.reset();
  }
  data.notes.push_back(
      {NoteKind::not_compared,
       fmt::format("motor_tension_N is {:.4g} N in {} rows whose strands carry different loads: "
                   "its sensor ends there. These rows are compared by shares",
                   greatest_N, lines.size()),
       std::move(lines)});
}

}  // namespace reeve::readings
