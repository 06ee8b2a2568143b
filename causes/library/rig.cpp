#include <algorithm>

#include "causes/library/cause_row.hpp"
#include "core/contact_name.hpp"

namespace reeve::causes {
namespace {

std::vector<Subject> other_grasps(const Survey& survey) {
  // With more fingers than this, at most one is held: the sets of held fingers are too many to try.
  constexpr int all_grasps_up_to = 4;
  std::vector<Subject> subjects;
  for (const SurveyedRouting& routing : survey.routings) {
    const int fingers = routing.network->fingers;
    if (fingers == 0) continue;
    const auto grasps = fingers <= all_grasps_up_to ? all_grasps(fingers) : single_grasps(fingers);
    for (const Grasp& recorded : routing.recorded) {
      for (const WeightedGrasp& actual : grasps) {
        if (actual.grasp == recorded) continue;
        Subject& subject = subjects.emplace_back();
        subject.routing = routing.word;
        subject.recorded = recorded;
        subject.actual = actual.grasp;
      }
    }
  }
  return subjects;
}

std::vector<Subject> every_contact(const Survey& survey) {
  std::vector<Subject> subjects;
  for (const SurveyedRouting& routing : survey.routings) {
    for (std::size_t k = 0; k < routing.network->contacts.size(); ++k) {
      Subject& subject = subjects.emplace_back();
      subject.routing = routing.word;
      subject.contact = contact_name(*routing.network, k);
    }
  }
  return subjects;
}

bool is_contact_named(const Subject& subject, std::string_view name, const Survey& survey) {
  const std::size_t comma = name.rfind(',');
  if (comma == std::string_view::npos || name.substr(0, comma) != subject.routing) return false;
  return std::ranges::any_of(survey.routings, [&](const SurveyedRouting& routing) {
    return routing.word == subject.routing &&
           find_contact(*routing.network, name.substr(comma + 1)) ==
               find_contact(*routing.network, subject.contact);
  });
}

double with_loss(double motor_tension_N, Direction direction, double force_N) {
  return direction == Direction::pull ? motor_tension_N - force_N : motor_tension_N + force_N;
}

}  // namespace

std::vector<CauseRow> rig_causes() {
  return {
      // Rows recorded with one grasp were measured in another. No size: it is so or not. Every
      // recorded grasp may really have been any other of the routing, so long as something closes.
      {.name = "wrong_grasp",
       .reach = Reach::grasp,
       .meaning = "a routing was measured in another grasp than recorded",
       .subject_kind = SubjectKind::grasp,
       .subjects = other_grasps,
       .actual_grasp =
           [](const std::string& routing, Grasp recorded, const Effect& effect) {
             const Subject& subject = effect.subject;
             const bool is_it = routing == subject.routing && recorded == *subject.recorded;
             return is_it ? *subject.actual : recorded;
           }},

      // A tube pinched by its clamp, a bearing that is stuck, of one routing.
      //
      //   s_k = 0 whatever the tensions    the tendon ends there on both sides
      //                                    (core/tension/seizure.hpp)
      //
      // No size: it is so or not.
      {.name = "seized_contact",
       .reach = Reach::contact,
       .meaning = "a contact does not slide",
       .subject_kind = SubjectKind::contact,
       .subjects = every_contact,
       .is_also_named = is_contact_named,
       .seized_contact = [](const std::string& routing, const Network& network,
                            const Effect& effect) -> std::optional<std::size_t> {
         if (routing != effect.subject.routing) return std::nullopt;
         return find_contact(network, effect.subject.contact);
       }},

      // Another torque constant, another radius of the drum.
      //
      //   T_M' = g T_M    T_M: as recorded
      //
      // g in 1; 1: right. No literature range: data sheets give a tolerance for each motor. Where
      // nothing but strands beyond one sheath each is measured, pulling, it is the same as another
      // friction of the sheaths; releasing tells them apart.
      {.name = "motor_gain",
       .reach = Reach::motor,
       .meaning = "the motor pulls more or less than recorded, in proportion",
       .parameters = {{"gain", "1", 1, {0.3, 3}, std::nullopt}},
       .needs = &Survey::has_motor_tension,
       .at_tendon = [](double motor_tension_N, Direction, const Conditions&,
                       const std::vector<double>& values) { return values[0] * motor_tension_N; }},

      // A current that is not zero at rest.
      //
      //   T_M' = T_M + b, not below 0    T_M: as recorded
      //
      // b in N; 0: right. No literature range. Pulling, it is a constant loss of -b; releasing, the
      // loss turns its sign and this does not.
      {.name = "motor_offset",
       .reach = Reach::motor,
       .meaning = "the motor pulls more or less than recorded, by a constant",
       .parameters = {{"offset_N", "N", 0, {-20, 20}, std::nullopt}},
       .needs = &Survey::has_motor_tension,
       .at_tendon = [](double motor_tension_N, Direction, const Conditions&,
                       const std::vector<double>& values) { return motor_tension_N + values[0]; }},

      // Gears, seals, the guide of the carriage, whatever the transmission carries.
      //
      //   T_in = T_M - F  pulling, not below 0      T_in = T_M + F  releasing
      //
      // F in N; 0: none. No literature range: it is a matter of the drive. It lessens the pull on
      // every routing alike, so that designs are judged without it.
      {.name = "constant_loss",
       .reach = Reach::motor,
       .meaning = "the transmission takes a constant force before the tendon",
       .parameters = {{"force_N", "N", 0, {0, 20}, std::nullopt}},
       .needs = &Survey::has_motor_tension,
       .at_tendon =
           [](double motor_tension_N, Direction direction, const Conditions&,
              const std::vector<double>& values) {
             return with_loss(motor_tension_N, direction, values[0]);
           }},

      // Grease, the motor's own damping.
      //
      //   T_in = T_M - c v  pulling, not below 0      T_in = T_M + c v  releasing
      //
      // v: the carriage's speed, in mm/s; a row without speed is taken as 10 mm/s. c in N s/mm; 0:
      // none. No literature range. It lessens the pull on every routing alike, so that designs are
      // judged without it.
      {.name = "viscous_loss",
       .reach = Reach::motor,
       .meaning = "the transmission takes a force that grows with the speed",
       .parameters = {{"slope", "N s/mm", 0, {0, 0.5}, std::nullopt}},
       .follows = "speed_mm_s",
       .subjects =
           [](const Survey& survey) {
             return std::vector<Subject>(survey.has_motor_tension && survey.has_speed ? 1 : 0);
           },
       .at_tendon =
           [](double motor_tension_N, Direction direction, const Conditions& conditions,
              const std::vector<double>& values) {
             return with_loss(motor_tension_N, direction, values[0] * conditions.speed_mm_s);
           }},
  };
}

}  // namespace reeve::causes
