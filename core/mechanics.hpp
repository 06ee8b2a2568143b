// A network with numbers: what the hardware makes of each segment and contact.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/hardware.hpp"
#include "core/network.hpp"

namespace reeve::core {

// Arrays parallel to the network's segments, contacts and fingers.
struct Mechanics {
  std::vector<double> length;   // of the segments, mm
  std::vector<double> phi;      // friction exponents of the contacts
  std::vector<double> decay;    // e^{-phi}
  std::vector<double> closing;  // closing weights of fingers 1 … n
  // Spools of the segments: travel of a motor-side end over that of its carriage. Empty if all are
  // 1.
  std::vector<double> spools{};
  bool in_range = true;  // no exponent is beyond max_exponent

  double spool(std::size_t segment) const { return spools.empty() ? 1 : spools[segment]; }
};

// Prepared hardware: what does not depend on the routing is computed once, so that `apply` costs a
// table look-up a contact.
class MechanicsBuilder {
 public:
  // Throws InputError of a fault of the hardware, and of a name that is no segment's.
  explicit MechanicsBuilder(const Hardware& hardware);

  // In place of what the hardware says of a kind but a bar, for who varies coefficients; what it
  // says of one finger or one contact stays. The law is one that there can be.
  void set_law(ContactKind kind, const ContactLaw& law);

  // Keeps the memory of `mechanics`.
  void apply(const Network& network, Mechanics& mechanics) const;

  // Of the tendon's k-th contact, whatever sets it.
  ContactLaw law_at(const Network& network, const TendonSpan& tendon, std::size_t k) const;

  // Writes σ of each contact's own exponent (ContactScatter), 0 for a contact whose coefficient is
  // given. Keeps the memory of `deviations`.
  void deviations(const Network& network, std::vector<double>& deviations) const;

  // Contact overrides that name no contact of this network; as the user wrote them.
  std::vector<std::string> unmatched_contacts(const Network& network) const;

  // Spools that are of no end at a motor (M) of this network: a pulley of the carriage (P) has
  // none.
  std::vector<std::string> unmatched_spools(const Network& network) const;

  // Throws OutOfRange that names the contact if an exponent is beyond max_exponent: only a contact
  // of its own can have one that the hardware's faults do not tell.
  const Mechanics& require_in_range(const Network& network, const Mechanics& mechanics) const;

 private:
  struct ContactOverride {
    Segment a;
    Segment b;
    ContactHardware law;

    bool is_between(const Segment& l, const Segment& r) const {
      return (a == l && b == r) || (a == r && b == l);
    }
  };

  struct Spool {
    Segment segment;
    double ratio;
  };

  ContactLaw law(ContactKind kind) const;
  ContactLaw law(const Contact& contact) const;
  void prepare(ContactKind kind);
  void apply_overrides(const Network& network, Mechanics& mechanics) const;
  void apply_scatter(const Network& network, Mechanics& mechanics) const;
  void apply_spools(const Network& network, Mechanics& mechanics) const;
  double deviation(const Network& network, const TendonSpan& tendon, std::size_t k) const;
  // True if the file gives a coefficient for this contact alone, or for its finger.
  bool has_own_mu(const Network& network, const TendonSpan& tendon, std::size_t k) const;
  void close_by_excursions(Mechanics& mechanics) const;
  void add_guides(const Network& network, Mechanics& mechanics) const;
  // Returns the place of an error about the contact between two segments.
  std::string place_between(const Segment& left, const Segment& right) const;

  Hardware hardware_;
  std::array<double, 5> phi_{};
  std::array<double, 5> decay_{};
  std::vector<std::optional<FingerHardware>> by_finger_;
  std::vector<ContactOverride> by_contact_;
  std::vector<Spool> spools_;
  std::vector<double> excursion_;  // of fingers 1 …, 0 without joints; empty without a hand
  // Guides of fingers 1 … add this to the exponents of their tips, each passed by both strands;
  // empty without any.
  std::vector<double> guide_exponent_;
};

// "a-T1", as the user wrote it.
std::string name_of(const ContactHardware& contact);

// Of the strands that the contact names; 0 if it names none. Throws InputError on a name that is
// none.
int highest_finger(const ContactHardware& contact);

// Of hardware that is valid. Throws InputError or OutOfRange otherwise.
Mechanics mechanics(const Network& network, const Hardware& hardware);

}  // namespace reeve::core
