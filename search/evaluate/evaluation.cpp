#include "search/evaluate/evaluation.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/hand_closing.hpp"
#include "core/notation.hpp"

namespace reeve::search {

EvaluationScope scope_for(const std::vector<Objective>& objectives, const Score& score) {
  const auto any_of_terms = [](const Score& terms, auto is_wanted) {
    return std::any_of(terms.terms.begin(), terms.terms.end(),
                       [&](const ScoreTerm& term) { return is_wanted(term.objective); });
  };
  const auto is_wanted = [&](Objective objective) {
    return std::find(objectives.begin(), objectives.end(), objective) != objectives.end();
  };
  const bool scored = is_wanted(Objective::score);
  const auto counts = [&](Objective objective) {
    return is_wanted(objective) ||
           (scored && any_of_terms(score, [&](Objective term) { return term == objective; }));
  };
  const auto& rows = objective_table();
  const bool hand = std::any_of(rows.begin(), rows.end(), [&](const ObjectiveRow& row) {
    return row.of_hand && counts(row.objective);
  });
  return {counts(Objective::round_trip_efficiency), any_of_terms(authors_score(), counts), hand,
          counts(Objective::jams_all),
          counts(Objective::uniformity_p5) || counts(Objective::efficiency_p5)};
}

namespace {

// Tendons without a strand, which give nothing up.
bool blocks_the_carriage(const Network& network) {
  const auto has_strand = [&](const TendonSpan& tendon) {
    const auto* const first = network.segments.data() + tendon.first_segment;
    return std::any_of(first, first + tendon.segments,
                       [](const Segment& segment) { return segment.kind == SegmentKind::strand; });
  };
  return !std::all_of(network.tendons.begin(), network.tendons.end(), has_strand);
}

}  // namespace

DesignEvaluator::DesignEvaluator(const Hardware& hardware, GraspSet grasps)
    : DesignEvaluator(Model{hardware}, std::move(grasps)) {}

DesignEvaluator::DesignEvaluator(const Model& model, GraspSet grasps, Score score,
                                 std::optional<PartPrices> prices)
    : model_(std::make_shared<const Model>(model)),
      needs_word_(names_routings(model)),
      builder_(possible_hardware(model)),
      hand_(hand(model.hardware)),
      grasps_(std::move(grasps)),
      open_grasps_(opened(grasps_)),
      score_(std::move(score)),
      prices_(std::move(prices)) {
  if (reaches(model, Reach::contact) || changes_exponents(model)) model_solver_.emplace(*model_);
}

void DesignEvaluator::share_trees() {
  if (hold_one_finger_at_most(grasps_) && routings_share_states(*model_)) {
    shared_.emplace(possible_hardware(*model_));
  }
}

const TensionState& DesignEvaluator::try_solve(Grasp grasp, Direction direction) {
  if (is_shared_ && shared_->solve(grasp, direction, state_)) return state_;
  if (!model_solver_) {
    solver_.solve(network_, mechanics_, grasp, direction, state_);
    return state_;
  }
  const TensionState& state = model_solver_->solve(grasp, direction, model_->conditions);
  if (state.in_range && !model_solver_->converged()) ++unconverged_;
  return state;
}

const TensionState& DesignEvaluator::solve(Grasp grasp, Direction direction) {
  return require_in_range(try_solve(grasp, direction), grasp);
}

// 0 where friction locks the fingers, so that the motor has to work to release them.
double DesignEvaluator::release_efficiency(Grasp grasp) {
  const TensionState& released = try_solve(grasp, Direction::release);
  if (released.fault == TensionFault::motor_is_pulled) return 0;
  return motor_efficiency(network_, require_in_range(released, grasp), Direction::release);
}

const Mechanics& DesignEvaluator::solved_mechanics() {
  return model_solver_ ? model_solver_->solved() : mechanics_;
}

GraspOutcome DesignEvaluator::in_grasp(const WeightedGrasp& grasp, const EvaluationScope& scope) {
  GraspOutcome outcome;
  outcome.weight = grasp.weight;
  const TensionState& pulled = solve(grasp.grasp, Direction::pull);
  outcome.jams = pulled.jams;
  const FingerPulls pulls = finger_pulls(network_, pulled);
  outcome.pull = performance(network_, pulled, pulls);
  if (scope.indicators)
    outcome.indicators = indicators(network_, pulled, pulls, given_up_equivalent_);
  if (evaluates_hand(scope) &&
      !opens_fingers(network_, mechanics_, grasp.grasp, kinematics_, motion_)) {
    outcome.grip = grip(pulled, grasp.grasp);
  }
  if (!scope.release) return outcome;
  outcome.round_trip_efficiency =
      round_trip_efficiency(outcome.pull.efficiency, release_efficiency(grasp.grasp));
  return outcome;
}

// One motor, or several that all pull together, do so in `pulled`.
GripDemand DesignEvaluator::grip(const TensionState& pulled, Grasp grasp) {
  const HandPulls pulls = hand_pulls(network_, grasp, [&](const Grasp& alone) {
    const TensionState& state = alone == grasp ? pulled : solve(alone, Direction::pull);
    return SolvedGrasp{state, solved_mechanics()};
  });
  return grip_demand(*hand_, network_.fingers, pulls, grasp);
}

// Without blocks a tendon gives to its strands what the carriage takes from it. One that has none
// lets the carriage not move.
double DesignEvaluator::travel() {
  double strands = 0;
  double motor_sides = 0;
  for (std::size_t i = 0; i < network_.segments.size(); ++i) {
    const SegmentKind kind = network_.segments[i].kind;
    if (kind == SegmentKind::strand) ++strands;
    if (kind == SegmentKind::motor_side) motor_sides += mechanics_.spool(i);
  }
  if (strands == 0) return 0;
  if (network_.blocks.empty() && !network_.shared && !blocks_the_carriage(network_)) {
    return strands / motor_sides;
  }
  const bool is_known = is_shared_ && shared_->solve(Grasp{}, Direction::pull, state_);
  if (!is_known) kinematics_.solve(network_, mechanics_, Grasp{}, Direction::pull, motion_);
  const std::vector<double>& closing_of = is_known ? state_.closing : motion_.closing;
  double closing = 0;
  for (const Segment& segment : network_.segments) {
    if (segment.kind != SegmentKind::strand) continue;
    closing += segment.way() * closing_of[static_cast<std::size_t>(segment.finger - 1)];
  }
  return strands / closing;
}

bool DesignEvaluator::evaluates_hand(const EvaluationScope& scope) const {
  return scope.hand && hand_ && first_unknown_finger(*hand_, network_.fingers) == 0;
}

HandOutcome DesignEvaluator::hand_outcome() {
  HandOutcome outcome{0, 1, hand_->motor.close_s, {}};
  const double force_N = motor_forces(outcome_).front();
  SeriesStretch all;
  double longest_mm = 0;
  for (const Grasp& open : open_grasps_) {
    if (opens_fingers(network_, mechanics_, open, kinematics_, motion_)) continue;
    const HandClosing closing =
        close_hand(*hand_, network_, mechanics_, kinematics_, motion_, open);
    outcome.closure = std::min(outcome.closure, closing.closure);
    for (std::size_t motor = 0; motor < max_carriages; ++motor) {
      double& stroke = outcome.strokes_mm[motor];
      stroke = std::max(stroke, closing.strokes_mm[motor]);
      outcome.stroke_mm = std::max(outcome.stroke_mm, stroke);
    }
    if (mechanics_.springs_mm.empty()) continue;
    const SeriesStretch stretch = stretch_from(open);
    longest_mm = std::max(longest_mm, closing.stroke_mm + stretch.travel_mm(force_N));
    all = greatest(all, stretch);
  }
  if (mechanics_.springs_mm.empty()) return outcome;
  outcome.leaves_out_springs = !is_counted(all, outcome.closure, force_N);
  if (!outcome.leaves_out_springs) outcome.stroke_mm = outcome.strokes_mm.front() = longest_mm;
  return outcome;
}

// The most of the grasps with that open hand, which are evaluated already.
SeriesStretch DesignEvaluator::stretch_from(const Grasp& open) const {
  SeriesStretch stretch;
  for (std::size_t g = 0; g < outcome_.grasps.size(); ++g) {
    if (opened(grasps_[g].grasp) != open) continue;
    stretch = greatest(stretch, outcome_.grasps[g].grip.stretch);
  }
  return stretch;
}

const DesignOutcome& DesignEvaluator::outcome(const Routing& routing,
                                              const EvaluationScope& scope) {
  try {
    find_outcome(routing, scope);
  } catch (const OutOfRange& error) {
    throw error.at("routing '" + to_word(routing) + "'");
  }
  return outcome_;
}

bool DesignEvaluator::has_tensions(const Routing& routing) {
  try {
    find_outcome(routing, {false, false, false, false, false});
  } catch (const OutOfRange&) {
    return false;
  }
  return true;
}

// A seized contact splits it.
const Network& DesignEvaluator::moving_network() const {
  return model_solver_ ? model_solver_->network() : network_;
}

const Mechanics& DesignEvaluator::moving_mechanics() const {
  return model_solver_ ? model_solver_->plain() : mechanics_;
}

std::vector<Grasp> DesignEvaluator::smallest_jams(const Routing& routing) {
  set_routing(routing);
  return jam_finder_.smallest(moving_network(), moving_mechanics());
}

void DesignEvaluator::set_routing(const Routing& routing) {
  expand(routing, network_);
  builder_.apply(network_, mechanics_);
  builder_.require_in_range(network_, mechanics_);
  if (model_solver_) {
    word_ = needs_word_ ? to_word(routing) : "";
    model_solver_->set_routing(word_, network_, mechanics_);
  }
}

double DesignEvaluator::jams() {
  return is_shared_ ? shared_->jams() : jam_finder_.grasps(moving_network(), moving_mechanics());
}

// A model that changes exponents does so with the drawn ones, too.
ContactQuantiles DesignEvaluator::contact_quantiles() {
  builder_.deviations(network_, deviations_);
  const auto solve = [this](const Mechanics& drawn, Grasp grasp,
                            bool again) -> const TensionState& {
    if (model_solver_) {
      model_solver_->set_friction(drawn);
      return require_in_range(model_solver_->solve(grasp, Direction::pull, model_->conditions),
                              grasp);
    }
    if (again) {
      solver_.solve_again(network_, drawn, grasp, Direction::pull, state_);
    } else {
      solver_.solve(network_, drawn, grasp, Direction::pull, state_);
    }
    return require_in_range(state_, grasp);
  };
  return contact_finder_.find(network_, mechanics_, deviations_, grasps_, solve);
}

void DesignEvaluator::find_outcome(const Routing& routing, const EvaluationScope& scope) {
  set_routing(routing);
  is_shared_ = shared_ && shared_->set_routing(routing);
  if (scope.indicators) given_up_equivalent_ = closing_alike_.given_up(network_, mechanics_);
  outcome_.grasps.clear();
  for (const WeightedGrasp& grasp : grasps_) outcome_.grasps.push_back(in_grasp(grasp, scope));
  outcome_.parts = parts(network_);
  outcome_.travel = travel();
  if (prices_) outcome_.cost = cost(outcome_.parts, tendon_length(mechanics_), *prices_);
  outcome_.jams_all = scope.jamming ? jams() : 0;
  outcome_.where_contacts_scatter = scope.contacts ? contact_quantiles() : ContactQuantiles{};
  outcome_.hand = evaluates_hand(scope) ? hand_outcome() : HandOutcome{};
}

ObjectiveValues DesignEvaluator::evaluate(const Routing& routing, const EvaluationScope& scope) {
  ObjectiveValues values{};
  compute_objectives(outcome(routing, scope), values);
  add_score(score_, values);
  return values;
}

}  // namespace reeve::search
