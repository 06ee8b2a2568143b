#include "diagnosis/plan/next_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "causes/model_solver.hpp"
#include "diagnosis/fit/scatter_samples.hpp"
#include "numerics/matrices.hpp"

namespace reeve::diagnosis {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double normal_quantile = 1.959963984540054;  // two-sided, 95 %
// Least log-likelihood that a separation must be expected to bring; with less it would never
// decide.
constexpr double least_log_likelihood = 0.5;
// Narrowing an interval by less than half a percent is no reason to measure.
constexpr double least_narrowing = 0.005;
// A reading beyond so many times whatever the rig has shown or the motor pulls is no advice:
// sensors need not reach there, and no model was ever tried there.
constexpr double outlier_beyond = 3;

double greatest_tension(const MeasuredData& data) {
  double greatest = 0;
  for (const Reading& reading : data.readings) {
    for (const auto& tension : reading.tension_N) {
      if (tension) greatest = std::max(greatest, *tension);
    }
  }
  return greatest;
}

std::optional<std::size_t> column_of(const MeasuredData& data, const Segment& segment) {
  const auto found = std::ranges::find(data.channels, segment, &Channel::segment);
  if (found == data.channels.end()) return std::nullopt;
  return static_cast<std::size_t>(found - data.channels.begin());
}

// The middle, the least and the greatest that were measured, and what a rig could do beyond; none
// of what was not measured.
std::vector<double> levels(const MeasuredData& data, std::optional<double> Reading::*value,
                           const std::vector<double>& beyond) {
  std::vector<double> seen;
  for (const Reading& reading : data.readings) {
    if (reading.*value) seen.push_back(*(reading.*value));
  }
  if (seen.empty()) return {};
  std::ranges::sort(seen);
  std::vector<double> all{seen[seen.size() / 2], seen.front(), seen.back()};
  all.insert(all.end(), beyond.begin(), beyond.end());
  std::vector<double> once;
  for (const double x : all) {
    if (std::ranges::find(once, x) == once.end()) once.push_back(x);
  }
  return once;
}

// Every measurement of one routing; conditions are varied one at a time, and the load with each.
class Measurements {
 public:
  explicit Measurements(const MeasuredData& data)
      : load_(levels(data, &Reading::motor_tension_N, {5, 20, 50})),
        speed_(levels(data, &Reading::speed_mm_s, {1, 100})),
        cycle_(levels(data, &Reading::cycle, {0, 1000})),
        temperature_(levels(data, &Reading::temperature_C, {10, 40})) {
    if (load_.empty()) load_ = {Conditions{}.motor_tension_N};
  }

  void for_each(const std::function<void(const Conditions&)>& use) const {
    Conditions usual;
    if (!speed_.empty()) usual.speed_mm_s = speed_.front();
    if (!cycle_.empty()) usual.cycle = cycle_.front();
    if (!temperature_.empty()) usual.temperature_C = temperature_.front();
    for (const double load : load_) {
      if (load <= 0) continue;
      Conditions at = usual;
      at.motor_tension_N = load;
      use(at);
      vary(at, &Conditions::speed_mm_s, speed_, use);
      vary(at, &Conditions::cycle, cycle_, use);
      vary(at, &Conditions::temperature_C, temperature_, use);
    }
  }

 private:
  static void vary(const Conditions& from, double Conditions::*what,
                   const std::vector<double>& levels,
                   const std::function<void(const Conditions&)>& use) {
    Conditions at = from;
    for (std::size_t i = 1; i < levels.size(); ++i) {
      at.*what = levels[i];
      use(at);
    }
  }

  std::vector<double> load_, speed_, cycle_, temperature_;
};

// Readings of all strands and of the channels that the data have.
class Reader {
 public:
  Reader(const MeasurementPlan& plan, const MeasurableRouting& routing, const Network& network)
      : word_(routing.word), network_(network), shown_N_(greatest_tension(*plan.data)) {
    for (std::size_t i = 0; i < network.segments.size(); ++i) {
      const Segment& segment = network.segments[i];
      const std::optional<std::size_t> column = column_of(*plan.data, segment);
      if (segment.kind != SegmentKind::strand && !column) continue;
      segments_.push_back(i);
      sensors_.push_back({segment, 0, column});
    }
  }

  // Empty if the model has no tensions there, or tensions far beyond the rig's.
  VectorXd operator()(const Model& model, Grasp grasp, Direction direction,
                      const Conditions& conditions) const {
    const Hardware hardware = effective_hardware(model);
    if (fault(hardware)) return {};
    ModelSolver solver(model, hardware, word_, network_);
    const Conditions pulled = at_tendon(model, direction, conditions);
    const TensionState& state = solver.solve(actual_grasp(model, word_, grasp), direction, pulled);
    if (!state.in_range) return {};
    std::vector<Sensor> sensors = sensors_;
    for (std::size_t i = 0; i < segments_.size(); ++i) {
      sensors[i].reading_N = pulled.motor_tension_N * state.tension[segments_[i]];
    }
    causes::read(model, direction, conditions, sensors);
    VectorXd result(static_cast<Index>(sensors.size()));
    for (std::size_t i = 0; i < sensors.size(); ++i) {
      result[static_cast<Index>(i)] = sensors[i].reading_N;
    }
    const double reach = outlier_beyond * std::max(shown_N_, conditions.motor_tension_N);
    return (result.array() <= reach).all() ? result : VectorXd();
  }

  std::vector<NumberedContact> contacts() const {
    std::vector<NumberedContact> result;
    for (const Contact& contact : network_.contacts) {
      const auto number = std::ranges::count(result, contact.kind,
                                             [](const NumberedContact& one) { return one.kind; });
      result.push_back({contact.kind, static_cast<std::size_t>(number)});
    }
    return result;
  }

  std::string segment(Index i) const {
    return segment_name(network_.segments[segments_[static_cast<std::size_t>(i)]]);
  }

 private:
  std::string word_;
  const Network& network_;
  double shown_N_;
  std::vector<std::size_t> segments_;
  std::vector<Sensor> sensors_;  // parallel
};

VectorXd deviation(const MeasurementPlan& plan, const VectorXd& reading) {
  return reading.unaryExpr([&](double level) { return plan.noise.deviation(level); });
}

std::vector<ExpectedReading> expected_readings(const Reader& reader, const VectorXd& first,
                                               const VectorXd& second, const VectorXd& sd) {
  std::vector<ExpectedReading> result;
  for (Index i = 0; i < first.size(); ++i) {
    result.push_back({reader.segment(i), first[i], second[i], sd[i]});
  }
  return result;
}

using Visit = std::function<void(const Reader&, const Measurement&)>;

void for_each_measurement(const MeasurementPlan& plan, const Visit& visit) {
  const Measurements measurements(*plan.data);
  for (const MeasurableRouting& routing : plan.routings) {
    const Network network = expand(routing.routing);
    const Reader reader(plan, routing, network);
    const GraspSet grasps =
        network.fingers > 0 ? single_grasps(network.fingers) : GraspSet{{Grasp{}, 1}};
    for (const WeightedGrasp& grasp : grasps) {
      for (const Direction direction : {Direction::pull, Direction::release}) {
        measurements.for_each([&](const Conditions& conditions) {
          visit(reader, {routing, grasp.grasp, direction, conditions});
        });
      }
    }
  }
}

bool depends_on(const Reader& reader, const Model& model, const Measurement& at,
                double Conditions::*what) {
  const VectorXd here = reader(model, at.grasp, at.direction, at.conditions);
  Conditions other = at.conditions;
  other.*what = 1.5 * other.*what + 5;
  const VectorXd there = reader(model, at.grasp, at.direction, other);
  return here.size() > 0 && there.size() == here.size() &&
         (here - there).norm() > 1e-9 * here.norm();
}

void mark_conditions(const Reader& reader, const std::vector<const Model*>& models,
                     Measurement& at) {
  for (const Model* model : models) {
    at.uses_speed |= depends_on(reader, *model, at, &Conditions::speed_mm_s);
    at.uses_cycle |= depends_on(reader, *model, at, &Conditions::cycle);
    at.uses_temperature |= depends_on(reader, *model, at, &Conditions::temperature_C);
  }
}

// Rows are the parameters' derivatives of the readings, in units of the noise.
MatrixXd jacobian(const MeasurementPlan& plan, const Reader& reader, const Model& model,
                  const Measurement& at) {
  const VectorXd here = reader(model, at.grasp, at.direction, at.conditions);
  if (here.size() == 0) return {};
  const VectorXd sd = deviation(plan, here);
  MatrixXd result = MatrixXd::Zero(here.size(), static_cast<Index>(parameter_count(model)));
  Index column = 0;
  for (std::size_t e = 0; e < model.effects.size(); ++e) {
    const auto parameters = model.effects[e].cause->parameters(model.hardware);
    for (std::size_t p = 0; p < parameters.size(); ++p, ++column) {
      const double step = 1e-4 * (parameters[p].range.high - parameters[p].range.low);
      const double value = model.effects[e].values[p];
      const double to = value + step <= parameters[p].range.high ? value + step : value - step;
      Model moved = model;
      moved.effects[e].values[p] = to;
      const VectorXd there = reader(moved, at.grasp, at.direction, at.conditions);
      if (there.size() != here.size()) return {};
      result.col(column) = (there - here).cwiseQuotient(sd) / (to - value);
    }
  }
  return result;
}

// The change of the readings by a relative change of this contact's exponent.
VectorXd by_exponent(const Reader& reader, const Model& model, const Measurement& at,
                     const NumberedContact& contact) {
  constexpr double step = 1e-4;
  const auto there = [&](double change) {
    const ChangedExponents exponents([&](double phi, const ContactLoad& load) {
      return contact.is(load) ? phi * (1 + change) : phi;
    });
    Model changed = model;
    add_effect(changed, {&exponents, {}, {}});
    return reader(changed, at.grasp, at.direction, at.conditions);
  };
  const VectorXd more = there(step), less = there(-step);
  if (more.size() == 0 || less.size() == 0) return VectorXd();
  return (more - less) / (2 * step);
}

// L, in units of the noise.
MatrixXd loadings(const MeasurementPlan& plan, const Reader& reader, const Model& model,
                  const Measurement& at, const VectorXd& here) {
  const auto tau = [&](Mounted kind) { return plan.mounting[static_cast<std::size_t>(kind)]; };
  const Index n = here.size();
  std::vector<VectorXd> columns{tau(Mounted::gain) * here};  // of the motor's pull
  for (const NumberedContact& contact : reader.contacts()) {
    const auto kind = mounted_kind(contact.kind);
    if (!kind || tau(*kind) == 0) continue;
    const VectorXd change = by_exponent(reader, model, at, contact);
    if (change.size() == n) columns.emplace_back(tau(*kind) * change);
  }
  MatrixXd result(n, 2 * n + static_cast<Index>(columns.size()));
  result.leftCols(n) = (tau(Mounted::gain) * here).asDiagonal();
  result.middleCols(n, n) = VectorXd::Constant(n, plan.zero_N).asDiagonal();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    result.col(2 * n + static_cast<Index>(c)) = columns[c];
  }
  return deviation(plan, here).cwiseInverse().asDiagonal() * result;
}

// Jᵀ C⁻¹ J of columns J in units of the noise.
MatrixXd information(const MatrixXd& columns, const MatrixXd& loadings) {
  MatrixXd covariance = loadings * loadings.transpose();
  covariance.diagonal().array() += 1.0 / planned_readings;
  return columns.transpose() * inverse_of_symmetric(covariance) * columns;
}

double width(const MatrixXd& information, Index parameter) {
  const MatrixXd damped = information + 1e-12 * MatrixXd(information.diagonal().asDiagonal());
  const VectorXd column = solve_symmetric(damped, VectorXd::Unit(information.cols(), parameter));
  return 2 * normal_quantile * std::sqrt(std::max(column[parameter], 0.0));
}

std::optional<PlannedMeasurement> separating(const MeasurementPlan& plan, const Model& a,
                                             const Model& b) {
  std::optional<PlannedMeasurement> best;
  for_each_measurement(plan, [&](const Reader& reader, const Measurement& at) {
    const VectorXd first = reader(a, at.grasp, at.direction, at.conditions);
    const VectorXd second = reader(b, at.grasp, at.direction, at.conditions);
    if (first.size() == 0 || first.size() != second.size()) return;
    const VectorXd sd = deviation(plan, (first + second) / 2);
    const VectorXd apart = (first - second).cwiseQuotient(sd);
    const double brought = information(apart, loadings(plan, reader, a, at, first))(0, 0) / 2;
    // A percent more is no reason to prefer a stranger measurement to one that was met before.
    if (brought < least_log_likelihood ||
        (best && brought <= 1.01 * best->expected_log_likelihood)) {
      return;
    }
    best = PlannedMeasurement{};
    best->measurement = at;
    best->expected_log_likelihood = brought;
    best->expected = expected_readings(reader, first, second, sd);
    mark_conditions(reader, {&a, &b}, best->measurement);
  });
  return best;
}

}  // namespace

MeasurementPlan measurement_plan(const Dataset& dataset,
                                 const std::vector<MeasurableRouting>& further,
                                 const Scatter& scatter) {
  const MountedScatter& mounting = scatter.mounting.relative;
  const double zero = mounting[static_cast<std::size_t>(Mounted::zero)];
  MeasurementPlan plan{dataset.data, {}, scatter.noise, mounting, zero * median_reading(dataset)};
  const auto add = [&](const MeasurableRouting& routing) {
    const auto known = std::ranges::find(plan.routings, routing.word, &MeasurableRouting::word);
    if (known == plan.routings.end()) plan.routings.push_back(routing);
  };
  for (const MeasuredRouting& measured : dataset.data->routings)
    add({measured.word, measured.routing});
  for (const MeasurableRouting& routing : further) add(routing);
  return plan;
}

std::optional<PlannedMeasurement> separating_measurement(const MeasurementPlan& plan,
                                                         const std::vector<Model>& models,
                                                         const std::vector<std::string>& names) {
  for (std::size_t i = 1; i < names.size(); ++i) {
    auto found = separating(plan, models[0], models[i]);
    if (!found) continue;
    found->between = {names[0], names[i]};
    found->why = fmt::format(
        "{} and {} predict different tensions there: {} readings are expected to favour "
        "the right one by {:.3g} nats",
        names[0], names[i], planned_readings, found->expected_log_likelihood);
    return found;
  }
  return std::nullopt;
}

std::optional<PlannedMeasurement> shrinking_measurement(const MeasurementPlan& plan,
                                                        const Problem& problem, const Model& model,
                                                        std::size_t effect) {
  const MatrixXd known = sensitivities(problem, model, forecast(*problem.dataset, model));
  if (known.cols() == 0 || model.effects[effect].values.empty()) return std::nullopt;
  const MatrixXd before = known.transpose() * known;
  Index parameter = 0;
  for (std::size_t e = 0; e < effect; ++e) {
    parameter += static_cast<Index>(model.effects[e].values.size());
  }
  const double now = width(before, parameter);
  std::optional<PlannedMeasurement> best;
  for_each_measurement(plan, [&](const Reader& reader, const Measurement& at) {
    const MatrixXd rows = jacobian(plan, reader, model, at);
    if (rows.rows() == 0) return;
    const VectorXd here = reader(model, at.grasp, at.direction, at.conditions);
    const MatrixXd shared = loadings(plan, reader, model, at, here);
    const double then = width(before + information(rows, shared), parameter);
    if (then > (1 - least_narrowing) * now || (best && then >= 0.99 * best->width_expected)) return;
    best = PlannedMeasurement{};
    best->measurement = at;
    best->width_now = now;
    best->width_expected = then;
    best->expected = expected_readings(reader, here, here, deviation(plan, here));
    mark_conditions(reader, {&model}, best->measurement);
  });
  if (!best) return best;
  const Effect& named = model.effects[effect];
  best->parameter = named.cause->parameters(model.hardware).front().name;
  best->why = fmt::format(
      "it reduces the uncertainty of {} of {} most: {} readings are expected to narrow its 95 % CI "
      "by {:.0f} %",
      best->parameter, effect_name(named), planned_readings,
      100 * (1 - best->width_expected / now));
  return best;
}

}  // namespace reeve::diagnosis
