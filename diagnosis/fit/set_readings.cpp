#include "diagnosis/fit/set_readings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "numerics/robust.hpp"

namespace reeve::diagnosis {
namespace {

constexpr std::size_t few_pairs = 3;
constexpr std::size_t few_clusters = 3;

struct Pair {
  double reading_N = 0;
  double motor_N = 0;
  std::size_t run = 0;
};

using Cluster = std::span<const Pair>;

// By their readings. Returns nothing if the rows have several, or a known scatter.
std::optional<std::vector<Pair>> pairs_of(const Dataset& dataset, const ReadingBlock& block) {
  std::vector<Pair> pairs;
  for (const std::size_t r : block.rows) {
    const DatasetRow& row = dataset.rows[r];
    if (!row.has_motor_tension || row.motor_deviation_N > 0 || row.last - row.first != 1) {
      return std::nullopt;
    }
    pairs.push_back({dataset.cells[row.first].measured_N, row.conditions.motor_tension_N,
                     dataset.data->readings[row.reading].run});
  }
  std::ranges::sort(pairs, {}, &Pair::reading_N);
  return pairs;
}

// Gaps that are wide beside the usual step from one reading to the next part them.
std::vector<Cluster> clusters_of(const std::vector<Pair>& pairs) {
  constexpr double wide = 30;
  std::vector<double> steps;
  for (std::size_t i = 1; i < pairs.size(); ++i) {
    steps.push_back(pairs[i].reading_N - pairs[i - 1].reading_N);
  }
  const double gap = wide * numerics::median(steps);
  std::vector<Cluster> clusters;
  for (std::size_t begin = 0, end = 0; begin < pairs.size(); begin = end) {
    for (end = begin + 1; end < pairs.size() && !(steps[end - 1] > gap);) ++end;
    if (end - begin >= few_pairs) clusters.emplace_back(&pairs[begin], end - begin);
  }
  return clusters;
}

Pair mean_of(Cluster pairs) {
  Pair mean;
  for (const Pair& pair : pairs) {
    mean.reading_N += pair.reading_N / static_cast<double>(pairs.size());
    mean.motor_N += pair.motor_N / static_cast<double>(pairs.size());
  }
  return mean;
}

// How readings follow the motor tension: sums over differences of the two.
struct Following {
  double motor_square = 0;
  double product = 0;

  void add(double weight, const Pair& pair, const Pair& mean) {
    const double motor_N = pair.motor_N - mean.motor_N;
    motor_square += weight * motor_N * motor_N;
    product += weight * motor_N * (pair.reading_N - mean.reading_N);
  }
  double slope() const { return product / motor_square; }
};

struct ClusterSums {
  Following within;
  Following between;
  double of_readings = 0;  // squares of relative differences within clusters
  double of_motor = 0;
  double degrees = 0;
  std::size_t clusters = 0;
  std::size_t most_of_a_block = 0;
  std::map<std::size_t, std::set<std::size_t>> clusters_of_run;

  void add(Cluster cluster, const Pair& mean_of_block) {
    const Pair own = mean_of(cluster);
    for (const Pair& pair : cluster) {
      within.add(1, pair, own);
      of_readings += std::pow(pair.reading_N / own.reading_N - 1, 2);
      of_motor += std::pow(pair.motor_N / own.motor_N - 1, 2);
      clusters_of_run[pair.run].insert(clusters);
    }
    between.add(static_cast<double>(cluster.size()), own, mean_of_block);
    degrees += static_cast<double>(cluster.size() - 1);
    ++clusters;
  }

  bool readings_follow() const {
    constexpr double followed = 0.5;
    return most_of_a_block < few_clusters || !(between.motor_square > 0) ||
           within.slope() >= followed * between.slope();
  }
};

}  // namespace

std::optional<SetReadings> set_readings(const Dataset& dataset) {
  constexpr double exact = 1e-3;
  ClusterSums sums;
  for (const ReadingBlock& block : dataset.blocks) {
    const auto pairs = pairs_of(dataset, block);
    if (!pairs) return std::nullopt;
    const std::vector<Cluster> clusters = clusters_of(*pairs);
    for (const Cluster cluster : clusters) sums.add(cluster, mean_of(*pairs));
    sums.most_of_a_block = std::max(sums.most_of_a_block, clusters.size());
  }
  if (sums.clusters == 0 || !(sums.of_motor > sums.of_readings)) return std::nullopt;
  if (sums.readings_follow() && sums.of_readings > exact * exact * sums.of_motor) {
    return std::nullopt;
  }
  const bool one_of_each_run = std::ranges::all_of(
      sums.clusters_of_run, [](const auto& of) { return of.second.size() == 1; });
  return SetReadings{std::sqrt(sums.within.motor_square / sums.degrees), one_of_each_run,
                     sums.most_of_a_block >= few_clusters};
}

}  // namespace reeve::diagnosis
