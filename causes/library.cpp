#include "causes/library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <deque>
#include <utility>

#include "causes/library/cause_row.hpp"

namespace reeve::causes {
namespace {

bool has_contact(const Survey& survey, bool (*is_wanted)(ContactKind)) {
  return std::ranges::any_of(survey.routings, [&](const auto& routing) {
    const std::vector<Contact>& contacts = routing.network->contacts;
    return std::ranges::any_of(contacts,
                               [&](const Contact& contact) { return is_wanted(contact.kind); });
  });
}

class LibraryCause final : public Cause {
 public:
  explicit LibraryCause(CauseRow row) : row_(std::move(row)) {}

  const char* name() const override { return row_.name; }
  Reach reach() const override { return row_.reach; }
  const char* meaning() const override { return row_.meaning; }
  std::vector<Parameter> parameters(const Hardware& hardware) const override {
    std::vector<Parameter> parameters = row_.parameters;
    if (row_.law != nullptr) parameters[0].nominal = (hardware.*row_.law).mu;
    return parameters;
  }
  std::vector<Subject> subjects(const Survey& survey) const override {
    if (row_.contacts != nullptr && !has_contact(survey, row_.contacts)) return {};
    if (row_.needs != nullptr && !(survey.*row_.needs)) return {};
    if (row_.subjects != nullptr) return row_.subjects(survey);
    return row_.subject_kind == SubjectKind::channel ? channel_subjects(survey.channels)
                                                     : std::vector<Subject>(1);
  }
  SubjectKind subject_kind() const override { return row_.subject_kind; }
  bool is_also_named(const Subject& subject, std::string_view name,
                     const Survey& survey) const override {
    return row_.is_also_named != nullptr && row_.is_also_named(subject, name, survey);
  }

  const ContactLaw* law(const Hardware& hardware) const override {
    return row_.law == nullptr ? nullptr : &(hardware.*row_.law);
  }
  bool acts_at(ContactKind kind) const override {
    return row_.contacts != nullptr && row_.contacts(kind);
  }
  const char* follows() const override { return row_.follows; }
  void change_hardware(Hardware& hardware, const Effect& effect) const override {
    if (row_.law != nullptr) (hardware.*row_.law).mu = effect.values[0];
    if (row_.change_hardware != nullptr) row_.change_hardware(hardware, effect);
  }
  double exponent(double phi, const ContactLoad& contact, const Conditions& conditions,
                  const Effect& effect) const override {
    if (row_.exponent == nullptr || !row_.contacts(contact.kind)) return phi;
    return row_.exponent(phi, contact, conditions, effect.values);
  }
  Grasp actual_grasp(const std::string& routing, Grasp recorded,
                     const Effect& effect) const override {
    return row_.actual_grasp == nullptr ? recorded : row_.actual_grasp(routing, recorded, effect);
  }
  std::optional<std::size_t> seized_contact(const std::string& routing, const Network& network,
                                            const Effect& effect) const override {
    if (row_.seized_contact == nullptr) return std::nullopt;
    return row_.seized_contact(routing, network, effect);
  }
  double at_tendon(double motor_tension_N, Direction direction, const Conditions& conditions,
                   const Effect& effect) const override {
    if (row_.at_tendon == nullptr) return motor_tension_N;
    return row_.at_tendon(motor_tension_N, direction, conditions, effect.values);
  }
  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    if (row_.reading == nullptr || segment != *effect.subject.channel) return tension_N;
    return row_.reading(tension_N, effect.values);
  }
  void read(std::span<Sensor> sensors, Direction direction, const Conditions& conditions,
            const Effect& effect) const override {
    if (row_.read == nullptr) return Cause::read(sensors, direction, conditions, effect);
    row_.read(sensors, conditions, effect);
  }
  bool shows_between(double least_N, double greatest_N, const Effect& effect) const override {
    return row_.shows_between == nullptr || row_.shows_between(least_N, greatest_N, effect);
  }
  bool reads_linearly() const override { return row_.reads_linearly; }

 private:
  CauseRow row_;
};

}  // namespace

std::span<const Cause* const> cause_library() {
  static const std::vector<const Cause*> causes = [] {
    static std::deque<LibraryCause> library;
    std::vector<const Cause*> all;
    for (const auto& part : {friction_causes(), rig_causes(), sensor_causes()}) {
      for (const CauseRow& row : part) all.push_back(&library.emplace_back(row));
    }
    return all;
  }();
  return causes;
}

const Cause* find_cause(const std::string& name) {
  for (const Cause* cause : cause_library()) {
    if (cause->name() == name) return cause;
  }
  return nullptr;
}

std::vector<std::string> cause_list() {
  std::vector<std::string> names;
  for (const Cause* cause : cause_library()) names.emplace_back(cause->name());
  return names;
}

std::string cause_names() { return fmt::format("{}", fmt::join(cause_list(), ", ")); }

}  // namespace reeve::causes
