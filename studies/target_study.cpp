#include "studies/target_study.hpp"

#include <algorithm>
#include <limits>
#include <string>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"
#include "numerics/parallel.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/evaluation.hpp"
#include "search/rank/ranking.hpp"
#include "search/uncertainty/coefficient_box.hpp"

namespace reeve::studies {
namespace {

constexpr std::uint64_t block_size = 1024;

constexpr std::size_t contact_draws = 40;

using Key = std::tuple<double, double, double, double, double, std::string>;

struct TargetCandidate {
  Key key;
  Routing routing;
  double static_miss = 0;
};

bool operator<(const TargetCandidate& a, const TargetCandidate& b) { return a.key < b.key; }

// Misses that meet the target are alike, so that what else a design is worth decides among them.
double beyond_met(double miss) { return miss <= met_miss ? 0 : on_grid(miss); }

bool is_one_tree(const Network& network) {
  return std::ranges::all_of(network.tendons, [&](const TendonSpan& tendon) {
    return tendon.tree == network.tendons.front().tree;
  });
}

// Returns the 95 % quantile of the miss over draws of the contacts, and the pulls there.
UnlikeContacts unlike_contacts(const GoalEvaluator& goal, Model model, std::uint64_t seed) {
  std::vector<std::pair<double, std::uint64_t>> misses;
  const auto draw = [&](std::uint64_t d) -> const Model& {
    model.hardware.contact_draw = contact_draw(model.hardware, seed, d);
    return model;
  };
  for (std::uint64_t d = 0; d < contact_draws; ++d) misses.emplace_back(goal.value(draw(d)), d);
  const auto high = misses.begin() + static_cast<std::ptrdiff_t>(contact_draws * 19 / 20);
  std::nth_element(misses.begin(), high, misses.end());
  return {high->first, goal.shares(draw(high->second))};
}

// Lower is better.
double price(const ObjectiveValues& values, const std::optional<MotorForce>& motor) {
  if (motor) return on_grid(motor->p95_N);
  return has_hand(values) ? value(values, Objective::motor_force)
                          : -value(values, Objective::efficiency_mean);
}

// The routings one after the other, each by itself.
class Screening {
 public:
  Screening(const ExploreOptions& explored, const SizingOptions& sizing)
      : explored_(explored),
        sizing_(sizing),
        frictionless_(with_friction_times(sizing.nominal, 0)),
        generator_(explored.generator),
        evaluator_(explored.model, explored.grasps, explored.score, explored.prices) {}

  struct Found {
    std::vector<TargetCandidate> best;
    std::uint64_t by_statics = 0;
  };

  Found screen(std::uint64_t begin, std::uint64_t end) {
    Found found;
    Routing routing;
    generator_.seek(begin);
    for (std::uint64_t i = begin; i < end && generator_.next(routing); ++i) {
      if (!is_actuated(routing)) continue;
      std::optional<TargetCandidate> candidate = judged(routing);
      if (!candidate) continue;
      if (candidate->static_miss <= met_miss) ++found.by_statics;
      found.best.push_back(std::move(*candidate));
    }
    keep_best(found.best);
    return found;
  }

  static void keep_best(std::vector<TargetCandidate>& candidates) {
    std::sort(candidates.begin(), candidates.end());
    if (candidates.size() > most_targeted) candidates.resize(most_targeted);
  }

 private:
  // Returns nothing if a constraint rejects the routing, or if it cannot be judged.
  std::optional<TargetCandidate> judged(const Routing& routing) {
    try {
      const ObjectiveValues values = evaluator_.evaluate(routing, scope());
      if (first_failure(explored_.constraints, values) > 0) return std::nullopt;
      const GoalEvaluator goal(routing, sizing_.goal, goal_grasps(sizing_), sizing_.score);
      const double statics = is_one_tree(expand(routing)) ? goal.value(frictionless_)
                                                          : std::numeric_limits<double>::infinity();
      const double nominal = goal.value(sizing_.nominal);
      // Few meet the target. All others miss it, whatever their contacts do.
      const bool is_met = statics <= met_miss && nominal <= met_miss;
      const double unlike = is_met ? unlike_contacts(goal, sizing_.nominal, sizing_.seed).miss : 0;
      return TargetCandidate{{beyond_met(statics), beyond_met(nominal), unlike > met_miss ? 1. : 0.,
                              price(values, std::nullopt), part_total(values), to_word(routing)},
                             routing,
                             statics};
    } catch (const OutOfRange&) {
      return std::nullopt;
    }
  }

  EvaluationScope scope() const {
    std::vector<Objective> asked{Objective::motor_force, Objective::efficiency_mean};
    for (const Constraint& constraint : explored_.constraints) {
      asked.push_back(constraint.objective);
    }
    return scope_for(asked, explored_.score);
  }

  const ExploreOptions& explored_;
  const SizingOptions& sizing_;
  Model frictionless_;
  RoutingGenerator generator_;
  DesignEvaluator evaluator_;
};

Screening::Found screened(const ExploreOptions& explored, const SizingOptions& sizing,
                          const StudySupervision& supervision) {
  const std::uint64_t total = RoutingGenerator(explored.generator).total();
  const auto blocks = static_cast<std::size_t>((total + block_size - 1) / block_size);
  Workers workers(explored.threads, supervision.stop);
  std::vector<std::optional<Screening>> screenings(workers.count());
  std::vector<Screening::Found> found(blocks);
  workers.for_each_block(blocks, 1, [&](const IndexBlock& block) {
    std::optional<Screening>& screening = screenings[block.worker];
    if (!screening) screening.emplace(explored, sizing);
    for (std::size_t b = block.begin; b < block.end; ++b) {
      const std::uint64_t begin = b * block_size;
      found[b] = screening->screen(begin, std::min(begin + block_size, total));
    }
  });
  Screening::Found all;
  for (Screening::Found& part : found) {
    all.by_statics += part.by_statics;
    std::move(part.best.begin(), part.best.end(), std::back_inserter(all.best));
  }
  Screening::keep_best(all.best);
  return all;
}

Key key(const TargetedDesign& design) {
  const SizedGoal& sized = design.sized.design.after;
  return {beyond_met(design.static_miss),
          beyond_met(sized.nominal),
          design.unlike.miss > met_miss ? 1. : 0.,
          price(sized.values, sized.motor),
          part_total(sized.values),
          design.sized.word};
}

TargetedDesign targeted(SizedRouting sized, const std::vector<TargetCandidate>& candidates,
                        const SizingOptions& sizing) {
  TargetedDesign design{std::move(sized), 0, {}, {}};
  for (const TargetCandidate& candidate : candidates) {
    if (std::get<std::string>(candidate.key) == design.sized.word) {
      design.static_miss = candidate.static_miss;
    }
  }
  const SizedDesign& as_sized = design.sized.design;
  Model model = sizing.nominal;
  model.hardware = as_sized.hardware;
  const GoalEvaluator goal(as_sized.routing, sizing.goal, goal_grasps(sizing), sizing.score);
  for (std::size_t i = 0; i < friction_factors.size(); ++i) {
    design.moved_shares.at(i) = goal.shares(with_friction_times(model, friction_factors.at(i)));
  }
  design.unlike = unlike_contacts(goal, model, sizing.seed);
  return design;
}

}  // namespace

bool misses_target(const std::optional<TargetReport>& report) {
  if (!report || report->partial) return false;
  return report->designs.empty() || !report->designs.front().is_met();
}

Model with_friction_times(const Model& model, double factor) {
  Model scaled{effective_hardware(model)};
  scaled.conditions = model.conditions;
  Hardware& hardware = scaled.hardware;
  hardware.tube.mu *= factor;
  hardware.bearing.mu *= factor;
  hardware.sheath.mu *= factor;
  if (hardware.block) hardware.block->mu *= factor;
  for (FingerHardware& finger : hardware.fingers) {
    if (finger.tip_mu) *finger.tip_mu *= factor;
    if (finger.sheath_mu) *finger.sheath_mu *= factor;
  }
  for (ContactHardware& contact : hardware.contacts) {
    if (contact.mu) *contact.mu *= factor;
  }
  return scaled;
}

TargetReport target_study(const ExploreOptions& explored, const SizingOptions& sizing,
                          const Catalogue& catalogue, const StudySupervision& supervision) {
  TargetReport report{sizing, {}, 0, false};
  try {
    const Screening::Found found = screened(explored, sizing, supervision);
    report.by_statics = found.by_statics;
    if (found.best.empty()) return report;
    std::vector<Routing> routings;
    for (const TargetCandidate& candidate : found.best) routings.push_back(candidate.routing);
    SizingReport sized = sizing_study(routings, sizing, catalogue, supervision);
    report.partial = sized.partial;
    for (SizedRouting& routing : sized.designs) {
      report.designs.push_back(targeted(std::move(routing), found.best, sizing));
    }
  } catch (const Stopped&) {
    report.partial = true;
  }
  std::ranges::sort(report.designs, {}, [](const TargetedDesign& design) { return key(design); });
  return report;
}

}  // namespace reeve::studies
