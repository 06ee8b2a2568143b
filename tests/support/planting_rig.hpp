// What a rig's drive and sensors do in planted data, each by its formula:
//
//   at the tendon   T_in = g T_M + b - F - c v  pulling,  g T_M + b + F + c v  releasing, not below
//   0 at a channel    T_j + p (T_{j-1} + T_{j+1}), neighbours by the columns of the file;
//                   min(., limit); + d s, s the place of the row in the file from 0 to 1
//                   0 of a dead one; two that are exchanged read each other's
#pragma once

#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "tests/support/planting_nature.hpp"

namespace reeve::testing {

struct Drive {
  double gain = 1;
  double offset_N = 0;
  double loss_N = 0;
  double loss_Ns_mm = 0;
};

double at_tendon(const Drive& drive, const Condition& condition);

struct Electronics {
  std::map<std::string, double> part_of_neighbours, limit_N, drift_N;  // by channel
  std::set<std::string> dead;
  std::pair<std::string, std::string> exchanged;  // none: two empty names
};

// Of all segments of a row's routing. `place` of the row in its file.
void apply(const Electronics& electronics, const std::vector<std::string>& channels, double place,
           std::map<std::string, double>& tension_N);

}  // namespace reeve::testing
