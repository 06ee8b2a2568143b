#include "tests/mujoco/simulated_rig.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace reeve::testing {
namespace {

mjModel* loaded(const std::string& mjcf) {
  mjVFS files;
  mj_defaultVFS(&files);
  if (mj_makeEmptyFileVFS(&files, "rig.xml", static_cast<int>(mjcf.size())) != 0) {
    throw std::runtime_error("MuJoCo cannot keep the file");
  }
  std::copy(mjcf.begin(), mjcf.end(), static_cast<char*>(files.filedata[0]));
  std::array<char, 1000> error{};
  mjModel* model = mj_loadXML("rig.xml", &files, error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(&files);
  // What it warns of while it loads stands there, too.
  if (model == nullptr || error[0] != 0) throw std::runtime_error(error.data());
  return model;
}

int id(const mjModel* model, int type, const std::string& name) {
  const int found = mj_name2id(model, type, name.c_str());
  if (found < 0) throw std::runtime_error("the model has no " + name);
  return found;
}

}  // namespace

SimulatedRig::SimulatedRig(const std::string& mjcf)
    : model_(loaded(mjcf), mj_deleteModel), data_(mj_makeData(model_.get()), mj_deleteData) {}

void SimulatedRig::activate(const std::string& name) {
  for (int e = 0; e < model_->neq; ++e) {
    const std::string here = mj_id2name(model_.get(), mjOBJ_EQUALITY, e);
    if (here == name || here.rfind(name + "_", 0) == 0) model_->eq_active[e] = 1;
  }
}

void SimulatedRig::pull(double force_N, double seconds) {
  pull(std::vector<double>(static_cast<std::size_t>(model_->nu), force_N), seconds);
}

void SimulatedRig::pull(const std::vector<double>& forces_N, double seconds) {
  std::copy(forces_N.begin(), forces_N.end(), data_->ctrl);
  const double end = data_->time + seconds;
  while (data_->time < end) mj_step(model_.get(), data_.get());
}

double SimulatedRig::constraint_force(const std::string& name) const {
  const int wanted = id(model_.get(), mjOBJ_EQUALITY, name);
  for (int row = 0; row < data_->nefc; ++row) {
    if (data_->efc_type[row] == mjCNSTR_EQUALITY && data_->efc_id[row] == wanted) {
      return data_->efc_force[row];
    }
  }
  throw std::runtime_error("no constraint acts for " + name);
}

std::map<std::string, double> SimulatedRig::tensions() const {
  std::map<std::string, double> tensions;
  for (int rope = 1;; ++rope) {
    const std::string name = "tendon_" + std::to_string(rope);
    if (mj_name2id(model_.get(), mjOBJ_EQUALITY, name.c_str()) < 0) return tensions;
    std::istringstream segments(text("segments_of_" + name));
    // It pulls where it would be longer: against the growth of its length.
    for (std::string segment; segments >> segment;) tensions[segment] = -constraint_force(name);
  }
}

double SimulatedRig::position(const std::string& joint) const {
  return data_->qpos[model_->jnt_qposadr[id(model_.get(), mjOBJ_JOINT, joint)]];
}

double SimulatedRig::greatest_speed() const {
  double greatest = 0;
  for (int k = 0; k < model_->nv; ++k) greatest = std::max(greatest, std::abs(data_->qvel[k]));
  return greatest;
}

int SimulatedRig::warnings() const {
  int all = 0;
  for (const mjWarningStat& warning : data_->warning) all += warning.number;
  return all;
}

std::string SimulatedRig::text(const std::string& name) const {
  const int found = id(model_.get(), mjOBJ_TEXT, name);
  return {model_->text_data + model_->text_adr[found],
          static_cast<std::size_t>(model_->text_size[found] - 1)};
}

}  // namespace reeve::testing
