// The library's states against those of the reference model (support/reference_model.hpp).
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "core/tension/tension.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve::testing {

using ContactName = std::pair<std::string, std::string>;

inline ContactName name_of(const Network& network, const TendonSpan& tendon, std::size_t k) {
  const auto [left, right] = ends_of(tendon, k);
  return {segment_name(network.segments[left]), segment_name(network.segments[right])};
}

inline void expect_tensions(const Network& network, const TensionState& state,
                            const ReferenceResult& expected) {
  ASSERT_EQ(expected.tension.size(), network.segments.size());
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const std::string segment = segment_name(network.segments[i]);
    const double tension = expected.tension.at(segment);
    EXPECT_NEAR(state.tension[i], tension, 1e-6 * tension) << segment;
  }
}

// Turning a loop changes Σ phi |slip| at once in either direction, so that only one turn is least.
inline bool one_circulation_is_least(const TendonSpan& tendon, const Mechanics& m,
                                     const std::vector<double>& slip) {
  if (!tendon.closed) return true;
  double still = 0;
  double forward = 0;
  for (std::size_t k = tendon.first_contact; k < tendon.first_contact + tendon.contacts; ++k) {
    if (slip[k] == 0) {
      still += m.phi[k];
    } else {
      forward += std::copysign(m.phi[k], slip[k]);
    }
  }
  return std::abs(forward) < still - 1e-9;
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

inline void expect_slips(const Network& network, const Mechanics& m, const TensionState& state,
                         const ReferenceResult& expected) {
  std::map<ContactName, double> slip;
  for (const auto& contact : expected.contacts) slip[{contact.left, contact.right}] = contact.slip;
  for (const TendonSpan& tendon : network.tendons) {
    if (!one_circulation_is_least(tendon, m, state.slip)) continue;
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const ContactName contact = name_of(network, tendon, k);
      EXPECT_NEAR(turn_of(network, tendon, k, state), slip.at(contact), 1e-9)
          << contact.first << "-" << contact.second;
    }
  }
}

inline void expect_closings(const TensionState& state, const ReferenceResult& expected) {
  for (std::size_t f = 0; f < state.closing.size(); ++f) {
    const auto found = expected.closing.find(static_cast<int>(f) + 1);
    EXPECT_NEAR(state.closing[f], found == expected.closing.end() ? 0 : found->second, 1e-9)
        << "finger " << f + 1;
  }
}

inline void expect_state(const Network& network, const Mechanics& m, const TensionState& state,
                         const ReferenceResult& expected) {
  EXPECT_EQ(state.jams, expected.jams);
  expect_tensions(network, state, expected);
  expect_slips(network, m, state, expected);
  expect_closings(state, expected);
}

}  // namespace reeve::testing
