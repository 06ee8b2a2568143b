#include "core/finger_closing.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "numerics/random.hpp"

namespace reeve {
namespace {

FingerJoint joint_of(double arm_mm, double spring_Nmm_rad, double mu = 0, double wrap_deg = 0) {
  FingerJoint joint{arm_mm, 90, 50, spring_Nmm_rad};
  joint.guide = JointGuide::tube;
  joint.mu = mu;
  joint.wrap_deg = wrap_deg;
  return joint;
}

// A finger of 1 to 4 joints with springs, guides and stops drawn at random.
std::vector<FingerJoint> random_finger(std::uint64_t seed) {
  std::uint32_t stream = 0;
  const auto draw = [&](double low, double high) {
    return low + (high - low) * uniform(seed, ++stream, 0);
  };
  std::vector<FingerJoint> joints(1 + static_cast<std::size_t>(draw(0, 3.999)));
  for (FingerJoint& joint : joints) {
    joint = joint_of(draw(4, 12), draw(5, 60), draw(0, 0.2), draw(0, 45));
    joint.range_deg = draw(30, 100);
    joint.rest_deg = draw(-40, 0);
    if (draw(0, 1) < 0.3) joint.object_deg = draw(0.2, 0.9) * joint.range_deg;
  }
  return joints;
}

// Moves a finger in small steps of excursion, each to the least of spring energy + friction work
// under Σ r_j q_j = x, with the friction forces of the tensions at that least (tests alone).
class EnergyFinger {
 public:
  explicit EnergyFinger(const std::vector<FingerJoint>& joints)
      : joints_(joints), flexion_(joints.size(), 0.0), friction_(joints.size(), 0.0) {}

  void move_to(double excursion) {
    // The friction at guide j is T_{j-1} − T_j = T_{j-1} (1 − e^{−phi_j}), in this posture.
    for (int i = 0; i < 200; ++i) {
      minimise(excursion);
      double tension = pull_;
      double change = 0;
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        const double phi = *joints_[j].mu * (in_rad(joints_[j].wrap_deg) + flexion_[j]);
        const double friction = tension * (1 - std::exp(-phi));
        change = std::max(change, std::abs(friction - friction_[j]));
        friction_[j] = friction;
        tension -= friction;
      }
      if (change < 1e-12 * pull_) break;
    }
  }

  const std::vector<double>& flexion() const { return flexion_; }
  double pull() const { return pull_; }

 private:
  // Least of Σ ½ k (q − q0)² + Σ_j F_j s_j, s_j = Σ_{k ≥ j} r_k (q_k − before), with the pull as
  // the multiplier of the excursion.
  void minimise(double excursion) {
    double low = 0;
    double high = 1e4;
    for (int i = 0; i < 60; ++i) {
      pull_ = (low + high) / 2;
      double reached = 0;
      double lost = 0;
      for (std::size_t j = 0; j < joints_.size(); ++j) {
        const FingerJoint& joint = joints_[j];
        lost += friction_[j];
        const double least =
            in_rad(joint.rest_deg) + joint.arm_mm * (pull_ - lost) / joint.spring_Nmm_rad;
        const double stop = in_rad(joint.stop_deg());
        flexion_[j] = std::clamp(least, 0.0, stop);
        reached += joint.arm_mm * flexion_[j];
      }
      (reached < excursion ? low : high) = pull_;
    }
  }

  const std::vector<FingerJoint>& joints_;
  std::vector<double> flexion_;
  std::vector<double> friction_;
  double pull_ = 0;
};

TEST(FingerClosing, OfOneJointIsTheSpringsTorqueOverTheArm) {
  const std::vector<FingerJoint> joints{joint_of(10, 30)};
  const FingerPosture posture = closing_posture(joints, 10 * 0.7);
  EXPECT_NEAR(posture.flexion_rad[0], 0.7, 1e-12);
  EXPECT_NEAR(posture.pull_N, 30 * 0.7 / 10, 1e-11);
}

TEST(FingerClosing, WithoutFrictionSharesTheExcursionByArmOverStiffness) {
  const std::vector<FingerJoint> joints{joint_of(10, 30), joint_of(8, 20)};
  const FingerPosture posture = closing_posture(joints, 9);
  EXPECT_NEAR(posture.flexion_rad[0] / posture.flexion_rad[1], (10.0 / 30) / (8.0 / 20), 1e-11);
}

TEST(FingerClosing, LosesTensionAtEachGuideByItsWrapAndFlexion) {
  const std::vector<FingerJoint> joints{joint_of(10, 30, 0.15, 20), joint_of(10, 30, 0.15, 10)};
  const FingerPosture posture = closing_posture(joints, 12);
  const double second = 0.15 * (in_rad(10) + posture.flexion_rad[1]);
  EXPECT_NEAR(posture.tension_N[1] / posture.tension_N[0], std::exp(-second), 1e-12);
  EXPECT_NEAR(posture.flexion_rad[1] / posture.flexion_rad[0], std::exp(-second), 1e-11);
  EXPECT_GT(posture.pull_N, posture.tension_N[0]);
}

TEST(FingerClosing, MovesJointsWithoutSpringsFirst) {
  const std::vector<FingerJoint> joints{joint_of(10, 30), joint_of(8, 0)};
  const FingerPosture early = closing_posture(joints, 6);
  EXPECT_NEAR(early.flexion_rad[1], 6.0 / 8, 1e-6);
  const FingerPosture late = closing_posture(joints, 8 * in_rad(90) + 5);
  EXPECT_NEAR(late.flexion_rad[0], 0.5, 1e-9);
  const FingerClosing closing = close_finger(joints, 4);
  EXPECT_EQ(closing.stops[0].joint, 1U);
  EXPECT_EQ(closing.stops[1].joint, 0U);
}

TEST(FingerClosing, LeavesTheTendonSlackUpToThePostureOfItsSprings) {
  std::vector<FingerJoint> joints{joint_of(10, 30)};
  joints[0].rest_deg = 40;
  EXPECT_EQ(closing_posture(joints, 5).pull_N, 0);
  EXPECT_NEAR(closing_posture(joints, 10).pull_N, 30 * (1 - in_rad(40)) / 10, 1e-11);
}

TEST(FingerClosing, BendsTheOtherJointsWhereAnObjectStopsOne) {
  std::vector<FingerJoint> joints{joint_of(10, 30), joint_of(10, 30)};
  joints[0].object_deg = 20;
  joints[0].phalanx_mm = 40;
  joints[1].phalanx_mm = 30;
  const FingerPosture posture = closing_posture(joints, 12);
  EXPECT_NEAR(posture.flexion_rad[0], in_rad(20), 1e-12);
  EXPECT_NEAR(posture.flexion_rad[1], 1.2 - in_rad(20), 1e-12);
  const double torque = 30 * (posture.flexion_rad[1] - posture.flexion_rad[0]);
  EXPECT_NEAR(posture.object_Nmm[0], torque, 1e-9);
  EXPECT_NEAR(posture.contact_N[0], torque / 20, 1e-10);
  EXPECT_EQ(posture.contact_N[1], 0);
}

// A force at phalanx 2 loads joint 1 by the lever 40 cos q2 + 15.
TEST(FingerClosing, SharesContactForcesAmongTouchedPhalanges) {
  std::vector<FingerJoint> joints{joint_of(10, 5), joint_of(10, 5)};
  joints[0].object_deg = 20;
  joints[1].object_deg = 60;
  joints[0].phalanx_mm = 40;
  joints[1].phalanx_mm = 30;
  joints.push_back(joint_of(5, 60));
  joints[2].phalanx_mm = 20;
  const FingerPosture posture = closing_posture(joints, 10 * in_rad(80) + 5);
  ASSERT_GT(posture.object_Nmm[1], 0);
  const double second = posture.object_Nmm[1] / 15;
  EXPECT_NEAR(posture.contact_N[1], second, 1e-9);
  const double lever = 15 + 40 * std::cos(in_rad(60));
  EXPECT_NEAR(posture.contact_N[0], (posture.object_Nmm[0] - second * lever) / 20, 1e-9);
}

struct Place {
  double x = 0;
  double y = 0;
};

// Where the joints are and the middles of their phalanges, with the palm along x.
struct Skeleton {
  explicit Skeleton(const std::vector<FingerJoint>& joints, const std::vector<double>& flexion) {
    Place at;
    double angle = 0;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      angle -= flexion[j];
      const double length = *joints[j].phalanx_mm;
      joint.push_back(at);
      middle.push_back({at.x + length / 2 * std::cos(angle), at.y + length / 2 * std::sin(angle)});
      outward.push_back({-std::sin(angle), std::cos(angle)});
      at = {at.x + length * std::cos(angle), at.y + length * std::sin(angle)};
    }
  }

  // Returns the torque about joint j of 1 N on phalanx k, square to it.
  double torque(std::size_t j, std::size_t k) const {
    const Place arm{middle[k].x - joint[j].x, middle[k].y - joint[j].y};
    return arm.x * outward[k].y - arm.y * outward[k].x;
  }

  std::vector<Place> joint;
  std::vector<Place> middle;
  std::vector<Place> outward;
};

TEST(FingerClosing, HasContactForcesInEquilibriumOrNone) {
  int with = 0;
  int without = 0;
  int at_end = 0;
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    std::vector<FingerJoint> joints = random_finger(seed);
    for (std::size_t j = 0; j < joints.size(); ++j) {
      joints[j].phalanx_mm = 15 + 30 * uniform(seed, 99, j);
    }
    for (const FingerPosture& posture : close_finger(joints, 20).closing) {
      const bool touched = std::any_of(posture.object_Nmm.begin(), posture.object_Nmm.end(),
                                       [](double torque) { return torque > 0; });
      if (!touched) continue;
      ++(posture.contact_N.empty() ? without : with);
      if (posture.contact_N.empty()) continue;
      const Skeleton skeleton(joints, posture.flexion_rad);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const double spring =
            joints[j].spring_Nmm_rad * (posture.flexion_rad[j] - in_rad(joints[j].rest_deg));
        double left = joints[j].arm_mm * posture.tension_N[j] - spring;
        for (std::size_t k = j; k < joints.size(); ++k) {
          left -= posture.contact_N[k] * skeleton.torque(j, k);
        }
        const double flexion = posture.flexion_rad[j];
        const double tolerance = 1e-9 * (1 + std::abs(spring));
        if (posture.object_Nmm[j] > 0) {
          EXPECT_NEAR(left, 0, tolerance) << seed;
        } else if (flexion >= in_rad(joints[j].stop_deg())) {
          EXPECT_GE(left, -tolerance) << seed;
          ++at_end;
        } else if (flexion > 0) {
          EXPECT_NEAR(left, 0, tolerance) << seed;
        }
      }
    }
  }
  for (const int cases : {with, without, at_end}) EXPECT_GT(cases, 50);
}

TEST(FingerClosing, OpensTheProximalJointFirst) {
  const std::vector<FingerJoint> joints{joint_of(10, 30, 0.15, 20), joint_of(10, 30, 0.15, 10)};
  const FingerClosing moved = close_finger(joints, 30);
  const FingerPosture& closed = moved.closing.back();
  const FingerPosture& first = moved.opening[1];
  EXPECT_LT(first.flexion_rad[0], closed.flexion_rad[0]);
  EXPECT_EQ(first.flexion_rad[1], closed.flexion_rad[1]);
  for (std::size_t i = 0; i < moved.opening.size(); ++i) {
    const FingerPosture& opening = moved.opening[i];
    const FingerPosture& closing = moved.closing[moved.closing.size() - 1 - i];
    EXPECT_LE(opening.pull_N, closing.pull_N + 1e-12);
    double excursion = 0;
    for (std::size_t j = 0; j < 2; ++j) {
      excursion += 10 * opening.flexion_rad[j];
      const double phi = guide_exponent(joints[j], opening.flexion_rad[j]);
      const double before = j == 0 ? opening.pull_N : opening.tension_N[0];
      EXPECT_GE(before, opening.tension_N[j] * std::exp(-phi) * (1 - 1e-9));
      EXPECT_LE(before, opening.tension_N[j] * std::exp(phi) * (1 + 1e-9));
    }
    EXPECT_NEAR(excursion, opening.excursion_mm, 1e-9);
    // A joint that has moved since the last step lets its guide slide to the tip.
    for (std::size_t j = 0; j < 2 && i > 0 && opening.pull_N > 0; ++j) {
      if (opening.flexion_rad[j] >= moved.opening[i - 1].flexion_rad[j]) continue;
      const double phi = guide_exponent(joints[j], opening.flexion_rad[j]);
      const double before = j == 0 ? opening.pull_N : opening.tension_N[0];
      EXPECT_NEAR(before / opening.tension_N[j], std::exp(-phi), 1e-9);
    }
  }
}

TEST(FingerClosing, IsThatOfLeastEnergyOn200Fingers) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::vector<FingerJoint> joints = random_finger(seed);
    const FingerClosing moved = close_finger(joints, 8);
    EnergyFinger energy(joints);
    // At both ends the pull is not determined: it stands between two limits.
    for (std::size_t i = 1; i + 1 < moved.closing.size(); ++i) {
      const FingerPosture& posture = moved.closing[i];
      energy.move_to(posture.excursion_mm);
      for (std::size_t j = 0; j < joints.size(); ++j) {
        ASSERT_NEAR(posture.flexion_rad[j], energy.flexion()[j], 1e-8) << seed << ", joint " << j;
      }
      ASSERT_NEAR(posture.pull_N, energy.pull(), 1e-8 * energy.pull()) << seed;
    }
  }
}

}  // namespace
}  // namespace reeve
