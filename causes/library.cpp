#include "causes/library.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>

// A new cause is a file that defines `const Cause& <name>_cause()`, and a line here. Forces come
// behind what scales an exponent; what a sensor's bridge does before what its amplifier does, and
// the plugs last.
#define REEVE_CAUSES(X)       \
  X(tube_friction)            \
  X(sheath_friction)          \
  X(bearing_friction)         \
  X(load_dependent_friction)  \
  X(speed_dependent_friction) \
  X(wear)                     \
  X(temperature)              \
  X(wrap_free_loss)           \
  X(hysteresis)               \
  X(bending_stiffness)        \
  X(bearing_drag)             \
  X(sheath_angle)             \
  X(wrong_grasp)              \
  X(seized_contact)           \
  X(motor_gain)               \
  X(motor_offset)             \
  X(constant_loss)            \
  X(viscous_loss)             \
  X(pretension)               \
  X(cross_talk)               \
  X(dead_zone)                \
  X(dead_channel)             \
  X(sensor_gain)              \
  X(sensor_offset)            \
  X(drift)                    \
  X(saturation)               \
  X(swapped_channels)

namespace reeve::causes {

#define REEVE_DECLARE(name) const Cause& name##_cause();
REEVE_CAUSES(REEVE_DECLARE)
#undef REEVE_DECLARE

std::span<const Cause* const> cause_library() {
#define REEVE_LIST(name) &name##_cause(),
  static const std::array causes = {REEVE_CAUSES(REEVE_LIST)};
#undef REEVE_LIST
  return causes;
}

const Cause* find_cause(const std::string& name) {
  for (const Cause* cause : cause_library()) {
    if (cause->name() == name) return cause;
  }
  return nullptr;
}

std::vector<std::string> cause_list() {
  std::vector<std::string> names;
  for (const Cause* cause : cause_library()) names.emplace_back(cause->name());
  return names;
}

std::string cause_names() { return fmt::format("{}", fmt::join(cause_list(), ", ")); }

}  // namespace reeve::causes
