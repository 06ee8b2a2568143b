// Layout of an exported rig, and the names that the parts of the file share.
#pragma once

#include <tinyxml2.h>

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/hand.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"
#include "numerics/floors.hpp"
#include "reports/mujoco/rope_plan.hpp"

namespace reeve::reports {

// Layout of a planar rig, in metres: fingers side by side along y, each of their legs and those of
// the carriage parallel to x, blocks in lanes of their own beside them.
//
// A leg must never come to an end: each mover stands so far from its eyelets as it can travel while
// the fingers close, which is bounded by the kinematics (core/tension/kinematics.hpp): the greatest
// travel of a block for each millimetre closed in the grasps "none held" and "one finger held",
// times what all fingers can close.
struct RigFinger {
  std::vector<FingerJoint> joints;  // none: the finger is a slider with a spring
  double closing_m = 0;             // greatest length that each strand gives up
  double spring_N_m = 0;            // spring rate of a slider
  double reach_m = 0;               // from the eyelets to the runner in the open hand
  double y_m = 0;
};

struct RigBlock {
  double reach_m = 0;  // to its eyelets on either side
  double y_m = 0;
};

// An end at a motor that does not move as its carriage does.
struct RigEnd {
  std::size_t leg = 0;
  double ratio = 1;                    // of its spool
  std::optional<double> spring_N_m{};  // in series
};

struct RigLayout {
  std::vector<RigFinger> fingers;  // 1 … n, at their numbers less 1
  std::vector<RigBlock> blocks;
  std::vector<RigEnd> ends;
  double let_out_m = 0;  // greatest length that an end at a motor lets out
};

struct RigPlace {
  double x_m = 0;
  double y_m = 0;
};

inline constexpr double carriage_x_m = -0.15;

// Sets the legs of ends on their own spools or springs in the plan. Throws OutOfRange where the
// kinematics leaves blocks undetermined, InputError of bad hardware.
RigLayout rig_layout(const Network& network, const Hardware& hardware, RopePlan& plan);

// In the world, with the hand open.
RigPlace mover_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg);
RigPlace eyelet_place(const RigLayout& layout, const RopePlan& plan, std::size_t leg);

// XML by the element, with the numbers and points of MJCF.
class MjcfText {
 public:
  using Attributes = std::vector<std::pair<const char*, std::string>>;

  void open(const char* name, const Attributes& attributes = {});
  void close() { xml_.CloseElement(); }
  void leaf(const char* name, const Attributes& attributes);
  void comment(const std::string& text) { xml_.PushComment(text.c_str()); }
  std::string text() const { return xml_.CStr(); }

  static std::string number(double value);
  static std::string point(double x_m, double y_m = 0);

 private:
  tinyxml2::XMLPrinter xml_;
};

inline constexpr double m_per_mm = 1e-3;

struct MjcfRig {
  Network network;
  RopePlan plan;
  RigLayout layout;
};

// Fingers and their joints from 0, as ropes are; their names count from 1.
std::string rope_name(std::size_t rope);
std::string runner_name(std::size_t finger);
std::string joint_name(std::size_t finger, std::size_t joint);
std::string carriage_name(std::size_t motor);  // from 1
std::string mover_name(const MjcfRig& rig, const Leg& leg);
std::string site_name(const MjcfRig& rig, const RopePoint& at);

// Bodies, joints and sites.
void write_world(const MjcfRig& rig, MjcfText& out);
// Tendons, what holds their lengths, and what can hold the fingers.
void write_tendons(const MjcfRig& rig, MjcfText& out);
void write_equalities(const MjcfRig& rig, MjcfText& out);

}  // namespace reeve::reports
