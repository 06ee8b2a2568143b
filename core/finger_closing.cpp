#include "core/finger_closing.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::core {
namespace {

// The search ends at these values of ln(T / N), beyond which no spring of a finger asks.
constexpr double least_log = -80;
constexpr double greatest_log = 60;
// Sums of the same excursions in another order miss each other by rounding.
constexpr double rounded_down = 1 - 1e-13;

// A joint as the closing needs it, angles in rad.
struct Hinge {
  double arm = 0;
  double stiffness = 0;
  double rest = 0;
  double stop = 0;

  double flexion(double tension) const {
    return std::clamp(rest + arm * tension / stiffness, 0.0, stop);
  }
};

std::vector<Hinge> hinges_of(const std::vector<FingerJoint>& joints) {
  // The vanishing spring of a joint without any, as a share of the stiffest.
  constexpr double vanishing = 1e-9;
  double stiffest = 0;
  for (const FingerJoint& joint : joints) stiffest = std::max(stiffest, joint.spring_Nmm_rad);
  const double least = vanishing * (stiffest > 0 ? stiffest : 1);
  std::vector<Hinge> hinges;
  for (const FingerJoint& joint : joints) {
    const bool has_spring = joint.spring_Nmm_rad > 0;
    hinges.push_back({joint.arm_mm, std::max(joint.spring_Nmm_rad, least),
                      has_spring ? in_rad(joint.rest_deg) : 0, in_rad(joint.stop_deg())});
  }
  return hinges;
}

// The least value between low and high from which on `reached` holds; high if it never does.
template <typename Reached>
double first_reached(double low, double high, Reached reached) {
  if (reached(low)) return low;
  while (true) {
    const double middle = (low + high) / 2;
    if (middle <= low || middle >= high) return high;
    (reached(middle) ? high : low) = middle;
  }
}

class FingerTendon {
 public:
  explicit FingerTendon(const std::vector<FingerJoint>& joints)
      : joints_(joints), hinges_(hinges_of(joints)) {
    stretch_.flexion_rad.assign(joints.size(), 0.0);
    stretch_.tension_N.assign(joints.size(), 0.0);
  }

  double whole_excursion() const {
    double sum = 0;
    for (const Hinge& hinge : hinges_) sum += hinge.arm * hinge.stop;
    return sum;
  }

  FingerPosture closing(double excursion) {
    const double log = first_reached(least_log, greatest_log, [&](double log_tension) {
      draw_in(std::exp(log_tension));
      return stretch_.excursion_mm >= rounded_down * excursion;
    });
    draw_in(std::exp(log));
    return finished(stretch_, excursion);
  }

  // Back from a posture of the closing.
  FingerPosture opening(const FingerPosture& closed, double excursion) {
    const std::size_t n = joints_.size();
    for (std::size_t sliding = 1; sliding <= n; ++sliding) {
      const std::size_t last = sliding - 1;
      const double greatest = closed.tension_N[last];
      double least = 0;
      if (sliding < n) {
        least = closed.tension_N[sliding] *
                std::exp(-guide_exponent(joints_[sliding], closed.flexion_rad[sliding]));
      }
      let_out(closed, sliding, std::min(least, greatest));
      if (sliding < n && stretch_.excursion_mm > excursion) continue;
      const double tension = first_reached(std::min(least, greatest), greatest, [&](double t) {
        let_out(closed, sliding, t);
        return stretch_.excursion_mm >= rounded_down * excursion;
      });
      let_out(closed, sliding, tension);
      break;
    }
    return finished(stretch_, excursion);
  }

  // Beyond the closing torques and forces are linear in the pull.
  FurtherPull further_pull() {
    constexpr double near_N = 1;
    constexpr double far_N = 1e6;
    const double whole = whole_excursion();
    const double last_N = closing(whole).tension_N.back();
    const auto pulled = [&](double further_N) {
      draw_in(last_N + further_N);
      return finished(stretch_, whole);
    };
    const FingerPosture near = pulled(near_N);
    const FingerPosture far = pulled(far_N);
    const auto per_newton = [&](std::vector<double> more, const std::vector<double>& less) {
      for (std::size_t j = 0; j < more.size(); ++j) {
        more[j] = (more[j] - less[j]) / (far.pull_N - near.pull_N);
      }
      return more;
    };
    FurtherPull further{per_newton(far.object_Nmm, near.object_Nmm)};
    if (near.contact_N.size() == far.contact_N.size()) {
      further.contact = per_newton(far.contact_N, near.contact_N);
    }
    return further;
  }

  JointStop stop_of(std::size_t joint) {
    const double log = first_reached(least_log, greatest_log, [&](double log_tension) {
      draw_in(std::exp(log_tension));
      return stretch_.flexion_rad[joint] >= hinges_[joint].stop;
    });
    draw_in(std::exp(log));
    return {joint, stretch_.excursion_mm, joints_[joint].object_deg.has_value()};
  }

 private:
  // The finger at a tension behind its last guide, all guides sliding to the palm.
  void draw_in(double last_tension) {
    double tension = last_tension;
    stretch_.excursion_mm = 0;
    for (std::size_t j = joints_.size(); j-- > 0;) {
      place(j, tension);
      tension *= std::exp(guide_exponent(joints_[j], stretch_.flexion_rad[j]));
    }
    stretch_.pull_N = tension;
  }

  // The first `sliding` guides slide to the tip, with this tension behind the last of them; the
  // others and their joints are as in the closed posture.
  void let_out(const FingerPosture& closed, std::size_t sliding, double tension) {
    stretch_ = closed;
    stretch_.excursion_mm = 0;
    for (std::size_t j = sliding; j < joints_.size(); ++j) {
      stretch_.excursion_mm += hinges_[j].arm * stretch_.flexion_rad[j];
    }
    for (std::size_t j = sliding; j-- > 0;) {
      place(j, tension);
      tension *= std::exp(-guide_exponent(joints_[j], stretch_.flexion_rad[j]));
    }
    stretch_.pull_N = tension;
  }

  void place(std::size_t j, double tension) {
    stretch_.tension_N[j] = tension;
    stretch_.flexion_rad[j] = hinges_[j].flexion(tension);
    stretch_.excursion_mm += hinges_[j].arm * stretch_.flexion_rad[j];
  }

  FingerPosture finished(FingerPosture posture, double excursion) const {
    // Tensions below the least one searched are those of a slack tendon.
    if (posture.tension_N.back() <= std::exp(least_log)) {
      posture.pull_N = 0;
      posture.tension_N.assign(joints_.size(), 0.0);
    }
    posture.excursion_mm = excursion;
    posture.object_Nmm.assign(joints_.size(), 0.0);
    for (std::size_t j = 0; j < joints_.size(); ++j) {
      if (!joints_[j].object_deg || posture.flexion_rad[j] < hinges_[j].stop) continue;
      posture.object_Nmm[j] = std::max(0.0, drive_torque(posture, j));
    }
    add_contacts(posture);
    return posture;
  }

  // The lever about joint j of a force at the middle of phalanx k, square to it.
  double lever(const FingerPosture& posture, std::size_t j, std::size_t k) const {
    double lever = *joints_[k].phalanx_mm / 2;
    double bend = 0;
    for (std::size_t i = k; i-- > j;) {
      bend += posture.flexion_rad[i + 1];
      lever += *joints_[i].phalanx_mm * std::cos(bend);
    }
    return lever;
  }

  // Returns the torque about joint j of the contact forces beyond it.
  double contact_torque(const FingerPosture& posture, std::size_t j) const {
    double torque = 0;
    for (std::size_t k = j + 1; k < joints_.size(); ++k) {
      if (posture.contact_N[k] != 0) torque += posture.contact_N[k] * lever(posture, j, k);
    }
    return torque;
  }

  // Returns the tendon's torque about joint j less that of the spring.
  double drive_torque(const FingerPosture& posture, std::size_t j) const {
    const double spring = joints_[j].spring_Nmm_rad * (posture.flexion_rad[j] - hinges_[j].rest);
    return hinges_[j].arm * posture.tension_N[j] - spring;
  }

  // Whether a joint that no object stops bears the forces on the phalanges beyond it: open, or at
  // the end of its range and driven there in spite of them.
  bool bears(const FingerPosture& posture, std::size_t j) const {
    const double torque = contact_torque(posture, j);
    const double flexion = posture.flexion_rad[j];
    if (torque == 0 || flexion == 0) return true;
    return flexion >= hinges_[j].stop && drive_torque(posture, j) >= torque;
  }

  void add_contacts(FingerPosture& posture) const {
    const bool has_lengths =
        std::all_of(joints_.begin(), joints_.end(),
                    [](const FingerJoint& joint) { return joint.phalanx_mm.has_value(); });
    if (!has_lengths) return;
    posture.contact_N.assign(joints_.size(), 0.0);
    for (std::size_t j = joints_.size(); j-- > 0;) {
      if (posture.object_Nmm[j] > 0) {
        posture.contact_N[j] =
            (posture.object_Nmm[j] - contact_torque(posture, j)) / lever(posture, j, j);
      } else if (!bears(posture, j)) {
        posture.contact_N.clear();
        return;
      }
    }
  }

  const std::vector<FingerJoint>& joints_;
  std::vector<Hinge> hinges_;
  FingerPosture stretch_;  // at the tension that was tried last
};

}  // namespace

FingerClosing close_finger(const std::vector<FingerJoint>& joints, int steps) {
  FingerTendon tendon(joints);
  FingerClosing result;
  const double whole = tendon.whole_excursion();
  for (int i = 0; i <= steps; ++i) {
    result.closing.push_back(tendon.closing(whole * i / steps));
  }
  for (int i = steps; i >= 0; --i) {
    result.opening.push_back(tendon.opening(result.closing.back(), whole * i / steps));
  }
  for (std::size_t j = 0; j < joints.size(); ++j) result.stops.push_back(tendon.stop_of(j));
  result.further = tendon.further_pull();
  std::stable_sort(
      result.stops.begin(), result.stops.end(),
      [](const JointStop& a, const JointStop& b) { return a.excursion_mm < b.excursion_mm; });
  return result;
}

FingerPosture closing_posture(const std::vector<FingerJoint>& joints, double excursion_mm) {
  return FingerTendon(joints).closing(excursion_mm);
}

}  // namespace reeve::core
