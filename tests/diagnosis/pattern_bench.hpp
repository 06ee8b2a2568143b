// Readings whose explanations can be worked out on paper: one routing at one load, offsets on the
// strands, noise of a known size, and causes that add their size times a pattern of the strands.
#pragma once

#include <fmt/format.h>

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/tension/tension.hpp"
#include "diagnosis/fit/problem.hpp"
#include "numerics/random.hpp"
#include "tests/diagnosis/read_dataset.hpp"

namespace reeve::testing {

// N on T1, T2, …
using Pattern = std::vector<double>;

// Of one size in a range, nominally 0, and on nothing in particular.
class MadeUpCause : public Cause {
 public:
  MadeUpCause(const char* name, Reach reach, Range range)
      : name_(name), reach_(reach), range_(range) {}

  const char* name() const override { return name_; }
  Reach reach() const override { return reach_; }
  const char* meaning() const override { return name_; }
  std::vector<Parameter> parameters(const Hardware&) const override {
    return {{"size", "", 0, range_, std::nullopt}};
  }
  std::vector<Subject> subjects(const Survey&) const override { return std::vector<Subject>(1); }

  Effect candidate() const { return {this, {}, {0}}; }

 private:
  const char* name_;
  Reach reach_;
  Range range_;
};

class PatternCause final : public MadeUpCause {
 public:
  PatternCause(const char* name, Pattern pattern, Range range = {-20, 20})
      : MadeUpCause(name, Reach::reading, range), pattern_(std::move(pattern)) {}

  double reading(double tension_N, const Segment& segment, const Effect& effect) const override {
    const auto strand = static_cast<std::size_t>(segment.number) - 1;
    return tension_N + (strand < pattern_.size() ? effect.values[0] * pattern_[strand] : 0);
  }

  Model model(double size) const {
    Model model;
    add_effect(model, {this, {}, {size}});
    return model;
  }

 private:
  Pattern pattern_;
};

inline constexpr double bench_noise_N = 0.05;

// The strands of M-1-T-2-F at 20 N, with these offsets: so many runs of so many rows.
struct BenchPlan {
  std::size_t runs = 5;
  std::size_t rows = 6;
  std::uint64_t seed = 1;
  double noise_N = bench_noise_N;
};

using OffsetsByRun = std::function<Pattern(std::size_t run)>;

inline std::string bench_csv(const BenchPlan& plan, const OffsetsByRun& offsets) {
  const Network network = expand(parse_routing("M-1-T-2-F"));
  const TensionState state = tensions(network, mechanics(network, {}), Grasp{});
  std::string text = "run,routing,motor_tension_N,T1_N,T2_N,T3_N,T4_N\n";
  std::uint64_t index = 0;
  for (std::size_t run = 0; run < plan.runs; ++run) {
    Pattern offset = offsets(run);
    offset.resize(4);
    for (std::size_t row = 0; row < plan.rows; ++row) {
      text += fmt::format("r{},M-1-T-2-F,20", run);
      for (std::size_t strand = 0; strand < 4; ++strand) {
        text += fmt::format(",{}", 20 * state.tension[strand + 1] + offset[strand] +
                                       plan.noise_N * normal(plan.seed, 0xbe7c4, index++));
      }
      text += '\n';
    }
  }
  return text;
}

// Stays where it is: dataset and problem point to what they are about.
struct Bench {
  MeasuredData data;
  Dataset dataset;
  Problem problem;

  explicit Bench(const Pattern& offset, const BenchPlan& plan = {})
      : Bench(plan, [&](std::size_t) { return offset; }) {}
  Bench(const BenchPlan& plan, const OffsetsByRun& offsets)
      : data(read_data(bench_csv(plan, offsets))) {
    dataset = all_of(data);
    const auto cells = static_cast<Eigen::Index>(dataset.cells.size());
    problem = reeve::problem(dataset, Eigen::VectorXd::Constant(cells, bench_noise_N));
  }
  Bench(const Bench&) = delete;
  Bench& operator=(const Bench&) = delete;
};

inline const PatternCause on_T1("on_T1", {1});
inline const PatternCause on_T2("on_T2", {0, 1});
inline const PatternCause on_T3("on_T3", {0, 0, 1});
inline const PatternCause nearly_on_T1("nearly_on_T1", {1, 0.03});

}  // namespace reeve::testing
