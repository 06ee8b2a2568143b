#include "search/rank/pareto.hpp"

#include <algorithm>
#include <numeric>

namespace reeve::search {
namespace {

// Rows are compared in chunks that fit a few registers.
constexpr Eigen::Index chunk = 64;

// Calls visit(row) for each of the first `rows` rows that dominates the candidate until it returns
// false.
template <typename Visit>
void for_each_dominator(const GoodnessMatrix& matrix, Eigen::Index rows, const Goodness& candidate,
                        Visit visit) {
  using Flags = Eigen::Array<bool, Eigen::Dynamic, 1, 0, chunk, 1>;
  for (Eigen::Index begin = 0; begin < rows; begin += chunk) {
    const Eigen::Index size = std::min(chunk, rows - begin);
    Flags nowhere_worse = Flags::Constant(size, true);
    Flags somewhere_better = Flags::Constant(size, false);
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      const auto column = matrix.col(j).segment(begin, size);
      nowhere_worse = nowhere_worse && (column >= candidate[j]);
      somewhere_better = somewhere_better || (column > candidate[j]);
    }
    nowhere_worse = nowhere_worse && somewhere_better;
    if (!nowhere_worse.any()) continue;
    for (Eigen::Index i = 0; i < size; ++i) {
      if (nowhere_worse[i] && !visit(begin + i)) return;
    }
  }
}

// Larger goodness first: a row's dominators come before it.
std::vector<Eigen::Index> descending(const GoodnessMatrix& matrix) {
  std::vector<Eigen::Index> order(static_cast<std::size_t>(matrix.rows()));
  std::iota(order.begin(), order.end(), Eigen::Index{0});
  const auto precedes = [&](Eigen::Index a, Eigen::Index b) {
    for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
      if (matrix(a, j) != matrix(b, j)) return matrix(a, j) > matrix(b, j);
    }
    return a < b;
  };
  // The rows of an archive are sorted already.
  if (!std::is_sorted(order.begin(), order.end(), precedes)) {
    std::sort(order.begin(), order.end(), precedes);
  }
  return order;
}

// Returns the fronts for at most two objectives. Rows come with falling first values: a front
// dominates a row if its best second value is no less and the row is no equal.
std::vector<int> fronts_by_sweep(const GoodnessMatrix& matrix) {
  const std::vector<Eigen::Index> order = descending(matrix);
  std::vector<double>
      best;  // [front]: best second value, negated; ascending, since front k dominates k + 1
  std::vector<int> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    int& front = result[static_cast<std::size_t>(order[i])];
    if (i > 0 && (matrix.row(order[i]) == matrix.row(order[i - 1])).all()) {
      front = result[static_cast<std::size_t>(order[i - 1])];
      continue;
    }
    const double negated = -second_value(matrix.row(order[i]).transpose());
    const auto place = std::upper_bound(best.begin(), best.end(), negated);
    front = static_cast<int>(place - best.begin()) + 1;
    if (place == best.end()) {
      best.push_back(negated);
    } else {
      *place = negated;
    }
  }
  return result;
}

}  // namespace

Goodness goodness(const ObjectiveValues& values, const std::vector<Objective>& objectives) {
  Goodness result(static_cast<Eigen::Index>(objectives.size()));
  for (Eigen::Index j = 0; j < result.size(); ++j) {
    const Objective objective = objectives[static_cast<std::size_t>(j)];
    const double v = value(values, objective);
    result[j] = row(objective).better == Better::higher ? v : -v;
  }
  return result;
}

double second_value(const Goodness& goodness) { return goodness.size() == 2 ? goodness[1] : 0; }

bool dominates(const Goodness& a, const Goodness& b) { return (a >= b).all() && (a > b).any(); }

Eigen::Index count_dominators(const GoodnessMatrix& matrix, Eigen::Index rows,
                              const Goodness& candidate, Eigen::Index enough) {
  Eigen::Index count = 0;
  for_each_dominator(matrix, rows, candidate, [&](Eigen::Index) { return ++count < enough; });
  return count;
}

std::vector<int> fronts(const GoodnessMatrix& matrix) {
  if (matrix.cols() <= 2) return fronts_by_sweep(matrix);
  const std::vector<Eigen::Index> order = descending(matrix);
  GoodnessMatrix sorted(matrix.rows(), matrix.cols());
  std::vector<int> sorted_front(order.size());
  std::vector<int> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto position = static_cast<Eigen::Index>(i);
    sorted.row(position) = matrix.row(order[i]);
    int last = 0;
    for_each_dominator(sorted, position, sorted.row(position).transpose(), [&](Eigen::Index d) {
      last = std::max(last, sorted_front[static_cast<std::size_t>(d)]);
      return true;
    });
    sorted_front[i] = last + 1;
    result[static_cast<std::size_t>(order[i])] = last + 1;
  }
  return result;
}

}  // namespace reeve::search
