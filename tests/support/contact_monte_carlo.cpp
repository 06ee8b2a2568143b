#include "tests/support/contact_monte_carlo.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "tests/support/random_routing.hpp"

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

}  // namespace

std::vector<double> scattered_uniformities(const std::string& word,
                                           const std::vector<std::set<int>>& grasps,
                                           const ReferenceHardware& hardware,
                                           const ContactDeviations& deviations, std::size_t draws,
                                           std::uint64_t seed) {
  Dice dice(seed);
  const double bearing_phi = hardware.bearing.mu * hardware.bearing.angle;
  std::vector<double> uniformities;
  for (std::size_t d = 0; d < draws; ++d) {
    // The same contacts in all grasps.
    std::map<std::pair<std::string, std::string>, double> z;
    ReferenceHardware drawn = hardware;
    drawn.phi_override = [&](const std::string& left, const std::string& right, double phi) {
      const auto [found, is_new] = z.try_emplace({left, right}, 0.0);
      if (is_new) found->second = drawn_normal(dice);
      const bool is_bearing = std::abs(phi - bearing_phi) < 1e-12;
      const double sigma = is_bearing ? deviations.bearing_relative : deviations.relative;
      return phi * std::max(1 + sigma * found->second, 0.0);
    };
    double sum = 0;
    for (const std::set<int>& held : grasps) {
      sum += uniformity_of(reference_tensions(word, held, ReferenceDirection::pull, drawn));
    }
    uniformities.push_back(sum / static_cast<double>(grasps.size()));
  }
  return uniformities;
}

}  // namespace reeve::testing
