#include "diagnosis/verdict/share_error.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

#include "readings/measured_shares.hpp"

namespace reeve::diagnosis {
namespace {

// A row's strands, T1 … T2n, if all are there.
struct Strands {
  std::vector<double> measured, before, after, left_out;
  bool held_out = false;
};

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

using Cells = std::vector<const ComparedCell*>;

std::optional<Strands> strands(const MeasuredData& data, const Cells& row) {
  const Reading& reading = data.readings[row.front()->cell.reading];
  if (reading.direction != Direction::pull) return std::nullopt;
  Strands result;
  for (const std::size_t channel : strand_channels(data, data.routings[reading.routing])) {
    const auto found = std::ranges::find_if(
        row, [&](const ComparedCell* cell) { return cell->cell.channel == channel; });
    if (found == row.end()) return std::nullopt;
    const ComparedCell& cell = **found;
    result.measured.push_back(cell.cell.measured_N);
    result.before.push_back(cell.before_N);
    result.after.push_back(cell.after_N);
    if (cell.left_out_N) result.left_out.push_back(*cell.left_out_N);
    result.held_out = cell.held_out;
  }
  if (!(sum(result.measured) > 0 && sum(result.before) > 0 && sum(result.after) > 0)) {
    return std::nullopt;
  }
  return result;
}

ShareError& group_of(std::vector<ShareError>& groups, const Reading& reading) {
  for (ShareError& group : groups) {
    if (group.routing == reading.routing && group.grasp == reading.grasp) return group;
  }
  groups.push_back({reading.routing, reading.grasp, 0, 0, 0, 0, 0.0});
  return groups.back();
}

void add(const Strands& row, ShareError& group) {
  ++group.rows;
  group.held_out_rows += row.held_out ? 1 : 0;
  group.before += share_distance(row.measured, row.before);
  group.after += share_distance(row.measured, row.after);
  const bool known = row.left_out.size() == row.measured.size() && sum(row.left_out) > 0;
  if (!known) group.left_out.reset();
  if (group.left_out) *group.left_out += share_distance(row.measured, row.left_out);
}

template <typename Get>
double mean(const std::vector<ShareError>& groups, Get get) {
  double total = 0;
  for (const ShareError& group : groups) total += std::invoke(get, group);
  return total / static_cast<double>(groups.size());
}

}  // namespace

double distance_to_shares(const std::vector<double>& tensions, const std::vector<double>& shares) {
  const double whole = sum(tensions);
  double squares = 0;
  for (std::size_t i = 0; i < shares.size(); ++i) {
    squares += std::pow(tensions[i] / whole - shares[i], 2);
  }
  return std::sqrt(squares);
}

double share_distance(const std::vector<double>& a, const std::vector<double>& b) {
  const double whole = sum(b);
  std::vector<double> shares;
  for (const double tension : b) shares.push_back(tension / whole);
  return distance_to_shares(a, shares);
}

ShareErrors share_errors(const MeasuredData& data, const std::vector<ComparedCell>& cells) {
  ShareErrors result;
  for (std::size_t first = 0, last = 0; first < cells.size(); first = last) {
    const std::size_t reading = cells[first].cell.reading;
    Cells row;
    for (; last < cells.size() && cells[last].cell.reading == reading; ++last) {
      row.push_back(&cells[last]);
    }
    const auto found = strands(data, row);
    if (found) add(*found, group_of(result.groups, data.readings[reading]));
  }
  if (result.groups.empty()) return result;
  for (ShareError& group : result.groups) {
    const auto rows = static_cast<double>(group.rows);
    group.before /= rows;
    group.after /= rows;
    if (group.left_out) *group.left_out /= rows;
  }
  result.before = mean(result.groups, &ShareError::before);
  result.after = mean(result.groups, &ShareError::after);
  if (std::ranges::all_of(result.groups,
                          [](const ShareError& group) { return group.left_out.has_value(); })) {
    result.left_out = mean(result.groups, [](const ShareError& group) { return *group.left_out; });
  }
  return result;
}

}  // namespace reeve::diagnosis
