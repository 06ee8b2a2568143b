// Forecast: expected readings of the sensors under a model, in each cell of a dataset.
//
//   with motor tension      p = reading(T_in t), T_in = at_tendon(T_M)
//   without                 p = reading(S t); the scale S of the row is such that the forecasts add
//                           up to the measured tensions, and du = dp/dS says how a cell follows it
//
// t: the model's tensions at T_in = 1 (for a load-dependent law: at the row's own tension). Where
// readings are not linear in the tension, S is found by halving: the least one of that sum, which
// is the most that the sensors can read together where more was measured.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

#include "causes/model.hpp"
#include "causes/model_solver.hpp"
#include "core/hardware.hpp"
#include "diagnosis/dataset.hpp"

namespace reeve::diagnosis {

// The hardware of a row that says its own wrap angle at the sheaths: over what the hardware says of
// a finger or a contact.
Hardware with_sheath_angle(Hardware hardware, double angle_rad);

// Slopes by a recorded motor tension take a further solve where friction depends on the load.
enum class MotorSlopes : std::uint8_t { solved, left_out };

struct Forecast {
  Eigen::VectorXd reading_N;  // parallel to the cells
  Eigen::VectorXd by_scale;   // by the motor tension; 0 where that is recorded and left out
  std::vector<bool> jams;     // parallel to the rows
};

// The contacts of each row, with the larger tension beside each in newton; where the motor tension
// is not recorded, at the scale that the row's readings tell.
using RowContacts = std::vector<std::vector<causes::SolvedContact>>;
// The model must have tensions.
RowContacts contacts_of_rows(const Dataset& dataset, const Model& model);

// Nothing where the model's tensions are out of range, or its hardware is none that there can be.
std::optional<Forecast> try_forecast(const Dataset& dataset, const Model& model,
                                     MotorSlopes slopes = MotorSlopes::solved);
// Readings by a value that is `width` more in one model than in the other, N per unit of it.
// Nothing where one of them has no tensions.
std::optional<Eigen::VectorXd> reading_slope(const Dataset& dataset, const Model& less,
                                             const Model& more, double width);
// Throws OutOfRange that names the line.
Forecast forecast(const Dataset& dataset, const Model& model);

}  // namespace reeve::diagnosis
