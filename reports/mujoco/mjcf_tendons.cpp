#include <fmt/format.h>

#include "reports/mujoco/mjcf_rig.hpp"

namespace reeve::reports {
namespace {

struct JointTerm {
  std::string joint;
  double factor = 1;
};

void write_sum(const std::string& name, const std::vector<JointTerm>& terms, MjcfText& out,
               const MjcfText::Attributes& spring = {}) {
  MjcfText::Attributes attributes{{"name", name}};
  attributes.insert(attributes.end(), spring.begin(), spring.end());
  out.open("fixed", attributes);
  for (const JointTerm& term : terms) {
    out.leaf("joint", {{"joint", term.joint}, {"coef", MjcfText::number(term.factor)}});
  }
  out.close();
}

std::string given_up_name(std::size_t f) { return fmt::format("given_up_{}", f + 1); }
std::string arms_name(const core::Block& block) { return "arms_of_" + block_name(block); }
std::string travel_name(const std::string& mover) { return "travel_of_" + mover; }

void write_finger_sums(const MjcfRig& rig, std::size_t f, MjcfText& out) {
  std::vector<JointTerm> terms;
  for (std::size_t j = 0; j < rig.layout.fingers[f].joints.size(); ++j) {
    terms.push_back({joint_name(f, j), rig.layout.fingers[f].joints[j].arm_mm * m_per_mm});
  }
  if (terms.empty()) return;
  write_sum(given_up_name(f), terms, out);
  write_sum(travel_name(runner_name(f)), {{runner_name(f)}}, out);
}

void write_bar_sums(const core::Block& block, MjcfText& out) {
  const std::string name = block_name(block);
  const double both = block.arms.left + block.arms.right;
  write_sum(arms_name(block),
            {{name + "_left", block.arms.left / both}, {name + "_right", block.arms.right / both}},
            out);
  write_sum(travel_name(name), {{name}}, out);
}

// A spring is as long as its end lags behind the spool.
void write_spring(const MjcfRig& rig, const RigEnd& end, MjcfText& out) {
  if (!end.spring_N_m) return;
  const Leg& leg = rig.plan.legs[end.leg];
  write_sum("spring_" + leg.name, {{mover_name(rig, leg)}, {carriage_name(leg.owner), -end.ratio}},
            out, {{"stiffness", MjcfText::number(*end.spring_N_m)}});
}

void write_spool(const MjcfRig& rig, const RigEnd& end, MjcfText& out) {
  if (end.spring_N_m) return;
  const Leg& leg = rig.plan.legs[end.leg];
  out.leaf("joint", {{"name", "spool_" + leg.name},
                     {"joint1", mover_name(rig, leg)},
                     {"joint2", carriage_name(leg.owner)},
                     {"polycoef", "0 " + MjcfText::number(end.ratio) + " 0 0 0"}});
}

void write_same(const std::string& mover, const std::string& sum, MjcfText& out) {
  out.leaf("tendon", {{"name", "geared_" + mover},
                      {"tendon1", travel_name(mover)},
                      {"tendon2", sum},
                      {"polycoef", "0 1 0 0 0"}});
}

void write_hold(const std::string& name, const std::string& joint, MjcfText& out) {
  out.leaf("joint", {{"name", name}, {"joint1", joint}, {"active", "false"}});
}

void write_finger_equalities(const MjcfRig& rig, std::size_t f, MjcfText& out) {
  const std::size_t joints = rig.layout.fingers[f].joints.size();
  if (joints == 0) return write_hold(fmt::format("hold_{}", f + 1), runner_name(f), out);
  write_same(runner_name(f), given_up_name(f), out);
  for (std::size_t j = 0; j < joints; ++j) {
    write_hold(fmt::format("hold_{}_{}", f + 1, j + 1), joint_name(f, j), out);
  }
}

}  // namespace

void write_tendons(const MjcfRig& rig, MjcfText& out) {
  out.open("tendon");
  for (std::size_t r = 0; r < rig.plan.ropes.size(); ++r) {
    out.open("spatial", {{"name", rope_name(r)}, {"width", "0.001"}});
    for (const RopePoint& at : rig.plan.ropes[r].points) {
      out.leaf("site", {{"site", site_name(rig, at)}});
    }
    out.close();
  }
  for (const RigEnd& end : rig.layout.ends) write_spring(rig, end, out);
  for (std::size_t f = 0; f < rig.layout.fingers.size(); ++f) write_finger_sums(rig, f, out);
  for (const core::Block& block : rig.network.blocks) {
    if (block.is_bar) write_bar_sums(block, out);
  }
  out.close();
}

void write_equalities(const MjcfRig& rig, MjcfText& out) {
  out.open("equality");
  for (std::size_t r = 0; r < rig.plan.ropes.size(); ++r) {
    out.leaf("tendon", {{"name", rope_name(r)}, {"tendon1", rope_name(r)}});
  }
  for (const RigEnd& end : rig.layout.ends) write_spool(rig, end, out);
  for (std::size_t f = 0; f < rig.layout.fingers.size(); ++f) write_finger_equalities(rig, f, out);
  for (const core::Block& block : rig.network.blocks) {
    if (block.is_bar) write_same(block_name(block), arms_name(block), out);
  }
  out.close();
}

}  // namespace reeve::reports
