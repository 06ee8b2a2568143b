#include "search/coefficient_box.hpp"

namespace reeve {
namespace {

Interval around(double value, double relative) {
  return {value * (1 - relative), value * (1 + relative)};
}

}  // namespace

CoefficientBox coefficient_box(const Hardware& nominal, const UncertaintyRanges& ranges) {
  return {Interval{ranges.tube_mu.low, ranges.tube_mu.high},
          Interval{ranges.sheath_mu.low, ranges.sheath_mu.high},
          around(nominal.bearing.mu, ranges.bearing_mu_relative),
          around(nominal.sheath.angle_rad, ranges.sheath_angle_relative)};
}

Hardware at_point(const Hardware& nominal, const std::vector<double>& point) {
  Hardware hardware = nominal;
  hardware.tube.mu = point[0];
  hardware.sheath.mu = point[1];
  hardware.bearing.mu = point[2];
  hardware.sheath.angle_rad = point[3];
  return hardware;
}

}  // namespace reeve
