// A network with numbers: what the hardware makes of each segment and contact.
//
// A spring of stiffness k in series gives way as EA/k more of its tendon would, which its
// motor-side segment gets: a tendon's compliance is Σ t_i L_i / EA + t_end / k, in multiples of 1 /
// EA. Springs decide how tendons share a carriage, and what sticks; they are as small beside the
// travel as the tendon's own stretch is (the limit of tension.hpp). The stroke of a hand has T/k
// (series_stretch.hpp).
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/contact_name.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"

namespace reeve::core {

// Exponents of a tip and of the guides of its finger, before contacts scatter and a model changes
// them. Both are 0 of a contact that is no tip.
struct GuidedTip {
  double phi = 0;     // of the tip, with those of the guides that both strands pass
  double guides = 0;  // the part of it that is of the guides
};

// Arrays parallel to the network's segments, contacts and fingers.
struct Mechanics {
  std::vector<double> length;   // segment lengths, mm
  std::vector<double> phi;      // friction exponents of the contacts
  std::vector<double> decay;    // e^{-phi}
  std::vector<double> closing;  // closing weights of fingers 1 … n
  // Spools of the segments: travel of a motor-side end over that of its carriage. Empty if all are
  // 1.
  std::vector<double> spools{};
  // Part of each length that stands for a spring in series, beside EA. Empty without springs.
  std::vector<double> springs_mm{};
  double EA_N = 0;
  std::vector<GuidedTip> guided_tips{};  // of the contacts; empty if no finger has guides
  // Slack of tendons in mm, at the first motor-side segment of each, and the carriage travel D that
  // it is a part of. Empty if no tendon has any.
  std::vector<double> slack_mm{};
  double travel_mm = 0;
  bool in_range = true;  // no exponent is beyond max_exponent

  double spool(std::size_t segment) const { return spools.empty() ? 1 : spools[segment]; }
  // The part of a contact's exponent that is of guides.
  double guides(std::size_t contact) const {
    if (guided_tips.empty() || guided_tips[contact].guides == 0) return 0;
    return phi[contact] * guided_tips[contact].guides / guided_tips[contact].phi;
  }
};

// Prepared hardware: what does not depend on the routing is computed once, so that `apply` costs a
// table look-up a contact.
class MechanicsBuilder {
 public:
  // Throws InputError of a fault of the hardware, and of a name that is no segment's.
  explicit MechanicsBuilder(Hardware hardware);

  // In place of what the hardware says of a kind but a bar, for who varies coefficients; what it
  // says of one finger or one contact stays. The law is one that there can be.
  void set_law(ContactKind kind, const ContactLaw& law);

  // Keeps the memory of `mechanics`.
  void apply(const Network& network, Mechanics& mechanics) const;

  // Returns the law of the tendon's k-th contact, whatever sets it.
  ContactLaw law_at(const Network& network, const TendonSpan& tendon, std::size_t k) const;

  // Returns the file's values for the tendon's k-th contact alone; nullptr if there are none.
  const ContactHardware* own_values(const Network& network, const TendonSpan& tendon,
                                    std::size_t k) const;

  // True if the file gives a coefficient for this contact alone, or for its finger.
  bool has_own_mu(const Network& network, const TendonSpan& tendon, std::size_t k) const;

  // Writes σ of each contact's own exponent (ContactScatter), 0 for a contact whose coefficient is
  // given. Keeps the memory of `deviations`.
  void deviations(const Network& network, std::vector<double>& deviations) const;

  // Contact overrides that no contact of this network takes; as the user wrote them. If both orders
  // of a name mean the same contact, it takes the one in walk order.
  std::vector<std::string> unmatched_contacts(const Network& network) const;

  // Spools that are of no end at a motor (M) of this network: a pulley of the carriage (P) has
  // none.
  std::vector<std::string> unmatched_spools(const Network& network) const;

  // Tendons of the hardware, by number, that this network has not, that have not one end at a motor
  // (M) where a spring is to be, or no slack to take in: nothing on a motor, or a block on them.
  std::vector<std::string> unmatched_tendons(const Network& network) const;

  // Throws OutOfRange that names the contact if an exponent is beyond max_exponent: only a contact
  // of its own can have one that the hardware's faults do not tell.
  const Mechanics& require_in_range(const Network& network, const Mechanics& mechanics) const;

 private:
  struct ContactOverride {
    ContactName name;
    ContactHardware law;
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
  void apply_tendons(const Network& network, Mechanics& mechanics) const;
  double deviation(const Network& network, const TendonSpan& tendon, std::size_t k) const;
  void close_by_excursions(Mechanics& mechanics) const;
  void add_guides(const Network& network, Mechanics& mechanics) const;
  // Returns the place of an error about the tendon's k-th contact.
  std::string place_at(const Network& network, const TendonSpan& tendon, std::size_t k) const;

  Hardware hardware_;
  std::array<double, 5> phi_{};
  std::array<double, 5> decay_{};
  std::vector<std::optional<FingerHardware>> by_finger_;
  std::vector<ContactOverride> by_contact_;
  std::vector<Spool> spools_;
  std::vector<double> excursion_;  // one per finger, 0 without joints; empty without a hand
  // Guides of fingers 1 … add this to the exponents of their tips, each passed by both strands;
  // empty without any.
  std::vector<double> guide_exponent_;
};

// "a-T1", as the user wrote it.
std::string name_of(const ContactHardware& contact);
// Throws InputError on a segment that is none.
ContactName parse_contact(const ContactHardware& contact);

// Returns the highest finger among the strands that the contact names; 0 if it names none. Throws
// InputError on a name that is none.
int highest_finger(const ContactHardware& contact);

// Returns the mechanics of valid hardware. Throws InputError or OutOfRange otherwise.
Mechanics mechanics(const Network& network, const Hardware& hardware);

}  // namespace reeve::core
