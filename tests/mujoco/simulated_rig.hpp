// An exported routing in MuJoCo's hands.
#pragma once

#include <mujoco/mujoco.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace reeve::testing {

class SimulatedRig {
 public:
  // Fails the test if MuJoCo does not take it.
  explicit SimulatedRig(const std::string& mjcf);

  // Every constraint of this name or that begins with it and an underscore.
  void activate(const std::string& name);
  void pull(double force_N, double seconds = 2);
  void pull(const std::vector<double>& forces_N, double seconds = 2);  // of each motor

  // Of the tendon's equality constraint, N, by the segments that the file says lie on it.
  std::map<std::string, double> tensions() const;
  double position(const std::string& joint) const;
  double greatest_speed() const;
  int warnings() const;
  std::string text(const std::string& name) const;

 private:
  double constraint_force(const std::string& name) const;

  std::unique_ptr<mjModel, decltype(&mj_deleteModel)> model_;
  std::unique_ptr<mjData, decltype(&mj_deleteData)> data_;
};

}  // namespace reeve::testing
