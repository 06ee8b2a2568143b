// A rig whose only unknown is linear, so that what a fit does with it can be worked out by hand:
// one finger on one tendon without friction, and a sensor at T1 that reads g T_M.
#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "causes/library.hpp"
#include "diagnosis/fit/problem.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {

inline constexpr double bench_deviation_N = 0.1;

struct BenchReading {
  std::string run;
  double motor_tension_N = 0;
  double reading_N = 0;
};

inline MeasuredData bench_data(const std::vector<BenchReading>& readings) {
  std::string text = "run,routing,motor_tension_N,T1_N\n";
  for (const BenchReading& reading : readings) {
    text +=
        fmt::format("{},M-1-F,{},{}\n", reading.run, reading.motor_tension_N, reading.reading_N);
  }
  return read_data(text);
}

inline Hardware frictionless() {
  Hardware hardware;
  for (ContactLaw* law : {&hardware.tube, &hardware.bearing, &hardware.sheath}) law->mu = 0;
  return hardware;
}

inline Model bench_model() { return Model{frictionless()}; }

inline Model with_gain(double gain) {
  Model model = bench_model();
  Subject subject;
  subject.channel = parse_segment("T1");
  add_effect(model, {find_cause("sensor_gain"), subject, {gain}});
  return model;
}

inline Problem bench_problem(const Dataset& dataset) {
  const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
  return problem(dataset, Eigen::VectorXd::Constant(cells, bench_deviation_N));
}

// g of the readings of all runs but one; least squares.
inline double gain_without(const std::vector<BenchReading>& readings, const std::string& run) {
  double along = 0, square = 0;
  for (const BenchReading& reading : readings) {
    if (reading.run == run) continue;
    along += reading.motor_tension_N * reading.reading_N;
    square += reading.motor_tension_N * reading.motor_tension_N;
  }
  return along / square;
}

}  // namespace reeve::testing
