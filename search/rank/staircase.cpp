#include "search/rank/staircase.hpp"

#include <algorithm>
#include <functional>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

namespace reeve::search {
namespace {

constexpr std::size_t most_layers = 32;
constexpr Eigen::Index most_objectives = 3;
constexpr double nothing = -std::numeric_limits<double>::infinity();

std::vector<double> falling_values(const GoodnessMatrix& rows, Eigen::Index column) {
  std::vector<double> values(rows.col(column).begin(), rows.col(column).end());
  std::sort(values.begin(), values.end(), std::greater<>());
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

// The objective with the fewest values.
Eigen::Index coarsest(const GoodnessMatrix& rows) {
  Eigen::Index best = 0;
  std::size_t fewest = std::numeric_limits<std::size_t>::max();
  for (Eigen::Index j = 0; j < rows.cols(); ++j) {
    const std::size_t values = falling_values(rows, j).size();
    if (values >= fewest) continue;
    fewest = values;
    best = j;
  }
  return best;
}

}  // namespace

void KGreatest::add(double value) {
  if (heap_.size() == keep_ && value <= heap_.top()) return;
  if (heap_.size() == keep_) heap_.pop();
  heap_.push(value);
}

double KGreatest::least() const { return heap_.size() < keep_ ? nothing : heap_.top(); }

bool KGreatest::has_all_above(double value) const {
  return heap_.size() == keep_ && heap_.top() >= value;
}

bool Staircase::can_hold(const GoodnessMatrix& rows) {
  if (rows.cols() < most_objectives) return true;
  return rows.cols() == most_objectives && rows.rows() > 0 &&
         falling_values(rows, coarsest(rows)).size() <= most_layers;
}

void Staircase::choose_axes(const GoodnessMatrix& rows) {
  if (rows.cols() == most_objectives) third_ = coarsest(rows);
  for (Eigen::Index j = rows.cols(); j-- > 0;) {
    if (j == third_) continue;
    if (rows.cols() > 1 && second_ < 0) {
      second_ = j;
    } else {
      first_ = j;
    }
  }
}

double Staircase::at(const Goodness& candidate, Eigen::Index axis) const {
  return axis < 0 ? 0 : candidate[axis];
}

Staircase::Staircase(const GoodnessMatrix& rows, std::size_t keep) {
  choose_axes(rows);
  std::vector<Eigen::Index> order(static_cast<std::size_t>(rows.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  std::sort(order.begin(), order.end(),
            [&](Eigen::Index a, Eigen::Index b) { return rows(a, first_) > rows(b, first_); });
  for (const double least : third_ < 0 ? std::vector<double>{0} : falling_values(rows, third_)) {
    Layer layer{least, {}};
    KGreatest seconds(keep);
    for (const Eigen::Index i : order) {
      if (third_ >= 0 && rows(i, third_) < least) continue;
      seconds.add(second_ < 0 ? 0 : rows(i, second_));
      const double depth = seconds.least();
      const double before = layer.steps.empty() ? nothing : layer.steps.back().depth;
      if (depth == before) continue;
      if (!layer.steps.empty() && layer.steps.back().first == rows(i, first_)) {
        layer.steps.back().depth = depth;
      } else {
        layer.steps.push_back({rows(i, first_), depth});
      }
    }
    layers_.push_back(std::move(layer));
  }
}

bool Staircase::proves_dominators(const Goodness& candidate) const {
  const double a = candidate[first_];
  const double b = at(candidate, second_);
  const double c = at(candidate, third_);
  // Fewer than k rows look the same as a second value of −∞: nothing is proved.
  if (b == nothing) return false;
  // The largest layer, of all rows that are no worse on the third axis.
  const auto behind =
      std::upper_bound(layers_.begin(), layers_.end(), c,
                       [](double value, const Layer& l) { return l.least < value; });
  if (behind == layers_.begin()) return false;
  const auto layer = behind - 1;
  const auto before = [](const Step& step, double value) { return step.first > value; };
  const auto depth_before = [](const Layer& l, auto step) {
    return step == l.steps.begin() ? nothing : (step - 1)->depth;
  };
  const auto at_a = std::lower_bound(layer->steps.begin(), layer->steps.end(), a, before);
  if (depth_before(*layer, at_a) >= b) return true;
  const bool has_step = at_a != layer->steps.end() && at_a->first == a;
  const double no_worse = has_step ? at_a->depth : depth_before(*layer, at_a);
  if (no_worse > b) return true;
  if (no_worse < b) return false;
  // At least k rows are no worse on both axes, some of them equal. They dominate if they are better
  // on the third axis.
  if (layer->least == c && layer == layers_.begin()) return false;
  const auto better = layer->least > c ? layer : layer - 1;
  const auto step = std::upper_bound(better->steps.begin(), better->steps.end(), a,
                                     [](double value, const Step& s) { return s.first < value; });
  return depth_before(*better, step) >= b;
}

}  // namespace reeve::search
