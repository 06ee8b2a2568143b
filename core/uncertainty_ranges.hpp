// States how well friction is known before anything is measured: plain values to vary.
//
// Source: 0.05 to 0.20 is the literature range of Teflon on steel that the Exo-Glove II supplement
// quotes (section I). The relative half-widths are judgements: bearings differ with grease and
// load, and a sheath turns with the posture of the wearer.
#pragma once

#include "numerics/floors.hpp"

namespace reeve::core {

struct MuRange {
  double low = 0;  // friction coefficient, 1
  double high = 0;
};

struct UncertaintyRanges {
  MuRange tube_mu{0.05, 0.20};
  MuRange sheath_mu{0.05, 0.20};
  double bearing_mu_relative = 0.5;    // half-width over the value, 1
  double sheath_angle_relative = 0.2;  // half-width over the value, 1
};

}  // namespace reeve::core
