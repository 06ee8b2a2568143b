#include "core/mechanics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/hand.hpp"
#include "core/routing.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::core {
namespace {

bool is_motor_side(const Network& network, std::size_t segment) {
  return network.segments[segment].kind == SegmentKind::motor_side;
}

// The tendon of that number, if the network has it.
const TendonSpan* find_tendon(const Network& network, int number) {
  const auto i = static_cast<std::size_t>(number) - 1;
  return i < network.tendons.size() ? &network.tendons[i] : nullptr;
}

// The segment at the tendon's only end at a motor, if it has just one.
std::optional<std::size_t> only_motor_end(const Network& network, const TendonSpan& tendon) {
  const std::size_t first = tendon.first_segment;
  const std::size_t last = first + tendon.segments - 1;
  if (tendon.closed || is_motor_side(network, first) == is_motor_side(network, last)) {
    return std::nullopt;
  }
  return is_motor_side(network, first) ? first : last;
}

std::optional<std::size_t> first_motor_side(const Network& network, const TendonSpan& tendon) {
  for (std::size_t i = tendon.first_segment; i < tendon.first_segment + tendon.segments; ++i) {
    if (is_motor_side(network, i)) return i;
  }
  return std::nullopt;
}

}  // namespace

std::string name_of(const ContactHardware& contact) {
  return contact.segment + "-" + contact.other_segment;
}

ContactName parse_contact(const ContactHardware& contact) {
  return {parse_segment(contact.segment), parse_segment(contact.other_segment)};
}

int highest_finger(const ContactHardware& contact) {
  const ContactName name = parse_contact(contact);
  return std::max(name.from.finger, name.to.finger);
}

MechanicsBuilder::MechanicsBuilder(Hardware hardware) : hardware_(std::move(hardware)) {
  validate(hardware_);
  for (const ContactKind kind : {ContactKind::tube, ContactKind::bearing, ContactKind::sheath,
                                 ContactKind::block, ContactKind::bar}) {
    prepare(kind);
  }
  if (!hardware_.fingers.empty()) by_finger_.resize(max_fingers + 1);
  for (const FingerHardware& finger : hardware_.fingers) {
    by_finger_[static_cast<std::size_t>(finger.finger)] = finger;
  }
  for (const ContactHardware& contact : hardware_.contacts) {
    by_contact_.push_back({parse_contact(contact), contact});
  }
  for (const SpoolHardware& spool : hardware_.spools) {
    spools_.push_back({*segment_named(spool.segment), spool.ratio});
  }
  if (const auto known = hand(hardware_)) {
    bool any_guide = false;
    for (const HandFinger& finger : known->fingers) {
      excursion_.push_back(finger.excursion_mm);
      guide_exponent_.push_back(2 * held_exponent(finger.joints));
      any_guide |= has_guides(finger.joints);
    }
    if (!any_guide) guide_exponent_.clear();
  }
}

void MechanicsBuilder::prepare(ContactKind kind) {
  const auto i = static_cast<std::size_t>(kind);
  phi_[i] = law(kind).exponent();
  decay_[i] = std::exp(-phi_[i]);
}

void MechanicsBuilder::set_law(ContactKind kind, const ContactLaw& law) {
  if (kind == ContactKind::tube) hardware_.tube = law;
  if (kind == ContactKind::bearing) hardware_.bearing = law;
  if (kind == ContactKind::sheath) hardware_.sheath = law;
  if (kind == ContactKind::block) hardware_.block = law;
  prepare(kind);
  // A sheave is like the bearings where nobody says otherwise.
  if (kind == ContactKind::bearing) prepare(ContactKind::block);
}

ContactLaw MechanicsBuilder::law(ContactKind kind) const {
  switch (kind) {
    case ContactKind::tube:
      return hardware_.tube;
    case ContactKind::bearing:
      return hardware_.bearing;
    case ContactKind::sheath:
      return hardware_.sheath;
    case ContactKind::block:
      return hardware_.block.value_or(hardware_.bearing);
    case ContactKind::bar:
      return {};
  }
  return {};
}

ContactLaw MechanicsBuilder::law(const Contact& contact) const {
  ContactLaw law = this->law(contact.kind);
  if (contact.finger == 0 || by_finger_.empty()) return law;
  const auto& finger = by_finger_[static_cast<std::size_t>(contact.finger)];
  if (!finger) return law;
  const bool tip = contact.place == ContactPlace::tip;
  law.mu = (tip ? finger->tip_mu : finger->sheath_mu).value_or(law.mu);
  law.angle_rad = (tip ? finger->tip_angle_rad : finger->sheath_angle_rad).value_or(law.angle_rad);
  return law;
}

ContactLaw MechanicsBuilder::law_at(const Network& network, const TendonSpan& tendon,
                                    std::size_t k) const {
  const Contact& contact = network.contacts[tendon.first_contact + k];
  ContactLaw law = this->law(contact);
  if (const ContactHardware* own = own_values(network, tendon, k)) {
    law.mu = own->mu.value_or(law.mu);
    law.angle_rad = own->angle_rad.value_or(law.angle_rad);
  }
  if (contact.angle.is_given()) law.angle_rad = contact.angle.radians();
  return law;
}

const ContactHardware* MechanicsBuilder::own_values(const Network& network,
                                                    const TendonSpan& tendon, std::size_t k) const {
  const ContactOverride* own =
      find_by_contact(by_contact_, network, tendon, k,
                      [](const ContactOverride& one) -> const ContactName& { return one.name; });
  return own == nullptr ? nullptr : &own->law;
}

void MechanicsBuilder::apply(const Network& network, Mechanics& mechanics) const {
  mechanics.in_range = true;
  mechanics.length.clear();
  for (const Segment& segment : network.segments) {
    mechanics.length.push_back(segment.kind == SegmentKind::strand       ? hardware_.strand_mm
                               : segment.kind == SegmentKind::motor_side ? hardware_.motor_side_mm
                                                                         : hardware_.hand_mm);
  }
  mechanics.phi.clear();
  mechanics.decay.clear();
  bool has_angles = false;
  for (const Contact& contact : network.contacts) {
    has_angles |= contact.angle.is_given();
    mechanics.phi.push_back(phi_[static_cast<std::size_t>(contact.kind)]);
    mechanics.decay.push_back(decay_[static_cast<std::size_t>(contact.kind)]);
  }
  mechanics.closing.assign(static_cast<std::size_t>(network.fingers), 1.0);
  if (has_angles || !by_finger_.empty() || !by_contact_.empty())
    apply_overrides(network, mechanics);
  mechanics.guided_tips.clear();
  if (!guide_exponent_.empty()) add_guides(network, mechanics);
  if (hardware_.contact_draw) apply_scatter(network, mechanics);
  if (!excursion_.empty()) close_by_excursions(mechanics);
  apply_spools(network, mechanics);
  apply_tendons(network, mechanics);
}

void MechanicsBuilder::apply_tendons(const Network& network, Mechanics& mechanics) const {
  mechanics.slack_mm.clear();
  mechanics.springs_mm.clear();
  for (const TendonHardware& own : hardware_.tendon.own) {
    const TendonSpan* tendon = find_tendon(network, own.tendon);
    if (tendon == nullptr) continue;
    if (const auto end = only_motor_end(network, *tendon); end && own.stiffness_N_mm) {
      mechanics.EA_N = *hardware_.tendon.EA_N;
      mechanics.springs_mm.resize(network.segments.size(), 0.0);
      mechanics.springs_mm[*end] = mechanics.EA_N / *own.stiffness_N_mm;
      mechanics.length[*end] += mechanics.springs_mm[*end];
    }
    const auto side = first_motor_side(network, *tendon);
    if (!side || own.slack_mm.value_or(0) == 0) continue;
    mechanics.slack_mm.resize(network.segments.size(), 0.0);
    mechanics.slack_mm[*side] = *own.slack_mm;
    mechanics.travel_mm = *hardware_.tendon.travel_mm;
  }
}

void MechanicsBuilder::apply_spools(const Network& network, Mechanics& mechanics) const {
  mechanics.spools.clear();
  if (spools_.empty()) return;
  mechanics.spools.assign(network.segments.size(), 1.0);
  for (const Spool& spool : spools_) {
    if (const auto end = find_motor_end(network, spool.segment)) {
      mechanics.spools[*end] = spool.ratio;
    }
  }
}

void MechanicsBuilder::add_guides(const Network& network, Mechanics& mechanics) const {
  mechanics.guided_tips.resize(network.contacts.size());
  for (std::size_t k = 0; k < network.contacts.size(); ++k) {
    const Contact& contact = network.contacts[k];
    if (contact.place != ContactPlace::tip) continue;
    const double guides = guide_exponent_[static_cast<std::size_t>(contact.finger) - 1];
    mechanics.phi[k] += guides;
    mechanics.decay[k] = std::exp(-mechanics.phi[k]);
    mechanics.guided_tips[k] = {mechanics.phi[k], guides};
    mechanics.in_range &= mechanics.phi[k] <= max_exponent;
  }
}

bool MechanicsBuilder::has_own_mu(const Network& network, const TendonSpan& tendon,
                                  std::size_t k) const {
  const Contact& contact = network.contacts[tendon.first_contact + k];
  if (contact.finger != 0 && !by_finger_.empty()) {
    const auto& finger = by_finger_[static_cast<std::size_t>(contact.finger)];
    const bool tip = contact.place == ContactPlace::tip;
    if (finger && (tip ? finger->tip_mu : finger->sheath_mu)) return true;
  }
  const ContactHardware* own = own_values(network, tendon, k);
  return own != nullptr && own->mu;
}

double MechanicsBuilder::deviation(const Network& network, const TendonSpan& tendon,
                                   std::size_t k) const {
  switch (network.contacts[tendon.first_contact + k].kind) {
    case ContactKind::tube:
    case ContactKind::sheath:
      return has_own_mu(network, tendon, k) ? 0 : hardware_.scatter.relative;
    case ContactKind::bearing:
    case ContactKind::block:
      return has_own_mu(network, tendon, k) ? 0 : hardware_.scatter.bearing_relative;
    case ContactKind::bar:
      return 0;
  }
  return 0;
}

void MechanicsBuilder::deviations(const Network& network, std::vector<double>& deviations) const {
  deviations.assign(network.contacts.size(), 0.0);
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      deviations[tendon.first_contact + k] = deviation(network, tendon, k);
    }
  }
}

void MechanicsBuilder::apply_scatter(const Network& network, Mechanics& mechanics) const {
  const auto [seed, draw] = *hardware_.contact_draw;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const std::size_t contact = tendon.first_contact + k;
      double& phi = mechanics.phi[contact];
      const double sigma = deviation(network, tendon, k);
      if (sigma == 0 || phi == 0 || phi > max_exponent) continue;
      const auto stream = streams::contact_scatter + static_cast<std::uint32_t>(contact);
      phi = std::clamp(phi * (1 + sigma * normal(seed, stream, draw)), 0.0, max_exponent);
      mechanics.decay[contact] = std::exp(-phi);
    }
  }
}

// Fingers that are to come to their ends together close by their excursions; that needs all of
// them.
void MechanicsBuilder::close_by_excursions(Mechanics& mechanics) const {
  double most = 0;
  for (std::size_t i = 0; i < mechanics.closing.size(); ++i) {
    if (excursion_[i] == 0) return;
    most = std::max(most, excursion_[i]);
  }
  for (std::size_t i = 0; i < mechanics.closing.size(); ++i) {
    mechanics.closing[i] = excursion_[i] / most;
  }
}

void MechanicsBuilder::apply_overrides(const Network& network, Mechanics& mechanics) const {
  for (const FingerHardware& finger : hardware_.fingers) {
    if (finger.finger > network.fingers) continue;
    mechanics.closing[static_cast<std::size_t>(finger.finger - 1)] = finger.closing.value_or(1);
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      if (finger.strand_mm && network.segments[i].finger == finger.finger) {
        mechanics.length[i] = *finger.strand_mm;
      }
    }
  }
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const ContactLaw law = law_at(network, tendon, k);
      const std::size_t contact = tendon.first_contact + k;
      mechanics.in_range &= law.exponent() <= max_exponent;
      mechanics.phi[contact] = law.exponent();
      mechanics.decay[contact] = std::exp(-law.exponent());
    }
  }
}

std::vector<std::string> MechanicsBuilder::unmatched_contacts(const Network& network) const {
  std::vector<std::string> unmatched;
  for (const ContactOverride& wanted : by_contact_) {
    bool found = false;
    for (const TendonSpan& tendon : network.tendons) {
      for (std::size_t k = 0; k < tendon.contacts; ++k) {
        found |= own_values(network, tendon, k) == &wanted.law;
      }
    }
    if (!found) unmatched.push_back(name_of(wanted.law));
  }
  return unmatched;
}

std::vector<std::string> MechanicsBuilder::unmatched_spools(const Network& network) const {
  std::vector<std::string> unmatched;
  for (const Spool& spool : spools_) {
    if (!find_motor_end(network, spool.segment)) unmatched.push_back(segment_name(spool.segment));
  }
  return unmatched;
}

std::vector<std::string> MechanicsBuilder::unmatched_tendons(const Network& network) const {
  std::vector<std::string> unmatched;
  for (const TendonHardware& own : hardware_.tendon.own) {
    const TendonSpan* tendon = find_tendon(network, own.tendon);
    const bool fits =
        tendon != nullptr && (!own.stiffness_N_mm || only_motor_end(network, *tendon)) &&
        (!own.slack_mm || (first_motor_side(network, *tendon) && !is_tied(network, *tendon)));
    if (!fits) unmatched.push_back(std::to_string(own.tendon));
  }
  return unmatched;
}

const Mechanics& MechanicsBuilder::require_in_range(const Network& network,
                                                    const Mechanics& mechanics) const {
  if (mechanics.in_range) return mechanics;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const double phi = mechanics.phi[tendon.first_contact + k];
      if (phi <= max_exponent) continue;
      throw OutOfRange(fmt::format("{}: {}: mu * angle = {}: expected at most {}",
                                   place_at(network, tendon, k),
                                   to_text(name_at(network, tendon, k)), phi, max_exponent));
    }
  }
  return mechanics;
}

std::string MechanicsBuilder::place_at(const Network& network, const TendonSpan& tendon,
                                       std::size_t k) const {
  const ContactHardware* own = own_values(network, tendon, k);
  return hardware_place(hardware_, own == nullptr ? "" : "contact." + name_of(*own));
}

Mechanics mechanics(const Network& network, const Hardware& hardware) {
  Mechanics result;
  const MechanicsBuilder builder(hardware);
  builder.apply(network, result);
  return builder.require_in_range(network, result);
}

}  // namespace reeve::core
