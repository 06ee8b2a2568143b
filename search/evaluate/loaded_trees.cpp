#include "search/evaluate/loaded_trees.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "causes/term.hpp"
#include "search/evaluate/shared_states.hpp"

namespace reeve::search {
namespace {

// Ratio of one take-up to the next.
constexpr double take_up_ratio = 1.1;
// Covers what an error of 1e-6 of each exponent makes of a ratio of tensions.
constexpr double solve_margin = 1e-3;
// A few kilobytes each.
constexpr std::size_t most_loaded_trees = 8192;
// A design this many take-ups away from the one before is searched for anew.
constexpr int most_take_up_steps = 60;

double take_up_N(int number) { return std::pow(take_up_ratio, number); }

// True if a law tells contacts of one kind apart, or may jump or turn between samples.
bool has_gentle_law(const Effect& effect) {
  const Term* const term = term_of(*effect.cause);
  if (term == nullptr) return true;
  const Site& site = term->site;
  const bool is_of_kind =
      site.finger == 0 && !site.held && site.routing.empty() && !site.number.has_value();
  return is_of_kind && term->form != Form::step && term->form != Form::sine &&
         term->form != Form::product;
}

const ContactLaw& law_of_kind(const Hardware& hardware, ContactKind kind) {
  return kind == ContactKind::tube     ? hardware.tube
         : kind == ContactKind::sheath ? hardware.sheath
                                       : hardware.bearing;
}

double exponent_at(const Model& model, double phi, ContactKind kind, double high_N) {
  const ContactLoad load{kind, high_N};
  for (const Effect& effect : model.effects) {
    const Reach reach = effect.cause->reach();
    if (reach == Reach::load || reach == Reach::conditions || reach == Reach::exponent) {
      phi = effect.cause->exponent(phi, load, model.conditions, effect);
    }
  }
  return std::max(phi, 0.0);
}

// Samples all tensions that a design can have, and twice as much.
bool passes_on_more_of_more(const Model& model, double phi, ContactKind kind) {
  constexpr int samples = 4096;
  constexpr double least = 1e-15;  // part of the greatest
  const double step = std::pow(least, 1.0 / samples);
  double high = 2 * model.conditions.motor_tension_N;
  double last = high;
  for (int i = 0; i <= samples; ++i, high *= step) {
    const double exponent = exponent_at(model, phi, kind, high);
    const double low = high * std::exp(-exponent);
    if (exponent >= max_exponent || !(low < last)) return false;
    last = low;
  }
  return true;
}

}  // namespace

bool LoadedTrees::can_bound(const Model& model) {
  if (!reaches(model, Reach::load) || reaches(model, Reach::contact) || !have_like_fingers(model) ||
      !std::all_of(model.effects.begin(), model.effects.end(), has_gentle_law)) {
    return false;
  }
  const Hardware hardware = possible_hardware(model);
  constexpr std::array kinds{ContactKind::tube, ContactKind::sheath, ContactKind::bearing};
  return std::all_of(kinds.begin(), kinds.end(), [&](ContactKind kind) {
    return passes_on_more_of_more(model, law_of_kind(hardware, kind).exponent(), kind);
  });
}

LoadedTrees::LoadedTrees(const Model& model, const GraspSet& grasps)
    : model_(std::make_shared<const Model>(model)),
      builder_(possible_hardware(model)),
      grasps_(grasps) {
  for (const WeightedGrasp& grasp : grasps_) weight_ += grasp.weight;
}

void LoadedTrees::prepare(const Routing& routing, const TreeSpan& span, Tree& tree) {
  copy_tree(routing, span, part_);
  expand(part_, network_);
  builder_.apply(network_, mechanics_);
  if (!tree.solver) tree.solver = std::make_unique<ModelSolver>(*model_);
  tree.solver->set_routing("", network_, mechanics_);
  tree.parts = core::parts(network_);
  tree.nodes.clear();
}

LoadedTrees::Tree& LoadedTrees::find(const Routing& routing, const TreeSpan& span, int fingers) {
  if (2 * span.fingers > fingers) {
    if (!greatest_.solver || greatest_key_ != span.key) {
      prepare(routing, span, greatest_);
      greatest_key_ = span.key;
    }
    return greatest_;
  }
  const auto [found, is_new] = known_.try_emplace(span.key);
  if (is_new) prepare(routing, span, found->second);
  return found->second;
}

TreeSums LoadedTrees::solve(Tree& tree, Grasp grasp, Prescribed prescribed, double unit_N) const {
  const TensionState& state =
      tree.solver->solve_from_last(grasp, prescribed, unit_N, model_->conditions);
  TreeSums sums = sums_of(tree.solver->network(), state, unit_N);
  sums.in_range &= tree.solver->converged();
  return sums;
}

LoadedTrees::Node LoadedTrees::solve(Tree& tree, int take_up) const {
  Node node;
  const int fingers = tree.solver->network().fingers;
  for (int held = 0; held <= fingers; ++held) {
    const Grasp grasp{held == 0 ? 0 : std::uint64_t{1} << (held - 1)};
    node.push_back(solve(tree, grasp, Prescribed::take_up, take_up_N(take_up)));
  }
  return node;
}

const LoadedTrees::Node& LoadedTrees::node(Tree& tree, int take_up) {
  if (tree.nodes.empty()) tree.first = take_up;
  if (take_up < tree.first) {
    tree.nodes.insert(tree.nodes.begin(), static_cast<std::size_t>(tree.first - take_up), Node{});
    tree.first = take_up;
  }
  const auto index = static_cast<std::size_t>(take_up - tree.first);
  if (index >= tree.nodes.size()) tree.nodes.resize(index + 1);
  Node& node = tree.nodes[index];
  if (node.empty()) node = solve(tree, take_up);
  return node;
}

TreeSums LoadedTrees::sums(Grasp grasp, const std::vector<TreeSpan>& spans, int take_up) {
  TreeSums sums;
  for (std::size_t t = 0; t < spans.size(); ++t) {
    sums += node(*trees_[t], take_up)[held_in_tree(spans[t], grasp)];
  }
  return sums;
}

// True if a tree with strands does not jam: beside one that does it is slack.
bool LoadedTrees::leaves_some_slack(Grasp grasp, const std::vector<TreeSpan>& spans) {
  for (std::size_t t = 0; t < spans.size(); ++t) {
    const TreeSums& sums = node(*trees_[t], take_up_)[held_in_tree(spans[t], grasp)];
    if (!sums.jams && sums.has_strands()) return true;
  }
  return false;
}

// False where it finds no take-up.
bool LoadedTrees::enclose(Grasp grasp, const std::vector<TreeSpan>& spans, Enclosure& enclosure) {
  const double motor_N = model_->conditions.motor_tension_N;
  if (spans.size() == 1) {
    enclosure.low = enclosure.high =
        solve(*trees_.front(), grasp, Prescribed::motor_tension, motor_N);
    return enclosure.low.in_range && !enclosure.low.jams;
  }
  enclosure.low = sums(grasp, spans, take_up_);
  if (enclosure.low.jams) return leaves_some_slack(grasp, spans);
  // Tensions are nearly proportional to the take-up.
  const double way = std::log(motor_N / enclosure.low.motor) / std::log(take_up_ratio);
  if (!(std::abs(way) < 1e4)) return false;
  take_up_ += static_cast<int>(std::floor(way));
  enclosure.low = sums(grasp, spans, take_up_);
  for (int step = 0; step < most_take_up_steps && enclosure.low.motor > motor_N; ++step) {
    enclosure.low = sums(grasp, spans, --take_up_);
  }
  enclosure.high = sums(grasp, spans, take_up_ + 1);
  for (int step = 0; step < most_take_up_steps && enclosure.high.motor < motor_N; ++step) {
    enclosure.low = enclosure.high;
    enclosure.high = sums(grasp, spans, ++take_up_ + 1);
  }
  return enclosure.low.in_range && enclosure.high.in_range && enclosure.low.motor <= motor_N &&
         enclosure.high.motor >= motor_N;
}

std::optional<LoadedBounds> LoadedTrees::bounds(const Routing& routing,
                                                const std::vector<TreeSpan>& spans) {
  const bool has_tied_tendons = spans.size() < routing.tendons.size();
  if (has_tied_tendons) return std::nullopt;
  if (known_.size() + spans.size() > most_loaded_trees) known_.clear();
  const int fingers = spans.back().fingers_before + spans.back().fingers;
  LoadedBounds result;
  trees_.clear();
  for (const TreeSpan& span : spans) {
    trees_.push_back(&find(routing, span, fingers));
    result.parts += trees_.back()->parts;
  }
  for (const WeightedGrasp& grasp : grasps_) {
    const double share = grasp.weight / weight_;
    Enclosure sums;
    if (!enclose(grasp.grasp, spans, sums)) return std::nullopt;
    if (sums.low.jams) {
      result.at_best.add(share, {});
      result.at_worst.add(share, {});
      continue;
    }
    const double motor_N = model_->conditions.motor_tension_N;
    const StrandTally& low = sums.low.strands;
    const StrandTally& high = sums.high.strands;
    result.at_best.add(share, {std::min(1.0, high.least / low.most * (1 + solve_margin)),
                               high.work / motor_N * (1 + solve_margin)});
    result.at_worst.add(share, {low.least / high.most * (1 - solve_margin),
                                low.work / motor_N * (1 - solve_margin)});
  }
  return result;
}

}  // namespace reeve::search
