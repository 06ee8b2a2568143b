#include "causes/cause.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::causes {
namespace {

// True if both subjects have the same channels, in either order.
bool are_same_channels(const Subject& a, const Subject& b) {
  return (a.channel == b.channel && a.other_channel == b.other_channel) ||
         (a.channel == b.other_channel && a.other_channel == b.channel);
}

}  // namespace

bool is_force(const Parameter& parameter) { return parameter.unit[0] == 'N'; }

Range valid_range(const Parameter& parameter) {
  constexpr double greatest = 1000;
  const auto [low, high] = parameter.range;
  if (!is_force(parameter)) return parameter.range;
  return {low > 0 ? low / greatest : low * greatest, high * greatest};
}

std::vector<Subject> channel_subjects(const std::vector<Segment>& channels) {
  std::vector<Subject> subjects;
  for (const Segment& channel : channels) subjects.emplace_back().channel = channel;
  return subjects;
}

Sensor* find_sensor(std::span<Sensor> sensors, const Segment& segment) {
  const auto found = std::ranges::find(sensors, segment, &Sensor::segment);
  return found == sensors.end() ? nullptr : &*found;
}

std::string Cause::subject_name(const Subject& subject) const {
  switch (subject_kind()) {
    case SubjectKind::rig:
      return "";
    case SubjectKind::channel:
      return segment_name(*subject.channel);
    case SubjectKind::channels:
      return segment_name(*subject.channel) + "," + segment_name(*subject.other_channel);
    case SubjectKind::finger:
      return std::to_string(subject.finger);
    case SubjectKind::grasp:
      return subject.routing;
    case SubjectKind::contact:
      return subject.routing + "," + subject.contact;
  }
  return "";
}

void Cause::read(std::span<Sensor> sensors, Direction, const Conditions&,
                 const Effect& effect) const {
  for (Sensor& sensor : sensors) {
    sensor.reading_N = reading(sensor.reading_N, sensor.segment, effect);
  }
}

double exponent_with_force(double phi, double high_N, double force_N) {
  if (force_N == 0) return phi;
  const double kept = std::exp(-phi) * high_N - force_N;
  if (kept <= std::exp(-max_exponent) * high_N) return max_exponent;
  return std::log(high_N / kept);
}

std::string effect_name(const Effect& effect) {
  const std::string subject = effect.cause->subject_name(effect.subject);
  return subject.empty() ? effect.cause->name() : effect.cause->name() + ("[" + subject + "]");
}

bool is_about_the_same(const Effect& a, const Effect& b) {
  if (a.cause != b.cause || !are_same_channels(a.subject, b.subject)) return false;
  return a.subject.finger == b.subject.finger && a.subject.routing == b.subject.routing &&
         a.subject.contact == b.subject.contact && a.subject.recorded == b.subject.recorded;
}

}  // namespace reeve::causes
