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

bool has_contact(const Survey& survey, ContactKind kind) {
  return std::any_of(survey.routings.begin(), survey.routings.end(), [&](const auto& routing) {
    const std::vector<Contact>& contacts = routing.network->contacts;
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact& contact) { return contact.kind == kind; });
  });
}

std::vector<Subject> channel_subjects(const std::vector<Segment>& channels) {
  std::vector<Subject> subjects;
  for (const Segment& channel : channels) {
    Subject subject;
    subject.channel = channel;
    subjects.push_back(subject);
  }
  return subjects;
}

std::vector<Subject> channel_pair_subjects(const Survey& survey) {
  constexpr std::size_t most_channels = 16;
  const std::vector<Segment>& channels = survey.channels;
  if (channels.size() > most_channels) return {};
  const auto met = [&](const Segment& a, const Segment& b) {
    return std::any_of(survey.routings.begin(), survey.routings.end(), [&](const auto& routing) {
      return find_segment(*routing.network, a) && find_segment(*routing.network, b);
    });
  };
  std::vector<Subject> subjects;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    for (std::size_t j = i + 1; j < channels.size(); ++j) {
      if (!met(channels[i], channels[j])) continue;
      Subject subject;
      subject.channel = channels[i];
      subject.other_channel = channels[j];
      subjects.push_back(subject);
    }
  }
  return subjects;
}

Sensor* find_sensor(std::span<Sensor> sensors, const Segment& segment) {
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const Sensor& sensor) { return sensor.segment == segment; });
  return found == sensors.end() ? nullptr : &*found;
}

bool is_channel(const Segment& segment, const Subject& subject) {
  return segment == *subject.channel;
}

void Cause::read(std::span<Sensor> sensors, const Conditions&, const Effect& effect) const {
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
