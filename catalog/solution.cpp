#include "catalog/solution.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/network.hpp"
#include "core/tension/tension.hpp"

namespace reeve::catalog {
namespace {

std::vector<double> strand_tensions(const Network& network, const TensionState& state) {
  std::vector<double> tension(2 * static_cast<std::size_t>(network.fingers));
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const Segment& segment = network.segments[i];
    if (segment.kind == SegmentKind::strand) {
      tension[static_cast<std::size_t>(segment.number - 1)] = state.tension[i];
    }
  }
  return tension;
}

std::vector<SheathEnds> sheath_ends(const Network& network, const TensionState& state) {
  std::vector<SheathEnds> sheaths;
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      if (network.contacts[tendon.first_contact + k].kind != ContactKind::sheath) continue;
      auto [strand, motor_side] = ends_of(tendon, k);
      if (network.segments[strand].kind == SegmentKind::motor_side) std::swap(strand, motor_side);
      if (network.segments[strand].kind != SegmentKind::strand) return {};
      sheaths.resize(
          std::max(sheaths.size(), static_cast<std::size_t>(network.segments[motor_side].number)));
      sheaths[static_cast<std::size_t>(network.segments[motor_side].number - 1)] = {
          static_cast<std::size_t>(network.segments[strand].number - 1),
          state.tension[motor_side] / state.tension[strand]};
    }
  }
  return sheaths;
}

}  // namespace

Solution solve(const CatalogueEntry& entry, const Hardware& hardware) {
  const Network network = expand(entry.routing);
  const TensionState state = tensions(network, mechanics(network, hardware), entry.grasp);
  Solution solution;
  solution.tension = strand_tensions(network, state);
  solution.share_percent = shares_percent(solution.tension);
  solution.sheaths = sheath_ends(network, state);
  return solution;
}

std::vector<double> shares_percent(const std::vector<double>& tension) {
  const double sum = std::accumulate(tension.begin(), tension.end(), 0.0);
  std::vector<double> shares;
  shares.reserve(tension.size());
  for (const double t : tension) shares.push_back(100 * t / sum);
  return shares;
}

Hardware with_friction(double mu) {
  Hardware hardware;
  hardware.tube.mu = mu;
  hardware.sheath.mu = mu;
  return hardware;
}

double decay(const Losses& losses, const Hardware& hardware) {
  return std::exp(-(losses.tube * hardware.tube.exponent() +
                    losses.bearing * hardware.bearing.exponent() +
                    losses.sheath * hardware.sheath.exponent()));
}

double gain(const ClosedForm& form) {
  double sum = 0;
  for (const Losses& losses : form.carriage) sum += decay(losses);
  return 1 / sum;
}

std::vector<double> evaluate(const ClosedForm& form) {
  std::vector<double> tension;
  for (const Losses& losses : form.strand) tension.push_back(gain(form) * decay(losses));
  return tension;
}

bool rounds_to(double computed, const PrintedNumber& printed) {
  return std::abs(computed - printed.value) <= printed.half_unit + 1e-12;
}

}  // namespace reeve::catalog
