#include "search/uncertainty/bands.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "numerics/robust.hpp"

namespace reeve::search {
namespace {

constexpr double tail = 0.05;

// Between two infinite values a quantile is no number, and stands for what both are.
double quantile_or_infinite(const std::vector<double>& values, double share) {
  const double quantile = quantile_of(values, share);
  return std::isnan(quantile) ? std::numeric_limits<double>::infinity() : on_grid(quantile);
}

}  // namespace

const Band* find_band(const Bands& bands, Objective objective) {
  const auto found = std::find_if(bands.begin(), bands.end(), [&](const ObjectiveBand& entry) {
    return entry.objective == objective;
  });
  return found == bands.end() ? nullptr : &found->band;
}

bool depends_on_friction(Objective objective) {
  switch (objective) {
    case Objective::travel:
    case Objective::cost:
    case Objective::stroke:
    case Objective::closure:
    case Objective::uniformity_p5:  // quantiles over draws already
    case Objective::efficiency_p5:
      return false;
    default:
      return !row(objective).is_count();
  }
}

std::vector<Objective> friction_objectives(bool with_hand) {
  std::vector<Objective> objectives;
  for (const ObjectiveRow& about : objective_table()) {
    const bool is_there = with_hand || !about.of_hand;
    if (is_there && depends_on_friction(about.objective)) objectives.push_back(about.objective);
  }
  return objectives;
}

Band band_of(const std::vector<double>& values) {
  return {quantile_or_infinite(values, 0.5), quantile_or_infinite(values, tail),
          quantile_or_infinite(values, 1 - tail)};
}

DrawnValues::DrawnValues(std::vector<Objective> objectives, Order order, std::size_t draws,
                         std::size_t begin, std::size_t end)
    : objectives_(std::move(objectives)),
      order_(std::move(order)),
      draws_(draws),
      begin_(begin),
      end_(end),
      values_((end - begin) * objectives_.size() * draws),
      decisive_((end - begin) * draws) {}

void DrawnValues::keep(std::size_t design, std::size_t draw, const ObjectiveValues& values) {
  if (design < begin_ || design >= end_) return;
  std::size_t at = (design - begin_) * objectives_.size() * draws_ + draw;
  for (const Objective objective : objectives_) {
    values_[at] = value(values, objective);
    at += draws_;
  }
  decisive_[(design - begin_) * draws_ + draw] = decisive_value(values, order_);
}

std::vector<Band> DrawnValues::decisive_bands(Workers& workers) const {
  std::vector<Band> result(end_ - begin_);
  workers.for_each_block(result.size(), 16, [&](const IndexBlock& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      const auto from = decisive_.begin() + static_cast<std::ptrdiff_t>(i * draws_);
      result[i] = band_of({from, from + static_cast<std::ptrdiff_t>(draws_)});
    }
  });
  return result;
}

std::vector<Bands> DrawnValues::bands(Workers& workers) const {
  std::vector<Bands> result(end_ - begin_);
  workers.for_each_block(result.size(), 16, [&](const IndexBlock& block) {
    for (std::size_t i = block.begin; i < block.end; ++i) {
      auto from = values_.begin() + static_cast<std::ptrdiff_t>(i * objectives_.size() * draws_);
      for (const Objective objective : objectives_) {
        const auto to = from + static_cast<std::ptrdiff_t>(draws_);
        result[i].push_back({objective, band_of({from, to})});
        from = to;
      }
    }
  });
  return result;
}

}  // namespace reeve::search
