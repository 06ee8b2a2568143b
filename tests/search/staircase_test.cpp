#include "search/rank/staircase.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

namespace reeve {
namespace {

struct Field {
  Eigen::Index objectives;
  int levels;       // of each value but the last one's
  int last_levels;  // few, where there are three
  Eigen::Index rows;
};

GoodnessMatrix random_rows(std::mt19937_64& engine, const Field& field, Eigen::Index rows) {
  GoodnessMatrix matrix(rows, field.objectives);
  for (Eigen::Index i = 0; i < rows; ++i) {
    for (Eigen::Index j = 0; j < field.objectives; ++j) {
      const int levels = j + 1 == field.objectives ? field.last_levels : field.levels;
      matrix(i, j) = -static_cast<double>(engine() % static_cast<std::uint64_t>(levels));
    }
  }
  return matrix;
}

const std::vector<Field>& fields() {
  static const std::vector<Field> all{{1, 9, 9, 40},     {2, 1000, 1000, 200}, {2, 7, 7, 200},
                                      {3, 1000, 5, 300}, {3, 6, 3, 300},       {2, 3, 3, 0}};
  return all;
}

Eigen::Index dominators(const GoodnessMatrix& rows, const Goodness& candidate) {
  Eigen::Index count = 0;
  for (Eigen::Index i = 0; i < rows.rows(); ++i) {
    if (dominates(rows.row(i).transpose(), candidate)) ++count;
  }
  return count;
}

// As of a cost that is infinite.
GoodnessMatrix with_infinities(std::mt19937_64& engine, GoodnessMatrix rows) {
  for (double& value : rows.reshaped()) {
    if (engine() % 5 == 0) value = -std::numeric_limits<double>::infinity();
  }
  return rows;
}

void expect_no_false_proof(std::mt19937_64& engine, bool infinities) {
  for (const Field& field : fields()) {
    GoodnessMatrix rows = random_rows(engine, field, field.rows);
    GoodnessMatrix candidates = random_rows(engine, field, 400);
    if (infinities) {
      rows = with_infinities(engine, rows);
      candidates = with_infinities(engine, candidates);
    }
    for (const std::size_t keep : {1U, 2U, 9U, 60U}) {
      if (!Staircase::can_hold(rows)) continue;
      const Staircase staircase(rows, keep);
      for (Eigen::Index i = 0; i < candidates.rows(); ++i) {
        const Goodness candidate = candidates.row(i).transpose();
        if (!staircase.proves_dominators(candidate)) continue;
        ASSERT_GE(dominators(rows, candidate), static_cast<Eigen::Index>(keep))
            << candidate.transpose();
      }
    }
  }
}

TEST(Staircase, ProvesNothingThatIsNotTrue) {
  std::mt19937_64 engine(1);
  expect_no_false_proof(engine, false);
  expect_no_false_proof(engine, true);
}

TEST(Staircase, OfOneIsExact) {
  std::mt19937_64 engine(2);
  for (const Field& field : fields()) {
    const GoodnessMatrix rows = random_rows(engine, field, field.rows);
    if (!Staircase::can_hold(rows)) continue;
    const Staircase staircase(rows, 1);
    const GoodnessMatrix candidates = random_rows(engine, field, 400);
    for (Eigen::Index i = 0; i < candidates.rows(); ++i) {
      const Goodness candidate = candidates.row(i).transpose();
      ASSERT_EQ(staircase.proves_dominators(candidate), dominators(rows, candidate) > 0)
          << candidate.transpose();
    }
  }
}

// What it is for: those that are worse in everything than many are turned away.
TEST(Staircase, ProvesWhatIsStrict) {
  std::mt19937_64 engine(3);
  for (const Field& field : fields()) {
    const GoodnessMatrix rows = random_rows(engine, field, field.rows);
    if (rows.rows() == 0) continue;
    ASSERT_TRUE(Staircase::can_hold(rows));
    const Staircase staircase(rows, 20);
    Goodness candidate(field.objectives);
    for (int i = 0; i < 400; ++i) {
      candidate = random_rows(engine, field, 1).row(0).transpose() - 0.5;
      Eigen::Index strictly = 0;
      for (Eigen::Index r = 0; r < rows.rows(); ++r) {
        if ((rows.row(r).transpose() > candidate).all()) ++strictly;
      }
      ASSERT_EQ(staircase.proves_dominators(candidate), strictly >= 20) << candidate.transpose();
    }
  }
}

TEST(Staircase, TakesNoMoreThanThreeObjectivesOfWhichOneIsACount) {
  std::mt19937_64 engine(4);
  EXPECT_TRUE(Staircase::can_hold(random_rows(engine, {2, 1000, 1000, 0}, 500)));
  EXPECT_TRUE(Staircase::can_hold(random_rows(engine, {3, 1000, 32, 0}, 500)));
  EXPECT_FALSE(Staircase::can_hold(random_rows(engine, {3, 1000, 1000, 0}, 500)));
  EXPECT_FALSE(Staircase::can_hold(random_rows(engine, {4, 3, 3, 0}, 500)));
}

TEST(KGreatest, TellsWhetherAsManyAreNotLess) {
  std::mt19937_64 engine(5);
  for (const std::uint64_t levels : {1U, 3U, 100U}) {
    std::vector<double> values;
    KGreatest greatest(7);
    for (int i = 0; i < 200; ++i) {
      for (double threshold = -2; threshold <= 5; threshold += 0.5) {
        const auto not_less =
            std::count_if(values.begin(), values.end(), [&](double v) { return v >= threshold; });
        ASSERT_EQ(greatest.has_all_above(threshold), not_less >= 7) << threshold;
      }
      values.push_back(static_cast<double>(engine() % levels) - 1);
      greatest.add(values.back());
    }
  }
}

}  // namespace
}  // namespace reeve
