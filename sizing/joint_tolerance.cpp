#include "sizing/joint_tolerance.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "numerics/random.hpp"
#include "numerics/streams.hpp"

namespace reeve::sizing {
namespace {

constexpr std::size_t all_corners = 8;   // up to this number of variables, every corner is
                                         // evaluated
constexpr std::uint64_t ascents = 12;    // number of starting corners with more variables
constexpr double share_of_bounds = 0.1;  // share of the bounds, if there is no tolerance limit
constexpr int halvings_of_factor = 30;
constexpr int evaluations_in_box = 200;  // limit for each search in the whole box
constexpr int rounds = 12;

class ToleranceBox {
 public:
  ToleranceBox(const SizingProblem& problem, const Goal& goal, const SizingPoint& point,
               const std::vector<Sensitivity>& alone)
      : problem_(problem), point_(point) {
    limit_ = problem.loss(point) + tolerated(problem, goal, point);
    for (std::size_t i = 0; i < point.size(); ++i) {
      const Interval& bounds = problem.space().variables[i].bounds;
      const double any = share_of_bounds * (bounds.high - bounds.low);
      const auto way = [&](const auto& here, const auto& other, int sign) {
        if (here) return *here;
        return std::min(other.value_or(any), room_beyond(problem, point, i, sign));
      };
      const auto& [less, more] = std::tie(alone[i].less, alone[i].more);
      ways_.push_back({way(less, more, -1), way(more, less, 1)});
    }
  }

  std::size_t size() const { return point_.size(); }
  const std::vector<JointTolerance::Ways>& ways() const { return ways_; }

  // `where`: of each variable from −1, all of its way less, to 1.
  std::vector<double> moves(const SizingPoint& where, double factor) const {
    std::vector<double> moves;
    for (std::size_t i = 0; i < size(); ++i) {
      moves.push_back(factor * where[i] * (where[i] < 0 ? ways_[i].less : ways_[i].more));
    }
    return moves;
  }

  double loss(const SizingPoint& where, double factor) const {
    return loss_after(problem_, point_, moves(where, factor));
  }

  // A rounding error is no loss.
  bool is_lost(double loss) const { return loss > limit_ + 1e-12 * std::abs(limit_); }

  // The greatest part of the way there, up to `factor`, at which nothing is lost.
  double kept(const SizingPoint& where, double factor) const {
    double inside = 0;
    double outside = factor;
    for (int i = 0; i < halvings_of_factor; ++i) {
      const double middle = (inside + outside) / 2;
      (is_lost(loss(where, middle)) ? outside : inside) = middle;
    }
    return inside;
  }

 private:
  const SizingProblem& problem_;
  const SizingPoint& point_;
  double limit_ = 0;
  std::vector<JointTolerance::Ways> ways_;
};

class Shrinking {
 public:
  Shrinking(const ToleranceBox& box, std::uint64_t drawn_by) : box_(box), seed_(drawn_by) {}

  void run() {
    const std::size_t n = box_.size();
    if (n <= all_corners) {
      for (std::uint64_t bits = 0; bits < std::uint64_t{1} << n; ++bits) take(corner(bits));
    } else {
      for (std::uint64_t number = 0; number < ascents; ++number) take(ascent(number));
    }
    for (int round = 0; round < rounds; ++round) {
      if (!take(worst_inside())) break;
    }
  }

  double factor() const { return factor_; }
  const SizingPoint& worst() const { return worst_; }

 private:
  // Returns true if the box has shrunk.
  bool take(const SizingPoint& where) {
    if (!box_.is_lost(box_.loss(where, factor_))) return false;
    factor_ = box_.kept(where, factor_);
    worst_ = where;
    return true;
  }

  SizingPoint corner(std::uint64_t bits) const {
    SizingPoint where;
    for (std::size_t i = 0; i < box_.size(); ++i) where.push_back((bits >> i & 1) != 0 ? 1 : -1);
    return where;
  }

  // All less, all more, and then corners that are drawn.
  SizingPoint ascent(std::uint64_t number) const {
    SizingPoint where(box_.size(), number == 0 ? -1 : 1);
    for (std::size_t i = 0; number > 1 && i < where.size(); ++i) {
      const auto stream = streams::tolerance_corners + static_cast<std::uint32_t>(i);
      where[i] = uniform(seed_, stream, number) < 0.5 ? -1 : 1;
    }
    double worst = box_.loss(where, factor_);
    for (bool turned = true; turned;) {
      turned = false;
      for (double& side : where) {
        side = -side;
        const double loss = box_.loss(where, factor_);
        turned = turned || loss > worst;
        if (loss > worst) {
          worst = loss;
        } else {
          side = -side;
        }
      }
    }
    return where;
  }

  SizingPoint worst_inside() const {
    const std::vector<Interval> sides(box_.size(), {-1, 1});
    const auto gain = [&](const SizingPoint& where) { return -box_.loss(where, factor_); };
    const Minimum anywhere = minimise(gain, sides, evaluations_in_box);
    if (worst_.empty()) return anywhere.at;
    const Minimum beside = descend(gain, sides, worst_, evaluations_in_box);
    return beside.value < anywhere.value ? beside.at : anywhere.at;
  }

  const ToleranceBox& box_;
  std::uint64_t seed_;
  double factor_ = 1;
  SizingPoint worst_;
};

}  // namespace

JointTolerance joint_tolerance(const SizingProblem& problem, const Goal& goal,
                               const SizingPoint& point, const std::vector<Sensitivity>& alone,
                               std::uint64_t drawn_by) {
  JointTolerance result;
  if (point.empty()) return result;
  const ToleranceBox box(problem, goal, point, alone);
  Shrinking shrinking(box, drawn_by);
  shrinking.run();
  result.factor = shrinking.factor();
  for (const JointTolerance::Ways& ways : box.ways()) {
    result.ways.push_back({result.factor * ways.less, result.factor * ways.more});
  }
  if (!shrinking.worst().empty()) result.worst = box.moves(shrinking.worst(), result.factor);
  return result;
}

}  // namespace reeve::sizing
