// The library's mechanics, grasps and states in the words of the reference model
// (reference_model.hpp), and back.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "core/grasp.hpp"
#include "core/tension/tension.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve::testing {

inline ContactName name_of(const Network& network, const TendonSpan& tendon, std::size_t k) {
  const auto [left, right] = ends_of(tendon, k);
  return {segment_name(network.segments[left]), segment_name(network.segments[right])};
}

using ExponentsByName = std::map<ContactName, double>;

inline ExponentsByName exponents_by_name(const Network& network, const Mechanics& m) {
  ExponentsByName phi;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      phi[name_of(network, tendon, k)] = m.phi[tendon.first_contact + k];
    }
  }
  return phi;
}

// Lengths and closing weights of the mechanics, under these exponents.
inline ReferenceHardware reference_hardware(const Network& network, const Mechanics& m,
                                            const ExponentsByName& phi) {
  ReferenceHardware hardware{};
  hardware.phi_override = [phi](const std::string& left, const std::string& right, double) {
    return phi.at({left, right});
  };
  std::map<std::string, double> length;
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    length[segment_name(network.segments[i])] = m.length[i];
  }
  hardware.length_override = [length](const std::string& segment, double) {
    return length.at(segment);
  };
  for (int f = 1; f <= network.fingers; ++f) {
    hardware.closing_weight[f] = m.closing[static_cast<std::size_t>(f - 1)];
  }
  return hardware;
}

// The numbers of the reference model for the contacts and segments of a network; springs and slack
// of the tendon come with `tendon`, and no override has them.
inline Mechanics mechanics_of(const Network& network, const ReferenceHardware& hardware,
                              const TendonParts& tendon = {}) {
  Hardware plain;
  plain.tube = {hardware.tube.mu, hardware.tube.angle};
  plain.bearing = {hardware.bearing.mu, hardware.bearing.angle};
  plain.sheath = {hardware.sheath.mu, hardware.sheath.angle};
  if (hardware.block) plain.block = ContactLaw{hardware.block->mu, hardware.block->angle};
  plain.strand_mm = hardware.strand_length;
  plain.motor_side_mm = hardware.motor_side_length;
  plain.hand_mm = hardware.hand_length;
  for (const auto& [segment, ratio] : hardware.spool) plain.spools.push_back({segment, ratio});
  plain.tendon = tendon;
  Mechanics m = mechanics(network, plain);
  for (const TendonSpan& span : network.tendons) {
    for (std::size_t k = 0; hardware.phi_override && k < span.contacts; ++k) {
      const std::size_t contact = span.first_contact + k;
      if (network.contacts[contact].kind == ContactKind::bar) continue;
      const auto [left, right] = name_of(network, span, k);
      m.phi[contact] = hardware.phi_override(left, right, m.phi[contact]);
      m.decay[contact] = std::exp(-m.phi[contact]);
    }
  }
  for (std::size_t i = 0; hardware.length_override && i < network.segments.size(); ++i) {
    m.length[i] = hardware.length_override(segment_name(network.segments[i]), m.length[i]);
  }
  for (const auto& [finger, weight] : hardware.closing_weight) {
    if (finger <= network.fingers) m.closing[static_cast<std::size_t>(finger) - 1] = weight;
  }
  return m;
}

inline ReferenceResult reference_tensions(const std::string& word, const Grasp& grasp,
                                          Direction direction, const ReferenceHardware& hardware) {
  const std::vector<int> held = held_fingers(grasp);
  return reference_tensions(
      word, {held.begin(), held.end()},
      direction == Direction::pull ? ReferenceDirection::pull : ReferenceDirection::release,
      hardware);
}

// The reference model gives a bar's turn as half the difference of its arms' ways.
inline double turn_of(const Network& network, const TendonSpan& tendon, std::size_t k,
                      const TensionState& state) {
  const Contact& contact = network.contacts[tendon.first_contact + k];
  const double slip = state.slip[tendon.first_contact + k];
  if (contact.kind != ContactKind::bar) return slip;
  const ArmRatio& arms = network.blocks[contact.block].arms;
  return slip * (1 + static_cast<double>(arms.left) / arms.right) / 2;
}

// The state as the reference model would tell it, for `disagreement`.
inline ReferenceResult observed(const Network& network, const Mechanics& m,
                                const TensionState& state) {
  ReferenceResult result{state.jams, state.opposed > 0, {}, {}, {}};
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    result.tension[segment_name(network.segments[i])] = state.tension[i];
  }
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = name_of(network, tendon, k);
      const std::size_t contact = tendon.first_contact + k;
      result.contacts.push_back({left, right, contact_kind_name(network.contacts[contact].kind),
                                 m.phi[contact], turn_of(network, tendon, k, state)});
    }
  }
  for (std::size_t f = 0; f < state.closing.size(); ++f) {
    result.closing[static_cast<int>(f) + 1] = state.closing[f];
  }
  return result;
}

}  // namespace reeve::testing
