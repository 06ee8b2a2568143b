// The log of a rig that is simulated step by step, for tests of what finds steady readings in one:
// a carriage goes to and fro on a trapezoid of speed against a spring, the motor tension takes up
// the friction of the way with the stiffness of the tendon, and each strand sticks until its ratio
// to the motor tension reaches what it is while sliding. The truth is known at every sample.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace reeve::testing {

struct RigStrand {
  double pull = 0.5;     // T / T_M while the carriage pulls
  double release = 0.8;  // … while it releases
};

struct RigRun {
  std::string run = "1";
  std::string routing = "M-1-T-2-F";
  std::string held;
  std::vector<RigStrand> strands;
};

struct RigPlan {
  double rate_hz = 100;
  int strokes = 4;      // each out and back
  double dwell_s = 1;   // at both ends
  double ramp_s = 0.2;  // to full speed
  double even_s = 4;    // at full speed
  double speed_mm_s = 10;
  double least_load_N = 5;  // behind the friction, at the ends of the stroke
  double greatest_load_N = 30;
  double stiffness_N_mm = 8;  // of the tendon
  double noise = 0.01;        // standard deviation, relative
  double noise_N = 0.02;
  double correlation = 0;  // of the noise, from one sample to the next
  std::uint64_t seed = 1;
};

struct RigSample {
  std::size_t run = 0;
  double time_s = 0;
  double position_mm = 0;
  double speed_mm_s = 0;
  double motor_N = 0;  // true
  std::vector<double> strands_N;
  bool slides = false;  // along every strand
  double motor_read_N = 0;
  std::vector<double> strands_read_N;
};

// Run after run, the clock going on.
std::vector<RigSample> rig_log(const RigPlan& plan, const std::vector<RigRun>& runs);

// time_s,[position_mm,][speed_mm_s,]motor_tension_N,T1_N,…; with the columns run,routing,held too
// if there is more than one run.
struct RigColumns {
  bool position = true;
  bool speed = false;
  bool labels = false;
};
std::string rig_csv(const std::vector<RigSample>& samples, const std::vector<RigRun>& runs,
                    const RigColumns& columns = {});

// Noise of deviation 1 that goes on from sample to sample.
std::vector<double> correlated_noise(std::size_t count, double correlation, std::uint64_t seed,
                                     std::uint32_t stream);

}  // namespace reeve::testing
