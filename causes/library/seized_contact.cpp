// One contact of one routing does not slide: a tube pinched by its clamp, a bearing that is stuck.
//
//   s_k = 0 whatever the tensions    the tendon ends there on both sides (core/tension/seizure.hpp)
//
// No size: it is so or not.
#include <algorithm>

#include "causes/cause.hpp"
#include "core/contact_name.hpp"

namespace reeve::causes {
namespace {

class SeizedContact final : public Cause {
 public:
  const char* name() const override { return "seized_contact"; }
  Reach reach() const override { return Reach::contact; }
  const char* meaning() const override { return "a contact does not slide"; }
  std::vector<Parameter> parameters(const Hardware&) const override { return {}; }
  std::vector<Subject> subjects(const Survey& survey) const override {
    std::vector<Subject> subjects;
    for (const SurveyedRouting& routing : survey.routings) {
      for (std::size_t k = 0; k < routing.network->contacts.size(); ++k) {
        Subject subject;
        subject.routing = routing.word;
        subject.contact = contact_name(*routing.network, k);
        subjects.push_back(subject);
      }
    }
    return subjects;
  }
  SubjectKind subject_kind() const override { return SubjectKind::contact; }
  std::string subject_name(const Subject& subject) const override {
    return subject.routing + "," + subject.contact;
  }
  bool is_also_named(const Subject& subject, std::string_view name,
                     const Survey& survey) const override {
    const std::size_t comma = name.rfind(',');
    if (comma == std::string_view::npos || name.substr(0, comma) != subject.routing) return false;
    return std::any_of(survey.routings.begin(), survey.routings.end(),
                       [&](const SurveyedRouting& routing) {
                         return routing.word == subject.routing &&
                                find_contact(*routing.network, name.substr(comma + 1)) ==
                                    find_contact(*routing.network, subject.contact);
                       });
  }
  std::optional<std::size_t> seized_contact(const std::string& routing, const Network& network,
                                            const Effect& effect) const override {
    if (routing != effect.subject.routing) return std::nullopt;
    return find_contact(network, effect.subject.contact);
  }
};

}  // namespace

const Cause& seized_contact_cause() {
  static const SeizedContact cause;
  return cause;
}

}  // namespace reeve::causes
