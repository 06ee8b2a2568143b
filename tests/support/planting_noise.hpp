// Noise of planted readings, and how likely a reading is under it.
//
//     reading = max(0, T (1 + r n1) + a n2),   n1, n2 standard normal, or both over the square root
//                                              of one chi-squared number, scaled to variance 1
//
// so that, above 0, it is normal about T with sd^2 = (r T)^2 + a^2. Seeds give the same numbers on
// every machine: the normal numbers are made here, from explicit bits (G. E. P. Box and
// M. E. Muller, 1958).
#pragma once

#include <cstdint>
#include <random>

namespace reeve::testing {

struct NoiseLevel {
  double relative = 0.01;
  double absolute_N = 0.02;
  // Of Student's t, with the same standard deviation; 0: normal. At least 3.
  int tail_degrees = 0;
  // Relative, from mounting to mounting (planting_mounting.hpp).
  double mounted_exponent = 0;
  double mounted_gain = 0;
  bool below_zero = false;  // the sensors read what is below 0, too
};

inline constexpr NoiseLevel low_noise{0.01, 0.02};
inline constexpr NoiseLevel high_noise{0.03, 0.05};

double standard_deviation(const NoiseLevel& noise, double mean_N);

// A reading of 0 stands for all below it.
double log_likelihood(const NoiseLevel& noise, double mean_N, double reading_N);

class NoiseSource {
 public:
  NoiseSource(const NoiseLevel& noise, std::uint64_t seed) : noise_(noise), engine_(seed) {}

  double reading(double mean_N);

 private:
  double uniform();  // in (0, 1]
  double stretch();  // of a heavier tail

  NoiseLevel noise_;
  std::mt19937_64 engine_;
};

}  // namespace reeve::testing
