#include "diagnosis/model/forecast.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>
#include <variant>

#include "causes/model_solver.hpp"
#include "core/error.hpp"
#include "diagnosis/model/sheath_angle.hpp"

namespace reeve::diagnosis {
namespace {

struct NoForecast {
  std::size_t reading = 0;
  std::string why;
};

Hardware hardware_of(const Model& model, const Block& block) {
  return effective_hardware(block.sheath_angle_rad
                                ? with_sheath_angle(model.hardware, *block.sheath_angle_rad)
                                : model.hardware,
                            model.effects);
}

class BlockForecast {
 public:
  BlockForecast(const Dataset& dataset, const Model& model, const Block& block,
                const Hardware& hardware, Forecast& forecast)
      : dataset_(dataset),
        model_(model),
        block_(block),
        routing_(dataset.data->routings[block.routing]),
        solver_(model, hardware, routing_.word, routing_.network),
        grasp_(actual_grasp(model, routing_.word, block.recorded)),
        by_row_(reaches(model, Reach::conditions) || reaches(model, Reach::load)),
        by_load_(reaches(model, Reach::load)),
        forecast_(forecast) {}

  // Whether the tensions of all its rows are in range.
  bool run() {
    const TensionState* state = nullptr;
    for (const std::size_t r : block_.rows) {
      const DatasetRow& row = dataset_.rows[r];
      if (state == nullptr || by_row_) state = &solve(row.conditions);
      forecast_.jams[r] = state->jams;
      if (row.has_motor_tension) {
        read(row, *state, row.conditions.motor_tension_N);
      } else {
        read_scaled(row, *state);
      }
    }
    return in_range_;
  }

 private:
  const TensionState& solve(const Conditions& conditions) {
    const TensionState& state = solver_.solve(grasp_, block_.direction, conditions);
    in_range_ &= state.in_range;
    return state;
  }

  double reading_at(const Cell& cell, double tension_N) const {
    return reading(model_, routing_.network.segments[cell.segment], tension_N);
  }

  void read(const DatasetRow& row, const TensionState& state, double motor_tension_N) {
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Cell& cell = dataset_.cells[i];
      forecast_.reading_N[static_cast<Eigen::Index>(i)] =
          reading_at(cell, motor_tension_N * state.tension[cell.segment]);
    }
  }

  // All readings are linear in the tension, up to an offset.
  void read_scaled(const DatasetRow& row, const TensionState& first) {
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
    read(row, *state, scale);
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Cell& cell = dataset_.cells[i];
      forecast_.by_scale[static_cast<Eigen::Index>(i)] =
          reading_at(cell, state->tension[cell.segment]) - reading_at(cell, 0);
    }
  }

  double fit_scale(const DatasetRow& row, const TensionState& state) const {
    double measured = 0;
    double by_scale = 0;
    for (std::size_t i = row.first; i < row.last; ++i) {
      const Cell& cell = dataset_.cells[i];
      const double zero = reading_at(cell, 0);
      measured += cell.measured_N - zero;
      by_scale += reading_at(cell, state.tension[cell.segment]) - zero;
    }
    return by_scale > 0 && measured > 0 ? measured / by_scale : 0;
  }

  const Dataset& dataset_;
  const Model& model_;
  const Block& block_;
  const MeasuredRouting& routing_;
  ModelSolver solver_;
  Grasp grasp_;
  bool by_row_;
  bool by_load_;
  Forecast& forecast_;
  bool in_range_ = true;
};

std::variant<Forecast, NoForecast> attempt(const Dataset& dataset, const Model& model) {
  const auto n = static_cast<Eigen::Index>(dataset.cells.size());
  Forecast result{Eigen::VectorXd::Zero(n), Eigen::VectorXd::Zero(n),
                  std::vector<bool>(dataset.rows.size(), false)};
  for (const Block& block : dataset.blocks) {
    const std::size_t reading = dataset.rows[block.rows.front()].reading;
    const Hardware hardware = hardware_of(model, block);
    if (const auto found = fault(hardware)) return NoForecast{reading, sentence(*found)};
    if (!BlockForecast(dataset, model, block, hardware, result).run()) {
      return NoForecast{reading, "friction is so strong that tensions fall out of range"};
    }
  }
  return result;
}

}  // namespace

std::optional<Forecast> try_forecast(const Dataset& dataset, const Model& model) {
  auto result = attempt(dataset, model);
  if (std::holds_alternative<NoForecast>(result)) return std::nullopt;
  return std::get<Forecast>(std::move(result));
}

Forecast forecast(const Dataset& dataset, const Model& model) {
  auto result = attempt(dataset, model);
  if (const auto* none = std::get_if<NoForecast>(&result)) {
    const Reading& reading = dataset.data->readings[none->reading];
    throw OutOfRange(fmt::format("{}:{}: {}", dataset.data->file, reading.line, none->why));
  }
  return std::get<Forecast>(std::move(result));
}

}  // namespace reeve::diagnosis
