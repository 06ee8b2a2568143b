#include <algorithm>
#include <utility>

#include "causes/library/cause_row.hpp"

namespace reeve::causes {
namespace {

bool is_strand(const Segment& segment) { return segment.kind == SegmentKind::strand; }

// Pairs of channels that some routing has both of. None if there are more than 16 channels: those
// have too many pairs to try.
std::vector<Subject> channel_pairs(const Survey& survey) {
  constexpr std::size_t most_channels = 16;
  const std::vector<Segment>& channels = survey.channels;
  if (channels.size() > most_channels) return {};
  const auto met = [&](const Segment& a, const Segment& b) {
    return std::ranges::any_of(survey.routings, [&](const auto& routing) {
      return find_segment(*routing.network, a) && find_segment(*routing.network, b);
    });
  };
  std::vector<Subject> subjects;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    for (std::size_t j = i + 1; j < channels.size(); ++j) {
      if (!met(channels[i], channels[j])) continue;
      Subject& subject = subjects.emplace_back();
      subject.channel = channels[i];
      subject.other_channel = channels[j];
    }
  }
  return subjects;
}

void read_neighbours(std::span<Sensor> sensors, const Conditions&, const Effect& effect) {
  Sensor* own = find_sensor(sensors, *effect.subject.channel);
  if (own == nullptr || !own->column) return;
  double beside_N = 0;
  for (const Sensor& sensor : sensors) {
    const bool is_beside =
        sensor.column && (*sensor.column + 1 == *own->column || *own->column + 1 == *sensor.column);
    if (is_beside) beside_N += sensor.reading_N;
  }
  own->reading_N += effect.values[0] * beside_N;
}

}  // namespace

std::vector<CauseRow> sensor_causes() {
  return {
      // The motor does not give it: springs that open the fingers, or a tendon that was knotted
      // tight. Below 0 it is what sensors lost that were tared under a preload.
      //
      //   T_strand' = T_strand + T_p
      //
      // T_p in N; 0: none. Literature: soft gloves are mounted with 0 to 2 N (order of magnitude).
      {.name = "pretension",
       .reach = Reach::reading,
       .meaning = "every strand reads a constant tension beside the motor's",
       .parameters = {{"tension_N", "N", 0, {-10, 10}, Range{0, 2}}},
       .subjects =
           [](const Survey& survey) {
             const std::vector<Segment>& channels = survey.channels;
             const bool possible = std::ranges::any_of(channels, is_strand);
             return std::vector<Subject>(possible ? 1 : 0);
           },
       .read =
           [](std::span<Sensor> sensors, const Conditions&, const Effect& effect) {
             for (Sensor& sensor : sensors) {
               if (is_strand(sensor.segment)) sensor.reading_N += effect.values[0];
             }
           }},

      // A frame that bends under the neighbours, wires side by side.
      //
      //   reading_j = T_j + c (T_{j-1} + T_{j+1})    neighbours: the columns beside it
      //
      // Columns in the order of the data; one that the routing does not have carries nothing, one
      // whose cell is empty carries what the model says. c in 1; 0: none. No literature range: data
      // sheets of multi-axis load cells give it for each. Of several such channels the earlier one
      // is read first.
      {.name = "cross_talk",
       .reach = Reach::reading,
       .meaning = "one force sensor also reads a part of its neighbours",
       .parameters = {{"part", "1", 0, {-0.3, 0.5}, std::nullopt}},
       .subject_kind = SubjectKind::channel,
       .subjects =
           [](const Survey& survey) {
             return survey.channels.size() > 1 ? channel_subjects(survey.channels)
                                               : std::vector<Subject>{};
           },
       .read = read_neighbours},

      // Play in its mounting, a guide that sticks.
      //
      //   reading = max(0, T - d)
      //
      // d in N; 0: none. No literature range. Above d it is an offset of -d, and wherever sensors
      // cannot read below 0 also below d: there it is called so (sensor_offset), and this is asked
      // for only where some reading is below 0.
      {.name = "dead_zone",
       .reach = Reach::reading,
       .meaning = "one force sensor reads nothing of the first newtons",
       .parameters = {{"width_N", "N", 0, {0, 10}, std::nullopt}},
       .subject_kind = SubjectKind::channel,
       .needs = &Survey::reads_below_zero,
       .reading =
           [](double tension_N, const std::vector<double>& values) {
             return values[0] == 0 ? tension_N : std::max(0.0, tension_N - values[0]);
           },
       .reads_linearly = false},

      // The sensor is unplugged, overloaded, its bridge broken.
      //
      //   reading = 0 whatever pulls    (with a gain and offset of its own: that offset)
      //
      // No size: it is so or not.
      {.name = "dead_channel",
       .reach = Reach::reading,
       .meaning = "one force sensor reads nothing whatever pulls",
       .subject_kind = SubjectKind::channel,
       .reading = [](double, const std::vector<double>&) { return 0.0; }},

      // reading = g T
      //
      // g in 1; 1: right. Literature: load cells of this size are calibrated to 1 to 5 per cent,
      // and a mounting that bends them costs more. Below 0: it is wired the other way round.
      {.name = "sensor_gain",
       .reach = Reach::reading,
       .meaning = "one force sensor has a gain error",
       .parameters = {{"gain", "1", 1, {-3, 3}, Range{0.95, 1.05}}},
       .subject_kind = SubjectKind::channel,
       .reading = [](double tension_N,
                     const std::vector<double>& values) { return values[0] * tension_N; }},

      // reading = T + b
      //
      // b in N; 0: right. No literature: a zero drifts with temperature and mounting, which is why
      // it is taken before each run.
      {.name = "sensor_offset",
       .reach = Reach::reading,
       .meaning = "one force sensor has a wrong zero",
       .parameters = {{"offset_N", "N", 0, {-20, 20}, std::nullopt}},
       .subject_kind = SubjectKind::channel,
       .reading = [](double tension_N,
                     const std::vector<double>& values) { return tension_N + values[0]; }},

      // reading = T + b s    s: the place of the reading in its file, from 0 (the first) to 1 (the
      //                      last)
      //
      // b in N over the whole file; 0: none. The clock is not asked: readings are taken as evenly
      // spread, in the order of the file. No literature: bridges and amplifiers drift as they warm.
      {.name = "drift",
       .reach = Reach::reading,
       .meaning = "the zero of one force sensor drifts from reading to reading",
       .parameters = {{"drift_N", "N", 0, {-20, 20}, std::nullopt}},
       .subject_kind = SubjectKind::channel,
       .follows = "order",
       .read =
           [](std::span<Sensor> sensors, const Conditions& conditions, const Effect& effect) {
             Sensor* own = find_sensor(sensors, *effect.subject.channel);
             if (own != nullptr) own->reading_N += effect.values[0] * conditions.order;
           }},

      // An amplifier at the end of its range, a load cell at its stop.
      //
      //   reading = T - s (T - L)  above L      reading = T  up to L
      //
      // s in 1, from 0 (all is read) to 1 (nothing beyond L): at s = 1 it is min(T, L). L in N. So
      // there is a size that vanishes where nothing is cut, which a limit alone, infinite then,
      // would not be. No literature range: the limit is that of the sensor. Asked for only of
      // channels that are seen well below their greatest reading: one that reads the same
      // throughout is at no limit, its load is the same. And only with limits among the readings:
      // below all of them the limit would be a gain and an offset.
      {.name = "saturation",
       .reach = Reach::reading,
       .meaning = "one force sensor reads less than there is above a limit",
       .parameters = {{"share", "1", 0, {0, 1}, std::nullopt, true},
                      {"limit_N", "N", std::nullopt, {1, 100}, std::nullopt}},
       .subject_kind = SubjectKind::channel,
       .subjects = [](const Survey& survey) { return channel_subjects(survey.wide_channels); },
       .reading =
           [](double tension_N, const std::vector<double>& values) {
             return tension_N - values[0] * std::max(0.0, tension_N - values[1]);
           },
       .shows_between =
           [](double least_N, double greatest_N, const Effect& effect) {
             constexpr double well_above = 0.1;
             return effect.values[1] > least_N + well_above * (greatest_N - least_N);
           },
       .reads_linearly = false},

      // Two plugs are exchanged, or two names in the logger.
      //
      //   column i has the reading of the sensor at j, and column j that of the sensor at i
      //
      // Gains, offsets and other faults are those of the sensors and travel with them. Routings
      // that have only one of the two segments are left as they are. No size: it is so or not.
      {.name = "swapped_channels",
       .reach = Reach::reading,
       .meaning = "two columns of tensions are exchanged",
       .subject_kind = SubjectKind::channels,
       .subjects = channel_pairs,
       .read =
           [](std::span<Sensor> sensors, const Conditions&, const Effect& effect) {
             Sensor* one = find_sensor(sensors, *effect.subject.channel);
             Sensor* other = find_sensor(sensors, *effect.subject.other_channel);
             if (one != nullptr && other != nullptr) std::swap(one->reading_N, other->reading_N);
           }},
  };
}

}  // namespace reeve::causes
