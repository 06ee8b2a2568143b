// Bounds on designs whose friction depends on the load, from their trees alone.
//
// Let the tension behind every contact, T_low = T_high e^{-phi(T_high)}, rise with T_high. Then no
// tension of a tree falls as the take-up of its tendons grows: across each contact, at rest or not,
// a greater tension on one side allows no smaller one on the other, and segments between contacts
// at rest are stretched by what they take up. Trees on one carriage have the same take-up z, and
// their motor tensions τ_t(z) add up to T_M. So with Σ τ_t(z_j) <= T_M <= Σ τ_t(z_{j+1}), in a
// grasp
//
//   least(z_j) / most(z_{j+1})  <=  uniformity  <=  least(z_{j+1}) / most(z_j)
//   work(z_j) / T_M             <=  efficiency  <=  work(z_{j+1}) / T_M
//
// where least, most and work are the sums of all trees. The z_j are powers of one ratio, the same
// for all trees, and a tree is solved at a z_j once for all designs that contain it. A single tree
// has the whole T_M, and both bounds are its own values.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

#include "causes/model.hpp"
#include "causes/model_solver.hpp"
#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/performance.hpp"
#include "search/evaluate/routing_beginning.hpp"
#include "search/evaluate/tree_spans.hpp"

namespace reeve::search {

struct LoadedBounds {
  PartCount parts;
  OutlinedPerformance at_best;
  OutlinedPerformance at_worst;
};

class LoadedTrees {
 public:
  // True if exponents depend on the load alike at all contacts of a kind, fingers are alike, T_low
  // rises with T_high (sampled at 4096 tensions for each kind), and no exponent reaches its limit.
  // A design that is left out counts as converged: under such laws every solve that was tried did.
  static bool can_bound(const Model& model);

  // The grasps must hold one finger at most.
  LoadedTrees(const Model& model, const GraspSet& grasps);

  // Returns nothing where blocks tie tendons, or where a solve fails.
  std::optional<LoadedBounds> bounds(const Routing& routing, const std::vector<TreeSpan>& spans);

 private:
  // States of a tree at one take-up: [0] no finger held; [f] finger f held. Tensions are in N.
  using Node = std::vector<TreeSums>;
  struct Tree {
    std::unique_ptr<ModelSolver> solver;  // at the exponents of its last state
    PartCount parts;
    int first = 0;            // number of the take-up of the first node
    std::vector<Node> nodes;  // empty if not solved yet
  };
  struct Enclosure {
    TreeSums low;   // at z_j
    TreeSums high;  // at z_{j+1}
  };

  void prepare(const Routing& routing, const TreeSpan& span, Tree& tree);
  Tree& find(const Routing& routing, const TreeSpan& span, int fingers);
  const Node& node(Tree& tree, int take_up);
  TreeSums solve(Tree& tree, Grasp grasp, Prescribed prescribed, double unit_N) const;
  Node solve(Tree& tree, int take_up) const;
  TreeSums sums(Grasp grasp, const std::vector<TreeSpan>& spans, int take_up);
  bool leaves_some_slack(Grasp grasp, const std::vector<TreeSpan>& spans);
  bool enclose(Grasp grasp, const std::vector<TreeSpan>& spans, Enclosure& enclosure);

  std::shared_ptr<const Model> model_;
  MechanicsBuilder builder_;
  GraspSet grasps_;
  double weight_ = 0;  // of all grasps
  Routing part_;
  Network network_;
  Mechanics mechanics_;
  std::unordered_map<TreeKey, Tree, TreeKey::Hash> known_;
  // A tree with more than half of a routing's fingers: one stays while those beside it change.
  TreeKey greatest_key_;
  Tree greatest_;
  std::vector<Tree*> trees_;  // trees of the current routing
  int take_up_ = 0;           // number of the last one that enclosed a design
};

}  // namespace reeve::search
