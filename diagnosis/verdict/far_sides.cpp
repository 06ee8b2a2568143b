#include "diagnosis/verdict/far_sides.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "numerics/binomial.hpp"

namespace reeve::diagnosis {
namespace {

struct SidedRow {
  double load_N = 0;  // the mean of what its far cells should read
  int side = 0;
};

// Rows that are as far on one side as on the other tell nothing.
std::vector<SidedRow> sided_rows(const std::vector<JudgedCell>& far) {
  std::vector<SidedRow> rows;
  for (auto cell = far.begin(); cell != far.end();) {
    const auto next = std::find_if(
        cell, far.end(), [&](const JudgedCell& other) { return other.reading != cell->reading; });
    SidedRow row;
    for (auto each = cell; each != next; ++each) {
      row.side += each->z > 0 ? 1 : -1;
      row.load_N += each->expected_N / static_cast<double>(next - cell);
    }
    if (row.side != 0) rows.push_back(row);
    cell = next;
  }
  return rows;
}

double sign_test(std::size_t above, std::size_t below) {
  return std::min(1.0, 2 * at_least_so_many(std::max(above, below), above + below, 0.5));
}

double rank_sum_test(std::vector<SidedRow> rows, double above, double below) {
  if (above == 0 || below == 0) return 1;
  std::sort(rows.begin(), rows.end(),
            [](const SidedRow& a, const SidedRow& b) { return a.load_N < b.load_N; });
  double sum = 0;
  for (std::size_t rank = 0; rank < rows.size(); ++rank) {
    if (rows[rank].side > 0) sum += static_cast<double>(rank + 1);
  }
  const double all = above + below;
  const double z = (sum - above * (all + 1) / 2) / std::sqrt(above * below * (all + 1) / 12);
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

}  // namespace

FarSides far_sides(const std::vector<JudgedCell>& far) {
  FarSides sides;
  for (const JudgedCell& cell : far) ++(cell.z > 0 ? sides.above : sides.below);
  const std::vector<SidedRow> rows = sided_rows(far);
  const auto above = static_cast<std::size_t>(
      std::count_if(rows.begin(), rows.end(), [](const SidedRow& row) { return row.side > 0; }));
  const std::size_t below = rows.size() - above;
  const double by_load =
      rank_sum_test(rows, static_cast<double>(above), static_cast<double>(below));
  sides.p_value = std::min(1.0, 2 * std::min(sign_test(above, below), by_load));
  return sides;
}

}  // namespace reeve::diagnosis
