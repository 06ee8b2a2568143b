// The library's states in the words of the reference model (support/reference_model.hpp).
#pragma once

#include <string>
#include <utility>

#include "core/tension/tension.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve::testing {

// Left, right.
using ContactName = std::pair<std::string, std::string>;

inline ContactName name_of(const Network& network, const TendonSpan& tendon, std::size_t k) {
  const auto [left, right] = ends_of(tendon, k);
  return {segment_name(network.segments[left]), segment_name(network.segments[right])};
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
  ReferenceResult result{state.jams, {}, {}, {}};
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
