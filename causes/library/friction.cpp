#include <algorithm>
#include <cmath>
#include <set>

#include "causes/library/cause_row.hpp"

namespace reeve::causes {
namespace {

bool is_tube(ContactKind kind) { return kind == ContactKind::tube; }
bool is_sheath(ContactKind kind) { return kind == ContactKind::sheath; }

// The fingers that a sheath leads to.
std::vector<Subject> fingers_with_sheaths(const Survey& survey) {
  std::set<int> fingers;
  for (const SurveyedRouting& routing : survey.routings) {
    for (const Contact& contact : routing.network->contacts) {
      if (is_sheath(contact.kind) && contact.finger > 0) fingers.insert(contact.finger);
    }
  }
  std::vector<Subject> subjects;
  for (const int finger : fingers) subjects.emplace_back().finger = finger;
  return subjects;
}

FingerHardware& entry(Hardware& hardware, int number) {
  for (FingerHardware& finger : hardware.fingers) {
    if (finger.finger == number) return finger;
  }
  hardware.fingers.emplace_back().finger = number;
  return hardware.fingers.back();
}

double with_force(double phi, const ContactLoad& contact, const Conditions&,
                  const std::vector<double>& values) {
  return exponent_with_force(phi, contact.high_N, values[0]);
}

}  // namespace

std::vector<CauseRow> friction_causes() {
  return {
      // phi = mu theta, mu free    (coefficients given for one finger or contact stay)
      //
      // mu in 1. Literature: 0.05 to 0.20 for Teflon on steel (Exo-Glove II
      // supplement, section I; its own tension test ends at 0.09 instead of 0.18).
      {.name = "tube_friction",
       .meaning = "the friction coefficient of the tubes differs from the nominal one",
       .parameters = {{"mu", "1", 0, {0, 0.6}, Range{0.05, 0.20}}},
       .contacts = is_tube,
       .law = &Hardware::tube},

      // The same law and literature as of the tubes.
      {.name = "sheath_friction",
       .meaning = "the friction coefficient of the sheaths differs from the nominal one",
       .parameters = {{"mu", "1", 0, {0, 0.6}, Range{0.05, 0.20}}},
       .contacts = is_sheath,
       .law = &Hardware::sheath},

      // The same law. Literature: 0.001 to 0.005 for ball and needle bearings
      // (makers' catalogues quote 0.001 to 0.0018 for deep-groove ball bearings).
      {.name = "bearing_friction",
       .meaning = "the friction coefficient of the bearings differs from the nominal one",
       .parameters = {{"mu", "1", 0, {0, 0.4}, Range{0.001, 0.005}}},
       .contacts = is_bearing,
       .law = &Hardware::bearing},

      // Polymers yield, and the true area of contact grows more slowly than the load.
      //
      //   phi' = phi (T_high / 10 N)^(-gamma)    T_high: the larger tension beside the contact
      //
      // gamma in 1; 0: Coulomb. It is n = 1 - gamma in Howell's law of friction f = a N^n for
      // fibres and cables. Literature: n from 0.8 to 1 for polymers, 0.85 for PTFE, so gamma from
      // 0 to 0.2. Below T_high = 1 mN the tension is taken as 1 mN: there is nothing to measure.
      // Source of the law: H. G. Howell, J. Text. Inst. 44 (1953); J. H. Jung, N. Pan, T. J. Kang,
      // Mech. Mach. Theory 43 (2008), in the capstan equation.
      {.name = "load_dependent_friction",
       .reach = Reach::load,
       .meaning = "friction of tubes and sheaths falls with the load",
       .parameters = {{"exponent", "1", 0, {-0.3, 0.7}, Range{0, 0.2}}},
       .contacts = is_tube_or_sheath,
       .follows = "load",
       .exponent =
           [](double phi, const ContactLoad& contact, const Conditions&,
              const std::vector<double>& values) {
             return phi * std::pow(std::max(contact.high_N, 1e-3) / 10, -values[0]);
           }},

      // The carriage's speed v stands for the sliding speed.
      //
      //   phi' = phi (1 + beta ln(v / 10 mm/s)), not below 0
      //
      // beta in 1; 0: no dependence. Literature: PTFE's friction rises with speed, by some 2 to 15
      // per cent for each factor e between 1 and 100 mm/s (K. G. McLaren, D. Tabor, Nature 197,
      // 1963, for the rise and its order of magnitude). A row without speed is taken as 10 mm/s,
      // and one below 0.01 mm/s as 0.01 mm/s.
      {.name = "speed_dependent_friction",
       .reach = Reach::conditions,
       .meaning = "friction of tubes and sheaths changes with the speed",
       .parameters = {{"slope", "1", 0, {-0.25, 0.5}, Range{0, 0.15}}},
       .contacts = is_tube_or_sheath,
       .needs = &Survey::has_speed,
       .follows = "speed_mm_s",
       .exponent =
           [](double phi, const ContactLoad&, const Conditions& conditions,
              const std::vector<double>& values) {
             const double speed = std::max(conditions.speed_mm_s, 0.01);
             return phi * std::max(0.0, 1 + values[0] * std::log(speed / 10));
           }},

      // N: number of loading cycles.
      //
      //   phi' = phi (1 + beta (1 - e^{-N / N_0})), not below 0
      //
      // beta in 1; 0: none, negative: the liner runs in. N_0 in cycles, from 10 to 10^5.
      // Literature: a transfer film of PTFE forms in tens to thousands of cycles and lowers
      // friction by up to a half (order of magnitude; liners differ). A row without cycle is taken
      // as new.
      {.name = "wear",
       .reach = Reach::conditions,
       .meaning = "friction of tubes and sheaths runs in (or out) with the cycles",
       .parameters = {{"change", "1", 0, {-1, 2}, Range{-0.5, 0.5}},
                      {"cycles", "1", std::nullopt, {10, 1e5}, Range{10, 1e4}}},
       .contacts = is_tube_or_sheath,
       .needs = &Survey::has_cycle,
       .follows = "cycle",
       .exponent =
           [](double phi, const ContactLoad&, const Conditions& conditions,
              const std::vector<double>& values) {
             const double worn = 1 - std::exp(-conditions.cycle / values[1]);
             return phi * std::max(0.0, 1 + values[0] * worn);
           }},

      // phi' = phi (1 - k (temperature - 20 C)), not below 0
      //
      // k in 1/K; 0: no dependence, positive: warm liners slide better. Literature: PTFE's friction
      // falls as it warms, by up to about 1 per cent for each kelvin (order of magnitude;
      // D. L. Burris, S. S. Perry, W. G. Sawyer, Tribol. Lett. 27, 2007, for the dependence). A row
      // without temperature is taken as 20 C.
      {.name = "temperature",
       .reach = Reach::conditions,
       .meaning = "friction of tubes and sheaths changes with the temperature",
       .parameters = {{"slope", "1/K", 0, {-0.02, 0.03}, Range{0, 0.01}}},
       .contacts = is_tube_or_sheath,
       .needs = &Survey::has_temperature,
       .follows = "temperature_C",
       .exponent =
           [](double phi, const ContactLoad&, const Conditions& conditions,
              const std::vector<double>& values) {
             return phi * std::max(0.0, 1 - values[0] * (conditions.temperature_C - 20));
           }},

      // The tendon's entry and exit, a pulley whose own bearing turns with it.
      //
      //   phi' = phi + c    at each sheath, not below 0
      //
      // c in 1; 0: a loss by the wrap alone. No literature range; of one flat belt on a pulley,
      // laps of 45 to 180 degrees, ln(T1/T2) = 0.43 + 0.099 theta. At a single angle it is another
      // friction coefficient, so that it is asked for only where rows say their sheath angle, and
      // not the same one.
      {.name = "wrap_free_loss",
       .reach = Reach::conditions,
       .meaning = "each sheath loses a part that does not depend on its angle",
       .parameters = {{"exponent", "1", 0, {-0.5, 2}, std::nullopt}},
       .contacts = is_sheath,
       .needs = &Survey::sheath_angle_varies,
       .follows = "sheath_angle_rad",
       .exponent =
           [](double phi, const ContactLoad&, const Conditions&,
              const std::vector<double>& values) { return std::max(0.0, phi + values[0]); }},

      // Pulling and releasing differ by more than the capstan law says.
      //
      //   phi' = phi (1 + h)    releasing; pulling, phi' = phi
      //
      // h in 1; 0: the same both ways, positive: releasing holds more. It stands for presliding,
      // creep and whatever else remembers the direction, and says nothing of how one goes over into
      // the other. No literature range for tendons; climbing ropes raised and lowered over bars
      // have h from 0.3 to 4 (75 kg over bars of 10 to 60 mm: raising times lowering is 46 to 70 kg
      // squared, where one friction both ways would make it 75 squared).
      {.name = "hysteresis",
       .reach = Reach::conditions,
       .meaning = "friction of tubes and sheaths differs when releasing",
       .parameters = {{"change", "1", 0, {-0.9, 4}, std::nullopt}},
       .contacts = is_tube_or_sheath,
       .needs = &Survey::has_both_directions,
       .exponent =
           [](double phi, const ContactLoad& contact, const Conditions&,
              const std::vector<double>& values) {
             return contact.direction == Direction::release ? phi * (1 + values[0]) : phi;
           }},

      // A tendon that resists bending loses a force wherever it is bent and straightened.
      //
      //   T_low = T_high e^{-phi} - F_b    at each tube and sheath, not below 0
      //
      // At one that does not slide, the cone is as much wider. F_b in N; 0: a perfectly soft
      // tendon. Literature: rope rigidity, some tenths of a newton for cords of 0.5 to 1 mm at
      // bends of some centimetres (order of magnitude; it grows with the square of the diameter).
      // Source of the idea: J. H. Jung, N. Pan, T. J. Kang, Mech. Mach. Theory 43 (2008).
      {.name = "bending_stiffness",
       .reach = Reach::load,
       .meaning = "each tube and sheath takes a further constant force",
       .parameters = {{"force_N", "N", 0, {0, 5}, Range{0, 1}}},
       .contacts = is_tube_or_sheath,
       .exponent = with_force},

      // Seals and grease; the force does not depend on the load.
      //
      //   T_low = T_high e^{-phi} - F_d    at each bearing, not below 0
      //
      // At one that does not turn, the cone is as much wider. F_d in N; 0: none. Literature: some
      // tenths of a newton at the rim of a small sealed or greased ball bearing (order of
      // magnitude).
      {.name = "bearing_drag",
       .reach = Reach::load,
       .meaning = "each bearing takes a further constant force",
       .parameters = {{"force_N", "N", 0, {0, 5}, Range{0, 1}}},
       .contacts = is_bearing,
       .exponent = with_force},

      // The wearer's posture.
      //
      //   theta' = theta + dtheta, not below 0, for the sheaths at the strands of finger f
      //
      // dtheta in rad; 0: as the hardware says. Literature: a hand and wrist in use bend a Bowden
      // cable by up to about 1.5 rad more or less (a bend of 90 degrees).
      {.name = "sheath_angle",
       .meaning = "the sheaths of one finger turn by another angle",
       .parameters = {{"angle_rad", "rad", 0, {-6, 12}, Range{-1.5, 1.5}}},
       .subject_kind = SubjectKind::finger,
       .contacts = is_sheath,
       .subjects = fingers_with_sheaths,
       .change_hardware =
           [](Hardware& hardware, const Effect& effect) {
             FingerHardware& finger = entry(hardware, effect.subject.finger);
             finger.sheath_angle_rad =
                 std::max(0.0, finger.sheath_angle_rad.value_or(hardware.sheath.angle_rad) +
                                   effect.values[0]);
           }},
  };
}

}  // namespace reeve::causes
