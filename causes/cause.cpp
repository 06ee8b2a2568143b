#include "causes/cause.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::causes {

bool has_contact(const Survey& survey, ContactKind kind) {
  return std::any_of(survey.routings.begin(), survey.routings.end(), [&](const auto& routing) {
    const std::vector<Contact>& contacts = routing.network->contacts;
    return std::any_of(contacts.begin(), contacts.end(),
                       [&](const Contact& contact) { return contact.kind == kind; });
  });
}

std::vector<Subject> channel_subjects(const Survey& survey) {
  std::vector<Subject> subjects;
  for (const Segment& channel : survey.channels) {
    Subject subject;
    subject.channel = channel;
    subjects.push_back(subject);
  }
  return subjects;
}

bool is_channel(const Segment& segment, const Subject& subject) {
  return segment == *subject.channel;
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
  if (a.cause != b.cause || a.subject.channel.has_value() != b.subject.channel.has_value() ||
      (a.subject.channel && !is_channel(*a.subject.channel, b.subject))) {
    return false;
  }
  return a.subject.finger == b.subject.finger && a.subject.routing == b.subject.routing &&
         a.subject.contact == b.subject.contact && a.subject.recorded == b.subject.recorded;
}

}  // namespace reeve::causes
