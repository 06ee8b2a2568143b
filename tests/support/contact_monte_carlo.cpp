#include "tests/support/contact_monte_carlo.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tests/support/random_routing.hpp"
#include "tests/support/reference_comparison.hpp"

namespace reeve::testing {
namespace {

double drawn_normal(Dice& dice) {
  const double radius = std::sqrt(-2 * std::log(1 - dice.real(0, 1)));
  return radius * std::cos(2 * std::numbers::pi * dice.real(0, 1));
}

double uniformity_of(const ReferenceResult& result) {
  double least = 1;
  double greatest = 0;
  for (const auto& [segment, tension] : result.tension) {
    if (segment.front() != 'T') continue;
    least = std::min(least, tension);
    greatest = std::max(greatest, tension);
  }
  return least / greatest;
}

ReferenceHardware drawn_kinds(ReferenceHardware hardware, const KindRanges& ranges, Dice& dice) {
  const auto about = [&](double value, double relative) {
    return value * dice.real(1 - relative, 1 + relative);
  };
  hardware.tube.mu = dice.real(ranges.least_mu, ranges.greatest_mu);
  hardware.sheath.mu = dice.real(ranges.least_mu, ranges.greatest_mu);
  hardware.bearing.mu = about(hardware.bearing.mu, ranges.bearing_mu_relative);
  hardware.sheath.angle = about(hardware.sheath.angle, ranges.sheath_angle_relative);
  return hardware;
}

}  // namespace

ScatteredObjectives scattered_objectives(const std::string& word,
                                         const std::vector<std::set<int>>& grasps,
                                         const ReferenceHardware& hardware,
                                         const ContactDeviations& deviations, std::size_t draws,
                                         std::uint64_t seed,
                                         const std::optional<KindRanges>& ranges) {
  ScatteredObjectives means;
  for (std::size_t d = 0; d < draws; ++d) {
    Dice dice(seed * 1'000'003 + d);
    ReferenceHardware drawn = ranges ? drawn_kinds(hardware, *ranges, dice) : hardware;
    const double bearing_phi = drawn.bearing.mu * drawn.bearing.angle;
    // The same contacts in all grasps.
    std::map<std::pair<std::string, std::string>, double> z;
    drawn.phi_override = [&](const std::string& left, const std::string& right, double phi) {
      const auto [found, is_new] = z.try_emplace({left, right}, 0.0);
      if (is_new) found->second = drawn_normal(dice);
      const bool is_bearing = std::abs(phi - bearing_phi) < 1e-12;
      const double sigma = is_bearing ? deviations.bearing_relative : deviations.relative;
      return phi * std::max(1 + sigma * found->second, 0.0);
    };
    double uniformity = 0;
    double efficiency = 0;
    for (const std::set<int>& held : grasps) {
      const auto result = reference_tensions(word, held, ReferenceDirection::pull, drawn);
      uniformity += uniformity_of(result) / static_cast<double>(grasps.size());
      efficiency += work_on_fingers(result) / static_cast<double>(grasps.size());
    }
    means.uniformity.push_back(uniformity);
    means.efficiency.push_back(efficiency);
  }
  return means;
}

}  // namespace reeve::testing
