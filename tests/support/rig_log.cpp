#include "tests/support/rig_log.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/random.hpp"

namespace reeve::testing {
namespace {

struct MotionPiece {
  double seconds = 0;
  double from_mm_s = 0;
  double to_mm_s = 0;
};

std::vector<MotionPiece> motion(const RigPlan& plan) {
  std::vector<MotionPiece> pieces;
  const double v = plan.speed_mm_s;
  for (int stroke = 0; stroke < plan.strokes; ++stroke) {
    for (const double way : {v, -v}) {
      pieces.push_back({plan.dwell_s, 0, 0});
      pieces.push_back({plan.ramp_s, 0, way});
      pieces.push_back({plan.even_s, way, way});
      pieces.push_back({plan.ramp_s, way, 0});
    }
  }
  pieces.push_back({plan.dwell_s, 0, 0});
  return pieces;
}

class Rig {
 public:
  Rig(const RigPlan& plan, const RigRun& run) : plan_(plan), run_(run) {
    for (const RigStrand& strand : run.strands) end_ = std::min(end_, strand.pull);
    for (const RigStrand& strand : run.strands) back_ = std::max(back_, strand.release);
    motor_N_ = plan.least_load_N / back_;
    for (const RigStrand& strand : run.strands) strands_N_.push_back(motor_N_ * strand.release);
  }

  // To a place of the carriage; whether every strand is at its bound.
  bool move(double position_mm) {
    const double stroke_mm = plan_.speed_mm_s * (plan_.even_s + plan_.ramp_s);
    const double load_N =
        plan_.least_load_N + (plan_.greatest_load_N - plan_.least_load_N) * position_mm / stroke_mm;
    const double way_mm = position_mm - position_mm_;
    const double low_N = load_N / back_;
    const double high_N = load_N / end_;
    motor_N_ = std::clamp(motor_N_ + plan_.stiffness_N_mm * way_mm, low_N, high_N);
    position_mm_ = position_mm;
    const auto at = [](double value, double bound) {
      return std::abs(value - bound) <= 1e-9 * bound;
    };
    bool slides = way_mm != 0;
    for (std::size_t i = 0; i < strands_N_.size(); ++i) {
      const double pulled_N = motor_N_ * run_.strands[i].pull;
      const double released_N = motor_N_ * run_.strands[i].release;
      strands_N_[i] = std::clamp(strands_N_[i], pulled_N, released_N);
      slides &= at(strands_N_[i], way_mm > 0 ? pulled_N : released_N);
    }
    return slides;
  }

  double motor_N() const { return motor_N_; }
  const std::vector<double>& strands_N() const { return strands_N_; }

 private:
  const RigPlan& plan_;
  const RigRun& run_;
  double end_ = 1e9;  // of the last strand, which the spring pulls
  double back_ = 0;
  double position_mm_ = 0;
  double motor_N_ = 0;
  std::vector<double> strands_N_;
};

void add_run(const RigPlan& plan, const std::vector<RigRun>& runs, std::size_t number,
             std::vector<RigSample>& samples) {
  Rig rig(plan, runs[number]);
  const double step_s = 1 / plan.rate_hz;
  double position_mm = 0;
  for (const MotionPiece& piece : motion(plan)) {
    const auto steps = static_cast<int>(std::lround(piece.seconds * plan.rate_hz));
    for (int i = 0; i < steps; ++i) {
      const double share = (i + 0.5) / steps;
      const double speed = piece.from_mm_s + share * (piece.to_mm_s - piece.from_mm_s);
      position_mm += speed * step_s;
      const bool slides = rig.move(position_mm);
      samples.push_back({number,
                         static_cast<double>(samples.size()) * step_s,
                         position_mm,
                         speed,
                         rig.motor_N(),
                         rig.strands_N(),
                         slides,
                         0,
                         {}});
    }
  }
}

}  // namespace

std::vector<double> correlated_noise(std::size_t count, double correlation, std::uint64_t seed,
                                     std::uint32_t stream) {
  std::vector<double> noise(count);
  for (std::size_t i = 0; i < count; ++i) {
    const double fresh = normal(seed, stream, i);
    noise[i] = i == 0
                   ? fresh
                   : correlation * noise[i - 1] + std::sqrt(1 - correlation * correlation) * fresh;
  }
  return noise;
}

std::vector<RigSample> rig_log(const RigPlan& plan, const std::vector<RigRun>& runs) {
  std::vector<RigSample> samples;
  for (std::size_t run = 0; run < runs.size(); ++run) add_run(plan, runs, run, samples);
  const auto read = [&](double true_N, double noise) {
    return true_N + (plan.noise * true_N + plan.noise_N) * noise;
  };
  const auto channels = static_cast<std::uint32_t>(runs[0].strands.size());
  for (std::uint32_t channel = 0; channel <= channels; ++channel) {
    const std::vector<double> noise =
        correlated_noise(samples.size(), plan.correlation, plan.seed, channel);
    for (std::size_t i = 0; i < samples.size(); ++i) {
      RigSample& sample = samples[i];
      if (channel == 0) {
        sample.motor_read_N = read(sample.motor_N, noise[i]);
      } else {
        sample.strands_read_N.push_back(read(sample.strands_N[channel - 1], noise[i]));
      }
    }
  }
  return samples;
}

std::string rig_csv(const std::vector<RigSample>& samples, const std::vector<RigRun>& runs,
                    const RigColumns& columns) {
  std::string csv = "time_s";
  if (columns.labels) csv += ",run,routing,held";
  if (columns.position) csv += ",position_mm";
  if (columns.speed) csv += ",speed_mm_s";
  csv += ",motor_tension_N";
  for (std::size_t i = 0; i < runs[0].strands.size(); ++i) csv += fmt::format(",T{}_N", i + 1);
  csv += "\n";
  for (const RigSample& sample : samples) {
    csv += fmt::format("{:.3f}", sample.time_s);
    if (columns.labels) {
      const RigRun& run = runs[sample.run];
      csv += fmt::format(",{},{},{}", run.run, run.routing, run.held);
    }
    if (columns.position) csv += fmt::format(",{:.3f}", sample.position_mm);
    if (columns.speed) csv += fmt::format(",{:.3f}", sample.speed_mm_s);
    csv += fmt::format(",{:.4f}", sample.motor_read_N);
    for (const double strand_N : sample.strands_read_N) csv += fmt::format(",{:.4f}", strand_N);
    csv += "\n";
  }
  return csv;
}

}  // namespace reeve::testing
