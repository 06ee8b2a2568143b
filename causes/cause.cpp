#include "causes/cause.hpp"

#include <algorithm>
#include <cmath>

namespace reeve {

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
  return segment.kind == subject.channel->kind && segment.number == subject.channel->number;
}

double exponent_with_force(double phi, double high_N, double force_N) {
  const double kept = std::exp(-phi) * high_N - force_N;
  if (kept <= std::exp(-max_exponent) * high_N) return max_exponent;
  return std::log(high_N / kept);
}

std::string name(const Effect& effect) {
  const std::string subject = effect.cause->subject_name(effect.subject);
  return subject.empty() ? effect.cause->name() : effect.cause->name() + ("[" + subject + "]");
}

}  // namespace reeve
