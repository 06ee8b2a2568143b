// Words of random mechanisms with floating blocks, and hardware for the reference model, for tests.
#pragma once

#include <string>

#include "tests/support/random_routing.hpp"
#include "tests/support/reference_model.hpp"

namespace reeve::testing {

struct MechanismRange {
  int most_fingers = 5;
  int most_blocks = 4;
  double tackles = 0.4;  // the share of tackles, against trees
  double further = 0.2;  // the chance of one more tree on the same carriage
};

// A word in which every block has a tail and a pass or becket, no block hangs on itself, every tree
// is actuated, can be taut with any friction, and with all fingers free the
// reference model takes the motion as determined.
//
//   trees    blocks join tendons without a ring; loops, bars with any ratio, anchored tips, tubes,
//            bearings and pulleys on the carriage anywhere, motors above and below a block;
//            sometimes a further pass or a becket of a block
//   tackles  several passes and beckets of several blocks, each on tendons before that of its tail
//
// Fingers are 1 ... n and blocks 1 ... k, in no order; the word need not be canonical.
std::string random_mechanism(Dice& dice, const MechanismRange& range = {});

// Laws, lengths and closing weights at random, and each contact and segment sometimes with its own.
ReferenceHardware random_reference_hardware(Dice& dice, const std::string& word);

}  // namespace reeve::testing
