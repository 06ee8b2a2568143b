// Friction and lengths of the parts that a tendon runs through.
//
// Every contact has a friction exponent phi = mu * theta, by its kind, or overridden for one finger
// or for one contact. Lengths matter only as ratios, and only where a contact does not slide.
//
// Defaults: the paper's mu_t = mu_s = 0.18, mu_b = 0.001 and theta = pi; theta_s = 2 pi reproduces
// its tables I, II, III and VI (the paper does not print it).
#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/network.hpp"

namespace reeve {

struct ContactLaw {
  double mu = 0;         // friction coefficient, 1
  double angle_rad = 0;  // wrap angle, rad

  double exponent() const { return mu * angle_rad; }
};

struct FingerHardware {
  int finger = 0;
  std::optional<double> tip_mu;
  std::optional<double> tip_angle_rad;
  std::optional<double> sheath_mu;
  std::optional<double> sheath_angle_rad;
  std::optional<double> strand_mm;
  // Share of the tendon that this finger takes when it closes, relative to the others.
  double closing = 1;
};

// For the contact between two segments, named as in `reeve show` (T1, a, h1), in either order.
struct ContactHardware {
  std::string segment;
  std::string other_segment;
  std::optional<double> mu;
  std::optional<double> angle_rad;
};

// Of the strands that the contact names; 0 if it names none. Throws InputError on a name that is
// none.
int highest_finger(const ContactHardware& contact);

struct Hardware {
  ContactLaw tube{0.18, std::numbers::pi};
  ContactLaw bearing{0.001, std::numbers::pi};
  ContactLaw sheath{0.18, 2 * std::numbers::pi};
  double strand_mm = 100;
  double motor_side_mm = 100;
  double hand_mm = 100;
  std::vector<FingerHardware> fingers;
  std::vector<ContactHardware> contacts;
};

// Throws InputError that names the quantity, its value and its range.
void validate(const Hardware& hardware);

// A network with numbers: arrays parallel to its segments, contacts and fingers.
struct Mechanics {
  std::vector<double> length;   // segment lengths
  std::vector<double> phi;      // friction exponents of the contacts
  std::vector<double> decay;    // e^{-phi}
  std::vector<double> closing;  // closing weights of fingers 1 … n
};

// Prepared hardware: what does not depend on the routing is computed once, so that `apply` costs a
// table look-up a contact.
class MechanicsBuilder {
 public:
  explicit MechanicsBuilder(const Hardware& hardware);

  // Keeps the memory of `mechanics`.
  void apply(const Network& network, Mechanics& mechanics) const;

  // Contact overrides that name no contact of this network; as the user wrote them.
  std::vector<std::string> unmatched_contacts(const Network& network) const;

 private:
  struct ContactOverride {
    Segment a;
    Segment b;
    ContactHardware law;
  };

  const ContactLaw& law(ContactKind kind) const;
  ContactLaw law(const Contact& contact) const;
  void apply_overrides(const Network& network, Mechanics& mechanics) const;

  Hardware hardware_;
  std::array<double, 3> phi_{};
  std::array<double, 3> decay_{};
  std::vector<std::optional<FingerHardware>> by_finger_;
  std::vector<ContactOverride> by_contact_;
};

Mechanics mechanics(const Network& network, const Hardware& hardware);

}  // namespace reeve
