// The part of measured data that a model is judged on, laid out for predicting it again and again.
//
// Readings are grouped into blocks of one routing, grasp, direction and sheath angle, which share a
// network and often a solution. A cell is one measured tension.
#pragma once

#include <cstddef>
#include <vector>

#include "causes/cause.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

struct Cell {
  std::size_t reading = 0;  // in MeasuredData::readings
  std::size_t channel = 0;  // in MeasuredData::channels
  std::size_t segment = 0;  // in the routing's network
  double measured_N = 0;
  std::size_t row = 0;  // in the dataset
};

// One reading that is compared: cells first … last - 1.
struct DatasetRow {
  std::size_t reading = 0;
  std::size_t first = 0;
  std::size_t last = 0;
  bool has_motor_tension = true;
  double motor_deviation_N = 0;  // standard deviation of the motor tension; 0: exact
  Conditions conditions;
};

struct ReadingBlock {
  std::size_t routing = 0;
  Grasp recorded;
  Direction direction = Direction::pull;
  std::optional<double> sheath_angle_rad;
  std::vector<std::size_t> rows;
};

struct Dataset {
  const MeasuredData* data = nullptr;  // must outlive the dataset
  std::vector<Cell> cells;             // by row
  std::vector<DatasetRow> rows;        // in the order of the readings
  std::vector<ReadingBlock> blocks;
  // Cells less one for each row without motor tension, whose scale is free.
  double degrees_of_freedom() const;
};

// A row without motor tension needs two measured segments that are not both slack to say anything,
// and one with it a tension above 0.
enum class Rows { that_say_something, all };

// Returns a dataset of these readings (ascending).
Dataset dataset(const MeasuredData& data, const std::vector<std::size_t>& readings,
                Rows rows = Rows::that_say_something);

// Return the index of each row and cell of a part among all. A part has all cells of its readings.
std::vector<std::ptrdiff_t> rows_of_part(const Dataset& all, const Dataset& part);
std::vector<std::ptrdiff_t> cells_of_part(const Dataset& all, const Dataset& part);

// The middle load of the readings over that which ranges in newton are written for (range_load_N):
// motor tensions, or where there are none the sums of the readings.
double force_scale(const MeasuredData& data);

// Returns the medians of what these readings record (of an even number the lower one, which was
// recorded): under these a design is judged by a model of theirs.
Conditions typical_conditions(const MeasuredData& data, const std::vector<std::size_t>& readings);

// Returns the kinds of cause that the data could show.
Survey survey(const MeasuredData& data);

}  // namespace reeve::diagnosis
