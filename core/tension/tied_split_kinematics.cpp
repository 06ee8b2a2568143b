#include "core/tension/tied_split_kinematics.hpp"

#include <algorithm>

#include "core/tension/least_motion.hpp"
#include "core/tension/tree_kinematics.hpp"

namespace reeve::core {
namespace {

// Closings of fingers, then travels of blocks.
LengthBounds length_bounds(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  const auto fingers = static_cast<Eigen::Index>(network.fingers);
  const auto rows = static_cast<Eigen::Index>(network.tendons.size());
  const auto columns = fingers + static_cast<Eigen::Index>(network.blocks.size());
  LengthBounds result{Eigen::MatrixXd::Zero(rows, columns), Eigen::VectorXd::Zero(rows),
                      Eigen::VectorXd::Zero(columns)};
  for (Eigen::Index f = 0; f < fingers; ++f) {
    result.cost(f) = 1 / mechanics.closing[static_cast<std::size_t>(f)];
  }
  for (Eigen::Index row = 0; row < rows; ++row) {
    const TendonSpan& tendon = network.tendons[static_cast<std::size_t>(row)];
    for_each_term(
        network, mechanics, tendon, grasp, [&](double length) { result.motor(row) += length; },
        [&](int finger, double factor) { result.give(row, finger - 1) += factor; },
        [&](std::size_t block, double factor) {
          result.give(row, fingers + static_cast<Eigen::Index>(block)) -= factor;
        });
  }
  return result;
}

// The tendons of one tree without the others, which then ask for nothing.
LengthBounds only_tree(const Network& network, LengthBounds c, std::size_t tree) {
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    if (network.tendons[t].tree == tree) continue;
    c.give.row(static_cast<Eigen::Index>(t)).setZero();
    c.motor(static_cast<Eigen::Index>(t)) = 0;
  }
  return c;
}

// Trees that cannot give way even alone block the carriage; if none is such a one, all do together.
void find_jams(const Network& network, const LengthBounds& c, SplitClosing& result) {
  const std::size_t n = network.tendons.size();
  result.jams.assign(n, 0);
  result.slack.assign(n, 0);
  for (std::size_t t = 0; t < n; ++t) {
    const std::size_t tree = network.tendons[t].tree;
    result.jams[t] = least_motion(only_tree(network, c, tree)).met ? 0 : 1;
  }
  if (std::find(result.jams.begin(), result.jams.end(), 1) == result.jams.end()) {
    result.jams.assign(n, 1);
  }
}

}  // namespace

SplitClosing tied_split_closing(const Network& network, const Mechanics& mechanics, Grasp grasp) {
  const LengthBounds c = length_bounds(network, mechanics, grasp);
  const LeastMotion least = least_motion(c);
  SplitClosing result;
  result.closing.assign(static_cast<std::size_t>(network.fingers), 0.0);
  result.block_travel.assign(network.blocks.size(), 0.0);
  for (std::size_t t = 0; t < network.tendons.size(); ++t) {
    result.slack.push_back(least.pulls(static_cast<Eigen::Index>(t)) ? 0 : 1);
    result.jams.push_back(0);
  }
  if (!least.met) {
    find_jams(network, c, result);
    return result;
  }
  for (std::size_t f = 0; f < result.closing.size(); ++f) {
    const bool held = grasp.holds(static_cast<int>(f) + 1);
    result.closing[f] = held ? 0 : least.x(static_cast<Eigen::Index>(f));
  }
  for (std::size_t b = 0; b < result.block_travel.size(); ++b) {
    result.block_travel[b] = least.x(static_cast<Eigen::Index>(result.closing.size() + b));
  }
  return result;
}

}  // namespace reeve::core
