#include "diagnosis/fit/forecast.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "causes/model_solver.hpp"
#include "core/error.hpp"
#include "core/network.hpp"

namespace reeve::diagnosis {
namespace {

// A sheath lies between a motor-side segment and one at the hand; the pulley of a P lies between
// two motor-side segments.
bool is_sheath(const ContactHardware& contact) {
  const auto is_motor_side = [](const std::string& segment) {
    return parse_segment(segment).kind == SegmentKind::motor_side;
  };
  return is_motor_side(contact.segment) != is_motor_side(contact.other_segment);
}

// Prepares what the hardware makes of a network at a row's own sheath angle once for all rows that
// follow with the same.
class MechanicsByAngle {
 public:
  explicit MechanicsByAngle(const Model& model) : model_(model) {}

  // Throws InputError if there is no such hardware.
  const MechanicsBuilder& at(std::optional<double> sheath_angle_rad) {
    if (!builder_ || angle_rad_ != sheath_angle_rad) {
      angle_rad_ = sheath_angle_rad;
      builder_.emplace(effective_hardware(
          angle_rad_ ? with_sheath_angle(model_.hardware, *angle_rad_) : model_.hardware,
          model_.effects));
    }
    return *builder_;
  }

 private:
  const Model& model_;
  std::optional<double> angle_rad_;
  std::optional<MechanicsBuilder> builder_;
};

class RoutingForecast {
 public:
  RoutingForecast(const Dataset& dataset, const Model& model, std::size_t routing,
                  MotorSlopes slopes, Forecast& forecast, RowContacts* contacts)
      : dataset_(dataset),
        model_(model),
        routing_(dataset.data->routings[routing]),
        solver_(model),
        by_row_(reaches(model, Reach::conditions) || reaches(model, Reach::load)),
        by_load_(reaches(model, Reach::load)),
        linear_(reads_linearly(model)),
        slopes_(slopes),
        forecast_(forecast),
        contacts_(contacts) {
    for (std::size_t c = 0; c < routing_.segments.size(); ++c) {
      if (!routing_.segments[c]) continue;
      place_.resize(c + 1);
      place_[c] = sensors_.size();
      sensors_.push_back({routing_.network.segments[*routing_.segments[c]], 0, c});
      segments_.push_back(*routing_.segments[c]);
    }
    readings_.setZero(static_cast<Eigen::Index>(sensors_.size()));
  }

  // True if the tensions of all rows of this block are in range.
  bool run(const ReadingBlock& block, const MechanicsBuilder& builder) {
    builder.apply(routing_.network, plain_);
    solver_.set_routing(routing_.word, routing_.network, plain_);
    grasp_ = actual_grasp(model_, routing_.word, block.recorded);
    direction_ = block.direction;
    in_range_ = true;
    const TensionState* state = nullptr;
    for (const std::size_t r : block.rows) {
      const DatasetRow& row = dataset_.rows[r];
      const Conditions conditions =
          row.has_motor_tension ? at_tendon(model_, direction_, row.conditions) : row.conditions;
      if (state == nullptr || by_row_) state = &solve(conditions);
      forecast_.jams[r] = state->jams;
      if (row.has_motor_tension) {
        read_at(row, *state, conditions.motor_tension_N, of_row(forecast_.reading_N, row));
        note_contacts(r, conditions.motor_tension_N);
        if (slopes_ == MotorSlopes::left_out) continue;
        auto slopes = of_row(forecast_.by_scale, row);
        if (by_load_) {
          write_slope_by_load(row, slopes);
        } else {
          write_slope(row, *state, conditions.motor_tension_N, slopes);
          slopes *= arriving(row);
        }
      } else {
        note_contacts(r, read_scaled(row, *state));
      }
    }
    return in_range_;
  }

 private:
  using Cells = Eigen::Ref<Eigen::VectorXd>;

  const TensionState& solve(const Conditions& conditions) {
    const TensionState& state = solver_.solve(grasp_, direction_, conditions);
    in_range_ &= state.in_range;
    return state;
  }

  static Cells of_row(Eigen::VectorXd& cells, const DatasetRow& row) {
    return cells.segment(static_cast<Eigen::Index>(row.first),
                         static_cast<Eigen::Index>(row.last - row.first));
  }

  // Writes the readings of the row's cells. A sensor also reads a share of its neighbours'
  // tensions, even where these have no cell.
  void read_at(const DatasetRow& row, const TensionState& state, double scale, Cells cells) {
    for (std::size_t s = 0; s < sensors_.size(); ++s) {
      sensors_[s].reading_N = scale * state.tension[segments_[s]];
    }
    causes::read(model_, direction_, row.conditions, sensors_);
    for (Eigen::Index i = 0; i < cells.size(); ++i) {
      const Cell& cell = dataset_.cells[row.first + static_cast<std::size_t>(i)];
      cells[i] = sensors_[place_[cell.channel]].reading_N;
    }
  }

  Cells readings(const DatasetRow& row, const TensionState& state, double scale) {
    const Cells result = readings_.head(static_cast<Eigen::Index>(row.last - row.first));
    read_at(row, state, scale, result);
    return result;
  }

  void note_contacts(std::size_t row, double motor_tension_N) {
    if (contacts_ == nullptr) return;
    std::vector<causes::SolvedContact>& own = (*contacts_)[row];
    own = solver_.contacts();
    for (causes::SolvedContact& contact : own) contact.high *= motor_tension_N;
  }

  // Returns the scale.
  double read_scaled(const DatasetRow& row, const TensionState& first) {
    constexpr int rounds = 30;
    constexpr double settled = 1e-9;
    const TensionState* state = &first;
    double scale = fit_scale(row, *state);
    for (int i = 0; by_load_ && i < rounds; ++i) {
      Conditions conditions = row.conditions;
      conditions.motor_tension_N = scale;
      state = &solve(conditions);
      const double last = std::exchange(scale, fit_scale(row, *state));
      if (std::abs(scale - last) <= settled * scale) break;
    }
    read_at(row, *state, scale, of_row(forecast_.reading_N, row));
    write_slope(row, *state, scale, of_row(forecast_.by_scale, row));
    return scale;
  }

  // This is the slope of the tension at the tendons against that recorded of the motor.
  double arriving(const DatasetRow& row) const {
    constexpr double step_N = 1e-3;
    if (!reaches(model_, Reach::motor)) return 1;
    const auto tension = [&](double more_N) {
      Conditions conditions = row.conditions;
      conditions.motor_tension_N += more_N;
      return at_tendon(model_, direction_, conditions).motor_tension_N;
    };
    return (tension(step_N) - tension(-step_N)) / (2 * step_N);
  }

  // Writes the slopes of the row's readings against the motor tension, which changes friction. The
  // step is small beside the curvature of laws and large beside the solver's tolerance of 1e-10.
  void write_slope_by_load(const DatasetRow& row, Cells slopes) {
    constexpr double share = 1e-5;
    constexpr double least_N = 1e-3;
    const double step_N = share * std::max(row.conditions.motor_tension_N, least_N);
    Conditions conditions = row.conditions;
    conditions.motor_tension_N += step_N;
    conditions = at_tendon(model_, direction_, conditions);
    read_at(row, solve(conditions), conditions.motor_tension_N, slopes);
    slopes = (slopes - of_row(forecast_.reading_N, row)) / step_N;
  }

  // Writes the slopes of the row's readings against the scale.
  void write_slope(const DatasetRow& row, const TensionState& state, double scale, Cells slopes) {
    constexpr double step = 1e-6;  // as a share of the scale
    const double from = linear_ ? 0 : scale;
    const double by = linear_ ? 1 : scale > 0 ? step * scale : step;
    read_at(row, state, from + by, slopes);
    slopes = (slopes - readings(row, state, from)) / by;
  }

  double fit_scale(const DatasetRow& row, const TensionState& state) {
    if (!linear_) return least_scale(row, state);
    const double zero = readings(row, state, 0).sum();
    const double by_scale = readings(row, state, 1).sum() - zero;
    const double measured = measured_sum(row) - zero;
    return by_scale > 0 && measured > 0 ? measured / by_scale : 0;
  }

  double measured_sum(const DatasetRow& row) const {
    double sum = 0;
    for (std::size_t i = row.first; i < row.last; ++i) sum += dataset_.cells[i].measured_N;
    return sum;
  }

  // Readings that do not fall with the scale, by halving: the least scale at which they add up to
  // what was measured, or to the most that they reach.
  double least_scale(const DatasetRow& row, const TensionState& state) {
    constexpr double beyond_any_rig_N = 1e9;
    constexpr int halvings = 100;
    const auto sum = [&](double scale) { return readings(row, state, scale).sum(); };
    const double target = std::min(measured_sum(row), sum(beyond_any_rig_N));
    double low = 0;
    double high = beyond_any_rig_N;
    for (int i = 0; i < halvings; ++i) {
      const double middle = (low + high) / 2;
      (sum(middle) < target ? low : high) = middle;
    }
    return high;
  }

  const Dataset& dataset_;
  const Model& model_;
  const MeasuredRouting& routing_;
  ModelSolver solver_;
  bool by_row_;
  bool by_load_;
  bool linear_;
  MotorSlopes slopes_;
  std::vector<Sensor> sensors_;        // sensors of the routing's channels
  std::vector<std::size_t> segments_;  // segments in the network, parallel to the sensors
  std::vector<std::size_t> place_;     // index of each channel among the sensors
  Forecast& forecast_;
  RowContacts* contacts_;
  // These are of the block at hand.
  Mechanics plain_;
  Grasp grasp_;
  Direction direction_ = Direction::pull;
  bool in_range_ = true;
  // Memory of `readings`, for a row of all channels. It is not resized: for want of memory Eigen
  // would free it twice.
  Eigen::VectorXd readings_;
};

// Throws OutOfRange that names the line.
Forecast attempt(const Dataset& dataset, const Model& model, MotorSlopes slopes,
                 RowContacts* contacts = nullptr) {
  const auto n = static_cast<Eigen::Index>(dataset.cells.size());
  Forecast result{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                  std::vector<bool>(dataset.rows.size(), false)};
  MechanicsByAngle mechanics(model);
  std::vector<std::optional<RoutingForecast>> routings(dataset.data->routings.size());
  for (const ReadingBlock& block : dataset.blocks) {
    std::optional<RoutingForecast>& routing = routings[block.routing];
    if (!routing) routing.emplace(dataset, model, block.routing, slopes, result, contacts);
    const auto out_of_range = [&](const char* why) {
      const Reading& first = dataset.data->readings[dataset.rows[block.rows.front()].reading];
      return OutOfRange(fmt::format("{}:{}: {}", dataset.data->file, first.line, why));
    };
    try {
      if (routing->run(block, mechanics.at(block.sheath_angle_rad))) continue;
    } catch (const InputError& error) {
      throw out_of_range(error.what());
    }
    throw out_of_range("friction is so strong that tensions fall out of range");
  }
  return result;
}

}  // namespace

Hardware with_sheath_angle(Hardware hardware, double angle_rad) {
  hardware.sheath.angle_rad = angle_rad;
  for (FingerHardware& finger : hardware.fingers) finger.sheath_angle_rad.reset();
  for (ContactHardware& contact : hardware.contacts) {
    if (is_sheath(contact)) contact.angle_rad.reset();
  }
  return hardware;
}

RowContacts contacts_of_rows(const Dataset& dataset, const Model& model) {
  RowContacts contacts(dataset.rows.size());
  attempt(dataset, model, MotorSlopes::left_out, &contacts);
  return contacts;
}

std::optional<Forecast> try_forecast(const Dataset& dataset, const Model& model,
                                     MotorSlopes slopes) {
  try {
    return attempt(dataset, model, slopes);
  } catch (const OutOfRange&) {
    return std::nullopt;
  }
}

std::optional<Eigen::VectorXd> reading_slope(const Dataset& dataset, const Model& less,
                                             const Model& more, double width) {
  const auto below = try_forecast(dataset, less, MotorSlopes::left_out);
  const auto above = try_forecast(dataset, more, MotorSlopes::left_out);
  if (!below || !above) return std::nullopt;
  return (above->reading_N - below->reading_N) / width;
}

Forecast forecast(const Dataset& dataset, const Model& model) {
  return attempt(dataset, model, MotorSlopes::solved);
}

}  // namespace reeve::diagnosis
