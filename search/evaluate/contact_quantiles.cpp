#include "search/evaluate/contact_quantiles.hpp"

#include <algorithm>
#include <cmath>

#include "core/performance.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::search {
namespace {

constexpr double low_tail = 0.05;
constexpr int draws_at_once = 8;
static_assert(ContactQuantileFinder::draws % draws_at_once == 0);
// Stands for the logarithm of nothing: far below that of any tension, and still a number.
constexpr double log_of_nothing = -600;

double log_of(double value) { return value > 0 ? std::log(value) : log_of_nothing; }

}  // namespace

// Returns the same as quantile_of, in memory that is kept.
double ContactQuantileFinder::low_quantile(const Draws& values) {
  sorted_.assign(values.begin(), values.end());
  std::sort(sorted_.begin(), sorted_.end());
  const double place = low_tail * static_cast<double>(draws - 1);
  const auto below = static_cast<std::size_t>(place);
  const double rest = place - static_cast<double>(below);
  return sorted_[below] + rest * (sorted_[below + 1] - sorted_[below]);
}

void ContactQuantileFinder::draw_contacts(std::size_t contacts) {
  while (z_.size() < contacts) {
    const auto stream = streams::contact_scatter + static_cast<std::uint32_t>(z_.size());
    Draws& z = z_.emplace_back(static_cast<Eigen::Index>(draws));
    for (std::size_t d = 0; d < draws; ++d) {
      z[static_cast<Eigen::Index>(d)] = normal(seed, stream, d);
    }
  }
}

void ContactQuantileFinder::read(const Network& network, const TensionState& state,
                                 std::vector<double>& logs) const {
  logs.clear();
  double work = 0;
  for (const std::size_t i : strands_) {
    const Segment& segment = network.segments[i];
    logs.push_back(log_of(state.tension[i]));
    work += state.tension[i] * segment.way() *
            state.closing[static_cast<std::size_t>(segment.finger) - 1];
  }
  logs.push_back(log_of(work));
}

// Some draws after the others, so that their sums stay in registers.
void ContactQuantileFinder::draw_logs() {
  for (std::size_t i = 0; i < base_.size(); ++i) {
    drawn_[i].resize(static_cast<Eigen::Index>(draws));
    for (Eigen::Index d = 0; d < drawn_[i].size(); d += draws_at_once) {
      Eigen::Array<double, draws_at_once, 1> sum;
      sum.setConstant(base_[i]);
      for (const Slope& slope : slopes_[i]) {
        sum += slope.value * z_[slope.contact].segment<draws_at_once>(d);
      }
      drawn_[i].segment<draws_at_once>(d) = sum;
    }
  }
}

void ContactQuantileFinder::add_grasp(const Network& network, Mechanics& nominal,
                                      const std::vector<double>& deviations,
                                      const WeightedGrasp& grasp, const Solve& solve) {
  const TensionState& state = solve(nominal, grasp.grasp, false);
  strands_.clear();
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    const bool is_strand = network.segments[i].kind == SegmentKind::strand;
    if (is_strand && !yields(network, state, i)) strands_.push_back(i);
  }
  read(network, state, base_);
  if (drawn_.size() < base_.size()) drawn_.resize(base_.size());
  if (slopes_.size() < base_.size()) slopes_.resize(base_.size());
  for (std::vector<Slope>& slopes : slopes_) slopes.clear();
  for (std::size_t k = 0; k < deviations.size(); ++k) {
    const double phi = nominal.phi[k];
    const double decay = nominal.decay[k];
    if (deviations[k] == 0 || phi == 0) continue;
    const auto solve_at = [&](double factor, std::vector<double>& logs) {
      nominal.phi[k] = factor * phi;
      nominal.decay[k] = std::exp(-nominal.phi[k]);
      read(network, solve(nominal, grasp.grasp, true), logs);
    };
    solve_at(1 + deviations[k], more_);
    solve_at(1 - deviations[k], less_);
    nominal.phi[k] = phi;
    nominal.decay[k] = decay;
    for (std::size_t i = 0; i < base_.size(); ++i) {
      const double slope = (more_[i] - less_[i]) / 2;
      if (slope != 0) slopes_[i].push_back({k, slope});
    }
  }
  draw_logs();
  const std::size_t strands = base_.size() - 1;
  efficiency_ += grasp.weight * drawn_[strands].exp();
  // Uniformity has no value if there are no strands, or if all are slack.
  const auto end = base_.begin() + static_cast<std::ptrdiff_t>(strands);
  if (std::all_of(base_.begin(), end, [](double log) { return log == log_of_nothing; })) return;
  least_ = most_ = drawn_[0];
  for (std::size_t i = 1; i < strands; ++i) {
    least_ = least_.min(drawn_[i]);
    most_ = most_.max(drawn_[i]);
  }
  uniformity_ += grasp.weight * (least_ - most_).exp();
}

ContactQuantiles ContactQuantileFinder::find(const Network& network, Mechanics& nominal,
                                             const std::vector<double>& deviations,
                                             const GraspSet& grasps, const Solve& solve) {
  draw_contacts(deviations.size());
  uniformity_.setZero(static_cast<Eigen::Index>(draws));
  efficiency_.setZero(static_cast<Eigen::Index>(draws));
  double weight = 0;
  for (const WeightedGrasp& grasp : grasps) {
    add_grasp(network, nominal, deviations, grasp, solve);
    weight += grasp.weight;
  }
  return {low_quantile(uniformity_) / weight, low_quantile(efficiency_) / weight};
}

}  // namespace reeve::search
