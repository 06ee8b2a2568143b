// What the parts of an exported file are about, and the names that they share.
#pragma once

#include <cstddef>
#include <string>

#include "core/network.hpp"
#include "reports/mujoco/mjcf_text.hpp"
#include "reports/mujoco/rig_layout.hpp"
#include "reports/mujoco/rope_plan.hpp"

namespace reeve::reports {

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
std::string mover_name(const MjcfRig& rig, const Leg& leg);
std::string site_name(const MjcfRig& rig, const RopePoint& at);

// Bodies, joints and sites.
void write_world(const MjcfRig& rig, MjcfText& out);
// Tendons, what holds their lengths, and what can hold the fingers.
void write_tendons(const MjcfRig& rig, MjcfText& out);
void write_equalities(const MjcfRig& rig, MjcfText& out);

}  // namespace reeve::reports
