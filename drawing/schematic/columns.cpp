#include "drawing/schematic/columns.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "drawing/schematic/schematic_measures.hpp"

namespace reeve::drawing {
namespace {

bool keep_apart(const Strip& a, const Strip& b) {
  if (a.fitting == b.fitting || a.rank == b.rank) return false;
  if (std::min(a.bottom, b.bottom) - std::max(a.top, b.top) < 0.01) return false;
  // Both ends of a line that runs on: they may lie over each other.
  return a.segment == nowhere || a.segment != b.segment || a.rises == b.rises;
}

// Asks for x_right ≥ x_left + least; each pixel that is missing costs `strength`.
struct Demand {
  std::size_t left = 0;
  std::size_t right = 0;
  double least = 0;
  double strength = 0;
};

// Places at which all demands together cost the least.
//
// Demands around a circle whose lengths sum to more than 0 contradict each other. Whatever the
// places, they cost at least that sum times the strength of the weakest. So this is paid, each of
// them loses the strength of the weakest, and the demand opposite to it gains it. Once no circle
// contradicts itself, places that meet all that is left cost what was paid, and none cost less.
// (Strengths lost are a flow, the dual of this linear programme; this is its cycle cancelling.)
// Lengths are whole numbers, so that places are, too.
class Spacing {
 public:
  explicit Spacing(std::size_t size) : x_(size, 0), pushed_by_(size) {}

  // The opposite one asks for x_right ≤ x_left + least.
  void add(const Demand& demand, double opposite) {
    demands_.push_back(demand);
    demands_.push_back({demand.right, demand.left, -demand.least, opposite});
  }

  // Returns false if they cost `limit` or more.
  bool solve(double limit) {
    while (cost_ < limit) {
      const std::size_t at = contradiction();
      if (at == nowhere) return true;
      give_way(at);
    }
    return false;
  }

  double cost() const { return cost_; }

  // Returns the leftmost of the best places, as seen from a fitting at 0, and the rightmost.
  std::array<std::vector<double>, 2> best(std::size_t from) const {
    Spacing mirrored = *this;
    for (Demand& demand : mirrored.demands_) std::swap(demand.left, demand.right);
    std::vector<double> rightmost = mirrored.leftmost(from);
    for (double& x : rightmost) x = -x;
    return {leftmost(from), std::move(rightmost)};
  }

 private:
  std::vector<double> leftmost(std::size_t from) const {
    Spacing pushed = *this;
    std::ranges::fill(pushed.x_, -infinity);
    pushed.x_[from] = 0;
    while (pushed.push()) continue;
    return pushed.x_;
  }

  // Returns a fitting that demands around a circle push on and on; nowhere if all can be met.
  std::size_t contradiction() {
    std::ranges::fill(pushed_by_, nowhere);
    std::size_t at = nowhere;
    while (at == nowhere && push()) at = on_circle();
    return at;
  }

  // Moves rightward what each demand asks for, in turn; returns false if all are met.
  bool push() {
    bool moved = false;
    for (std::size_t i = 0; i < demands_.size(); ++i) {
      const Demand& demand = demands_[i];
      const double least = x_[demand.left] + demand.least;
      if (demand.strength == 0 || x_[demand.right] >= least) continue;
      x_[demand.right] = least;
      pushed_by_[demand.right] = i;
      moved = true;
    }
    return moved;
  }

  std::size_t on_circle() const {
    std::vector<std::size_t> seen_from(x_.size(), nowhere);
    for (std::size_t first = 0; first < x_.size(); ++first) {
      std::size_t at = first;
      while (seen_from[at] == nowhere && pushed_by_[at] != nowhere) {
        seen_from[at] = first;
        at = demands_[pushed_by_[at]].left;
      }
      if (seen_from[at] == first && pushed_by_[at] != nowhere) return at;
    }
    return nowhere;
  }

  void give_way(std::size_t first) {
    double sum = 0;
    double weakest = infinity;
    const auto around = [&](auto visit) {
      std::size_t at = first;
      do {
        visit(pushed_by_[at]);
        at = demands_[pushed_by_[at]].left;
      } while (at != first);
    };
    around([&](std::size_t i) {
      sum += demands_[i].least;
      weakest = std::min(weakest, demands_[i].strength);
    });
    around([&](std::size_t i) {
      demands_[i].strength -= weakest;
      demands_[i ^ 1U].strength += weakest;
    });
    cost_ += weakest * sum;
  }

  std::vector<double> x_;
  std::vector<std::size_t> pushed_by_;  // the last demand that moved a fitting
  std::vector<Demand> demands_;         // each followed by the one opposite to it
  double cost_ = 0;
};

void keep_distances(const std::vector<Strip>& strips, std::size_t size, Spacing& spacing) {
  std::vector<double> least(size * size, -infinity);
  for (const Strip& a : strips) {
    for (const Strip& b : strips) {
      if (!(a.rank < b.rank) || !keep_apart(a, b)) continue;
      double& at = least[a.fitting * size + b.fitting];
      at = std::max(at, std::ceil(a.right - b.left));
    }
  }
  for (std::size_t i = 0; i < least.size(); ++i) {
    if (least[i] > -infinity) spacing.add({i / size, i % size, least[i], infinity}, 0);
  }
}

// Removes a step that is too small for two rounded corners in all of the best places, if that
// costs as little.
void straighten(const Demand& line, std::size_t from, Spacing& spacing) {
  constexpr double small = 2 * measures::bend;
  double step = 0;
  for (const std::vector<double>& x : spacing.best(from)) {
    step = std::max(step, std::abs(x[line.right] - x[line.left] - line.least));
  }
  if (step == 0 || step > small) return;
  Spacing straight = spacing;
  straight.add({line.left, line.right, line.least, infinity}, infinity);
  if (straight.solve(spacing.cost() + small)) spacing = std::move(straight);
}

}  // namespace

std::optional<Columns> columns(const Fittings& all, const Lanes& lanes, std::vector<Strip> strips,
                               double limit) {
  const std::size_t left = all.fittings.size();
  const std::size_t right = left + 1;
  strips.push_back({left, -infinity, 0, 0, -infinity, infinity});
  strips.push_back({right, infinity, 0, 0, -infinity, infinity});
  Spacing spacing(right + 1);
  keep_distances(strips, right + 1, spacing);
  spacing.add({right, left, 0, 0.25}, 0);
  std::vector<Demand> lines;
  for (const LaneStretch& stretch : lanes.stretches) {
    const ColumnOf one = column_of(all, stretch.port[0]);
    const ColumnOf other = column_of(all, stretch.port[1]);
    lines.push_back({one.fitting, other.fitting, one.offset - other.offset, 1});
    spacing.add(lines.back(), lines.back().strength);
  }
  if (!spacing.solve(limit)) return std::nullopt;
  const double cost = spacing.cost();
  for (const Demand& line : lines) straighten(line, left, spacing);
  // Halfway lines lie as evenly as they can; rounded down, these places are among the best, too.
  auto [middle, rightmost] = spacing.best(left);
  for (std::size_t i = 0; i <= right; ++i) middle[i] = std::floor((middle[i] + rightmost[i]) / 2);
  return Columns{middle, middle[right], cost};
}

double column(const Fittings& all, const Columns& columns, std::size_t port) {
  const auto [fitting, offset] = column_of(all, port);
  return columns.middle[fitting] + offset;
}

}  // namespace reeve::drawing
