#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "core/motor_sides.hpp"
#include "reports/mujoco/mjcf_rig.hpp"

namespace reeve::reports {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180;
// Along x; a joint's is this times the square of its arm, so that all parts come to rest alike.
constexpr double damping_N_s_m = 10;
constexpr double carriage_kg = 0.05;
constexpr double part_kg = 0.01;
constexpr double least_phalanx_m = 0.01;
constexpr double fixed_x_m = -0.01;
constexpr double fixed_pitch_m = 0.012;

class WorldWriter {
 public:
  WorldWriter(const MjcfRig& rig, MjcfText& out) : rig_(rig), out_(out) {}

  void write() {
    out_.open("worldbody");
    eyelets();
    for (std::size_t f = 0; f < rig_.layout.fingers.size(); ++f) finger(f);
    for (int motor = 1; motor <= std::max(1, carriage_count(rig_.network)); ++motor) {
      slider(carriage_name(static_cast<std::size_t>(motor)), {carriage_x_m, 0}, {}, carriage_kg);
    }
    for (const RigEnd& end : rig_.layout.ends) {
      slider(mover_name(rig_, rig_.plan.legs[end.leg]), {carriage_x_m, 0}, {}, part_kg);
    }
    for (std::size_t b = 0; b < rig_.network.blocks.size(); ++b) block(b);
    out_.close();
  }

 private:
  void site(const std::string& name, const std::string& at) {
    out_.leaf("site", {{"name", name}, {"pos", at}, {"size", "0.002"}});
  }

  void eyelets() {
    for (std::size_t k = 0; k < rig_.plan.legs.size(); ++k) {
      const RigPlace place = eyelet_place(rig_.layout, rig_.plan, k);
      site(site_name(rig_, {PointKind::eyelet, k}), MjcfText::point(place.x_m, place.y_m));
    }
    for (std::size_t k = 0; k < rig_.plan.fixed_points; ++k) {
      site(site_name(rig_, {PointKind::fixed, k}),
           MjcfText::point(fixed_x_m, fixed_pitch_m * static_cast<double>(k)));
    }
  }

  // Its joint's positive direction is towards the motor.
  void slider(const std::string& name, RigPlace at, const MjcfText::Attributes& spring,
              double mass_kg) {
    out_.open("body", {{"name", name}, {"pos", MjcfText::point(at.x_m, at.y_m)}});
    MjcfText::Attributes joint{{"name", name},
                               {"type", "slide"},
                               {"axis", "-1 0 0"},
                               {"damping", MjcfText::number(damping_N_s_m)}};
    joint.insert(joint.end(), spring.begin(), spring.end());
    out_.leaf("joint", joint);
    out_.leaf("geom", {{"type", "sphere"}, {"size", "0.004"}, {"mass", MjcfText::number(mass_kg)}});
    for (std::size_t k = 0; k < rig_.plan.legs.size(); ++k) {
      if (mover_name(rig_, rig_.plan.legs[k]) != name) continue;
      const RigPlace place = mover_place(rig_.layout, rig_.plan, k);
      site(rig_.plan.legs[k].name, MjcfText::point(place.x_m - at.x_m, place.y_m - at.y_m));
    }
    out_.close();
  }

  void finger(std::size_t f) {
    const RigFinger& finger = rig_.layout.fingers[f];
    MjcfText::Attributes spring;
    if (finger.joints.empty()) {
      spring = {{"stiffness", MjcfText::number(finger.spring_N_m)},
                {"range", "0 " + MjcfText::number(finger.closing_m)}};
    }
    slider(runner_name(f), {finger.reach_m, finger.y_m}, spring, part_kg);
    RigPlace at{0, finger.y_m};
    for (std::size_t j = 0; j < finger.joints.size(); ++j) at = phalanx(f, j, at);
    for (std::size_t j = 0; j < finger.joints.size(); ++j) out_.close();
  }

  // Returns the place at which the next phalanx begins. The body stays open for that one.
  RigPlace phalanx(std::size_t f, std::size_t j, RigPlace at) {
    const std::vector<FingerJoint>& joints = rig_.layout.fingers[f].joints;
    const double beyond_mm = j + 1 < joints.size() ? joints[j + 1].lever_mm : 0;
    const double length_m = std::max((joints[j].lever_mm - beyond_mm) * m_per_mm, least_phalanx_m);
    out_.open("body", {{"name", fmt::format("finger_{}_phalanx_{}", f + 1, j + 1)},
                       {"pos", MjcfText::point(at.x_m, at.y_m)}});
    hinge(joint_name(f, j), joints[j]);
    out_.leaf("geom", {{"type", "capsule"},
                       {"fromto", MjcfText::point(0) + " " + MjcfText::point(length_m)},
                       {"size", "0.006"},
                       {"mass", MjcfText::number(part_kg)}});
    return {length_m, 0};
  }

  void hinge(const std::string& name, const FingerJoint& joint) {
    const double arm_m = joint.arm_mm * m_per_mm;
    out_.leaf("joint", {{"name", name},
                        {"type", "hinge"},
                        {"axis", "0 1 0"},
                        {"range", "0 " + MjcfText::number(joint.range_deg * rad_per_deg)},
                        {"stiffness", MjcfText::number(joint.spring_Nmm_rad * m_per_mm)},
                        {"springref", MjcfText::number(joint.rest_deg * rad_per_deg)},
                        {"damping", MjcfText::number(damping_N_s_m * arm_m * arm_m)}});
  }

  void block(std::size_t b) {
    const std::string name = block_name(rig_.network.blocks[b]);
    const RigPlace at{carriage_x_m / 2, rig_.layout.blocks[b].y_m};
    slider(name, at, {}, part_kg);
    if (!rig_.network.blocks[b].is_bar) return;
    slider(name + "_left", at, {}, part_kg);
    slider(name + "_right", at, {}, part_kg);
  }

  const MjcfRig& rig_;
  MjcfText& out_;
};

}  // namespace

void write_world(const MjcfRig& rig, MjcfText& out) { WorldWriter(rig, out).write(); }

}  // namespace reeve::reports
