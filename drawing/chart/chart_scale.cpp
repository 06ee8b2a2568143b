#include "drawing/chart/chart_scale.hpp"

#include <algorithm>
#include <cmath>

namespace reeve::drawing::chart {
namespace {

double bent(double value, double linear_to) {
  return linear_to > 0 ? std::copysign(std::log1p(std::abs(value) / linear_to), value) : value;
}

double straight(double bent, double linear_to) {
  return linear_to > 0 ? std::copysign(linear_to * std::expm1(std::abs(bent)), bent) : bent;
}

}  // namespace

double place(const Scale& scale, double value) {
  const double low = bent(scale.low, scale.linear_to);
  const double high = bent(scale.high, scale.linear_to);
  return scale.from + (bent(value, scale.linear_to) - low) / (high - low) * (scale.to - scale.from);
}

double value(const Scale& scale, double place) {
  const double low = bent(scale.low, scale.linear_to);
  const double high = bent(scale.high, scale.linear_to);
  const double share = (place - scale.from) / (scale.to - scale.from);
  return straight(low + share * (high - low), scale.linear_to);
}

bool can_be_drawn(double value) { return std::isfinite(value) && std::abs(value) <= 1e100; }

void Extent::add(double value) {
  if (!can_be_drawn(value)) return;
  low = std::min(low, value);
  high = std::max(high, value);
}

void Extent::add(const Extent& other) {
  if (other.empty()) return;
  add(other.low);
  add(other.high);
}

}  // namespace reeve::drawing::chart
