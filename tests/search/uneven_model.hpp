// A model in which no two lengths and no two laws are alike, so that one in place of another shows.
#pragma once

#include "causes/model.hpp"

namespace reeve::testing {

inline causes::Model uneven_model() {
  causes::Model model;
  model.hardware.tube = {0.07, 3.0};
  model.hardware.sheath = {0.11, 5.5};
  model.hardware.block = core::ContactLaw{0.03, 3.1};
  model.hardware.strand_mm = 83.7;
  model.hardware.motor_side_mm = 412.3;
  model.hardware.hand_mm = 21.9;
  return model;
}

}  // namespace reeve::testing
