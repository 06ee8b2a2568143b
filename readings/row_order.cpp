#include "readings/row_order.hpp"

#include <algorithm>
#include <cctype>
#include <limits>
#include <numeric>
#include <optional>
#include <tuple>
#include <utility>
#include <vector>

#include "readings/column_name.hpp"

namespace reeve::readings {

namespace {

std::vector<std::size_t> counted(std::size_t count) {
  std::vector<std::size_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), std::size_t{0});
  return numbers;
}

// `order` lists the old places; a list that was left empty stays so.
template <typename T>
void rearrange(std::vector<T>& all, const std::vector<std::size_t>& order) {
  if (all.empty()) return;
  std::vector<T> result;
  result.reserve(order.size());
  for (const std::size_t i : order) result.push_back(std::move(all[i]));
  all = std::move(result);
}

// [old place]: new place.
std::vector<std::size_t> new_places(const std::vector<std::size_t>& order) {
  std::vector<std::size_t> places(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) places[order[i]] = i;
  return places;
}

// Rearranges what readings number, and gives them the new numbers. `number_of` returns a pointer to
// a reading's number, null if it has none.
template <typename T, typename NumberOf>
void renumber(std::vector<T>& all, const std::vector<std::size_t>& order,
              std::vector<Reading>& readings, NumberOf number_of) {
  const std::vector<std::size_t> places = new_places(order);
  rearrange(all, order);
  for (Reading& reading : readings) {
    if (std::size_t* number = number_of(reading)) *number = places[*number];
  }
}

// … in the order in which the readings first have it.
template <typename T, typename NumberOf>
void renumber_as_met(std::vector<T>& all, std::vector<Reading>& readings, NumberOf number_of) {
  std::vector<std::size_t> order;
  std::vector<bool> met(all.size(), false);
  const auto meet = [&](std::size_t i) {
    if (!met[i]) order.push_back(i);
    met[i] = true;
  };
  for (Reading& reading : readings) {
    if (const std::size_t* number = number_of(reading)) meet(*number);
  }
  for (std::size_t i = 0; i < all.size(); ++i) meet(i);
  renumber(all, order, readings, number_of);
}

void order_channels(MeasuredData& data) {
  std::vector<std::size_t> order = counted(data.channels.size());
  const auto key = [&](std::size_t c) {
    const Segment& segment = data.channels[c].segment;
    return std::tie(segment.kind, segment.number);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  if (std::is_sorted(order.begin(), order.end())) return;
  rearrange(data.channels, order);
  rearrange(data.known_noise, order);
  for (MeasuredRouting& routing : data.routings) rearrange(routing.segments, order);
  for (Reading& reading : data.readings) {
    rearrange(reading.tension_N, order);
    rearrange(reading.error_N, order);
  }
}

void order_runs(MeasuredData& data) {
  std::vector<std::size_t> order = counted(data.runs.size());
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return natural_less(data.runs[a], data.runs[b]); });
  renumber(data.runs, order, data.readings, [](Reading& reading) { return &reading.run; });
}

void order_readings(MeasuredData& data) {
  const auto key = [&](const Reading& r) {
    return std::tie(r.run, r.cycle, data.routings[r.routing].word, r.grasp.held, r.direction,
                    r.motor_tension_N, r.sheath_angle_rad, r.speed_mm_s, r.temperature_C,
                    r.tension_N, r.taken);
  };
  std::sort(data.readings.begin(), data.readings.end(),
            [&](const Reading& a, const Reading& b) { return key(a) < key(b); });
}

struct TimeSpan {
  double first = std::numeric_limits<double>::infinity();
  double last = -std::numeric_limits<double>::infinity();
};

// Returns the place of each run among the runs.
std::vector<std::size_t> places_of_runs(const MeasuredData& data, std::size_t clock) {
  std::vector<TimeSpan> spans(data.runs.size());
  for (const Reading& reading : data.readings) {
    TimeSpan& span = spans[reading.run];
    span.first = std::min(span.first, *reading.covariates[clock]);
    span.last = std::max(span.last, *reading.covariates[clock]);
  }
  std::vector<std::size_t> order = counted(spans.size());
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return spans[a].first < spans[b].first; });
  const auto begun_again = std::adjacent_find(
      order.begin(), order.end(),
      [&](std::size_t a, std::size_t b) { return spans[b].first < spans[a].last; });
  if (begun_again != order.end()) return counted(spans.size());
  return new_places(order);
}

// Takes a number off the text and returns it without leading zeros. Returns an empty text if the
// text begins with another character.
std::string_view take_number(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && std::isdigit(static_cast<unsigned char>(text[end])) != 0) ++end;
  std::string_view digits = text.substr(0, end);
  text.remove_prefix(end);
  while (digits.size() > 1 && digits.front() == '0') digits.remove_prefix(1);
  return digits;
}

}  // namespace

bool natural_less(std::string_view a, std::string_view b) {
  const std::string_view whole_a = a;
  const std::string_view whole_b = b;
  while (!a.empty() && !b.empty()) {
    const std::string_view x = take_number(a);
    const std::string_view y = take_number(b);
    if (!x.empty() && !y.empty()) {
      if (x != y) return x.size() != y.size() ? x.size() < y.size() : x < y;
      continue;
    }
    if (x.empty() != y.empty()) return !x.empty();
    // The cast gives the same order on every machine, whatever the sign of its char.
    if (a.front() != b.front()) {
      return static_cast<unsigned char>(a.front()) < static_cast<unsigned char>(b.front());
    }
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  if (a.empty() != b.empty()) return a.empty();
  return whole_a < whole_b;
}

std::vector<double> run_numbers(const std::vector<std::string>& runs) {
  constexpr std::string_view digits = "0123456789";
  constexpr std::size_t most_digits = 15;  // of which a double holds each
  std::vector<double> result;
  std::optional<std::pair<std::string_view, std::string_view>> around;
  for (const std::string_view name : runs) {
    const std::size_t last = name.find_last_of(digits);
    if (last == name.npos) break;
    const std::size_t first = name.find_last_not_of(digits, last) + 1;  // npos + 1 is 0
    std::pair here{name.substr(0, first), name.substr(last + 1)};
    const bool is_fraction = here.first.ends_with('.') || here.first.ends_with(',');
    const bool is_negative = here.first == "-";
    if (is_negative) here.first = {};
    if (is_fraction || last - first >= most_digits || (around && *around != here)) break;
    around = here;
    double number = 0;
    for (const char digit : name.substr(first, last + 1 - first))
      number = 10 * number + (digit - '0');
    result.push_back(is_negative ? -number : number);
  }
  if (result.size() == runs.size()) return result;
  result.resize(runs.size());
  std::iota(result.begin(), result.end(), 1.0);
  return result;
}

MeasuredData in_order_of_contents(MeasuredData data) {
  order_channels(data);
  order_runs(data);
  order_readings(data);
  renumber_as_met(data.routings, data.readings, [](Reading& reading) { return &reading.routing; });
  renumber_as_met(data.groups, data.readings,
                  [](Reading& reading) { return reading.group ? &*reading.group : nullptr; });
  return data;
}

std::optional<std::size_t> clock_of(const MeasuredData& data) {
  for (std::size_t c = 0; c < data.covariates.size(); ++c) {
    const bool everywhere =
        std::all_of(data.readings.begin(), data.readings.end(),
                    [&](const Reading& reading) { return reading.covariates[c].has_value(); });
    if (everywhere && clock_unit(data.covariates[c])) return c;
  }
  return std::nullopt;
}

void set_taken(MeasuredData& data) {
  std::vector<std::size_t> order = counted(data.readings.size());
  if (const std::optional<std::size_t> clock = clock_of(data)) {
    const std::vector<std::size_t> runs = places_of_runs(data, *clock);
    const auto key = [&](std::size_t i) {
      const Reading& reading = data.readings[i];
      return std::tuple(runs[reading.run], *reading.covariates[*clock]);
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
  }
  for (std::size_t i = 0; i < order.size(); ++i) data.readings[order[i]].taken = i;
}

}  // namespace reeve::readings
