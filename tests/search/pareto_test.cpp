#include "search/rank/pareto.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>
#include <vector>

namespace reeve {
namespace {

GoodnessMatrix random_matrix(std::mt19937_64& engine, Eigen::Index rows, Eigen::Index columns,
                             int levels) {
  GoodnessMatrix matrix(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < columns; ++j) {
      matrix(i, j) = static_cast<double>(engine() % static_cast<std::uint64_t>(levels)) - 1;
    }
  }
  return matrix;
}

// From the definition, element by element.
bool beats(const GoodnessMatrix& matrix, Eigen::Index a, Eigen::Index b) {
  bool better = false;
  for (Eigen::Index j = 0; j < matrix.cols(); ++j) {
    if (matrix(a, j) < matrix(b, j)) return false;
    if (matrix(a, j) > matrix(b, j)) better = true;
  }
  return better;
}

// Front by front: the rows that no row without a front dominates.
std::vector<int> peeled(const GoodnessMatrix& matrix) {
  std::vector<int> front(static_cast<std::size_t>(matrix.rows()), 0);
  const auto of = [&](Eigen::Index i) -> int& { return front[static_cast<std::size_t>(i)]; };
  Eigen::Index placed = 0;
  for (int number = 1; placed < matrix.rows(); ++number) {
    std::vector<Eigen::Index> members;
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
      bool dominated = of(i) != 0;
      for (Eigen::Index k = 0; k < matrix.rows() && !dominated; ++k) {
        dominated = of(k) == 0 && beats(matrix, k, i);
      }
      if (!dominated) members.push_back(i);
    }
    for (const Eigen::Index i : members) of(i) = number;
    placed += static_cast<Eigen::Index>(members.size());
  }
  return front;
}

Goodness row_of(const GoodnessMatrix& matrix, Eigen::Index i) { return matrix.row(i).transpose(); }

std::string shape(const GoodnessMatrix& matrix, int levels) {
  return std::to_string(matrix.rows()) + " x " + std::to_string(matrix.cols()) + ", " +
         std::to_string(levels) + " levels";
}

// Sizes around the chunks in which rows are compared; from nearly all equal to nearly no ties.
template <typename Check>
void for_random_matrices(Check check) {
  std::mt19937_64 engine(7);
  for (const Eigen::Index rows : {1, 2, 10, 63, 64, 65, 128, 150}) {
    for (Eigen::Index columns = 1; columns <= 5; ++columns) {
      for (const int levels : {1, 2, 3, 8, 1000000}) {
        const GoodnessMatrix matrix = random_matrix(engine, rows, columns, levels);
        SCOPED_TRACE(shape(matrix, levels));
        check(matrix);
      }
    }
  }
}

Goodness numbers(const std::vector<double>& values) {
  Goodness result(static_cast<Eigen::Index>(values.size()));
  for (std::size_t j = 0; j < values.size(); ++j) {
    result[static_cast<Eigen::Index>(j)] = values[j];
  }
  return result;
}

TEST(Goodness, IsLargerForBetterDesignsInTheChosenOrder) {
  ObjectiveValues values{};
  value(values, Objective::sheaths) = 3;
  value(values, Objective::efficiency_mean) = 0.25;
  value(values, Objective::travel) = 1.5;
  const Goodness result =
      goodness(values, {Objective::sheaths, Objective::efficiency_mean, Objective::travel});
  EXPECT_EQ(std::vector<double>(result.begin(), result.end()),
            (std::vector<double>{-3, 0.25, -1.5}));
}

TEST(Dominance, NeedsNowhereWorseAndSomewhereBetter) {
  EXPECT_TRUE(dominates(numbers({1, 2}), numbers({1, 1})));
  EXPECT_TRUE(dominates(numbers({2, 2}), numbers({1, 1})));
  EXPECT_FALSE(dominates(numbers({1, 1}), numbers({1, 2})));
  EXPECT_FALSE(dominates(numbers({2, 0}), numbers({1, 1})));
  EXPECT_FALSE(dominates(numbers({1, 1}), numbers({2, 0})));
}

TEST(Dominance, EqualRowsDoNotDominateEachOther) {
  EXPECT_FALSE(dominates(numbers({1, 2}), numbers({1, 2})));
}

TEST(Dominance, AgreesWithItsDefinition) {
  for_random_matrices([](const GoodnessMatrix& matrix) {
    for (Eigen::Index a = 0; a < std::min<Eigen::Index>(matrix.rows(), 40); ++a) {
      for (Eigen::Index b = 0; b < matrix.rows(); ++b) {
        EXPECT_EQ(dominates(row_of(matrix, a), row_of(matrix, b)), beats(matrix, a, b));
      }
    }
  });
}

TEST(Dominators, AreCountedAmongTheFirstRowsUpToEnough) {
  for_random_matrices([](const GoodnessMatrix& matrix) {
    const Eigen::Index n = matrix.rows();
    for (Eigen::Index i = 0; i < n; i += 7) {
      const Goodness candidate = row_of(matrix, i);
      for (const Eigen::Index rows : {Eigen::Index{0}, n / 3, n - 1, n}) {
        Eigen::Index count = 0;
        for (Eigen::Index k = 0; k < rows; ++k) count += beats(matrix, k, i) ? 1 : 0;
        for (const Eigen::Index enough : {Eigen::Index{1}, Eigen::Index{5}, n + 1}) {
          EXPECT_EQ(count_dominators(matrix, rows, candidate, enough), std::min(count, enough));
        }
      }
    }
  });
}

TEST(Fronts, AgreeWithPeelingThemOffOneByOne) {
  for_random_matrices(
      [](const GoodnessMatrix& matrix) { EXPECT_EQ(fronts(matrix), peeled(matrix)); });
}

TEST(Fronts, EqualRowsShareAFront) {
  GoodnessMatrix matrix(4, 2);
  matrix << 1, 1, 2, 0, 1, 1, 0, 0;
  EXPECT_EQ(fronts(matrix), (std::vector<int>{1, 1, 1, 2}));
}

TEST(Fronts, AChainHasAsManyFrontsAsRows) {
  GoodnessMatrix matrix(200, 3);
  std::vector<int> expected;
  for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
    matrix.row(i).setConstant(static_cast<double>(i));
    expected.push_back(static_cast<int>(matrix.rows() - i));
  }
  EXPECT_EQ(fronts(matrix), expected);
}

TEST(Fronts, OfNothingAreNone) { EXPECT_TRUE(fronts(GoodnessMatrix(0, 2)).empty()); }

}  // namespace
}  // namespace reeve
