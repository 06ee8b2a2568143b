// The model's tensions for each reading, at T_M = 1. Readings of one routing, grasp, direction and
// sheath angle share one solution.
#pragma once

#include <map>
#include <optional>
#include <tuple>

#include "core/hardware.hpp"
#include "core/mechanics.hpp"
#include "core/tension/tension.hpp"
#include "diagnosis/data/measured_data.hpp"

namespace reeve {

// With this wrap angle at every sheath, over what the hardware says of a finger or a contact.
Hardware with_sheath_angle(Hardware hardware, double angle_rad);

class Predictor {
 public:
  // Both are kept by reference.
  Predictor(const MeasuredData& data, const Hardware& hardware)
      : data_(data), hardware_(hardware) {}

  // Of one of the data's readings. Throws InputError that names its line.
  const TensionState& at(const Reading& reading);

 private:
  using Key = std::tuple<std::size_t, std::uint64_t, Direction, std::optional<double>>;

  TensionState solve(const Reading& reading);

  const MeasuredData& data_;
  const Hardware& hardware_;
  TensionSolver solver_;
  std::map<Key, TensionState> solved_;
};

}  // namespace reeve
