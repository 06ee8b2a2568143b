#include "diagnosis/verdict/outlier_groups.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "diagnosis/fit/mounted_draws.hpp"
#include "numerics/binomial.hpp"
#include "numerics/random.hpp"
#include "numerics/student_t.hpp"

namespace reeve::diagnosis {
namespace {

Eigen::VectorXd of_mountings_N(const Problem& problem) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(problem.deviation_N.size());
  for (const SharedScatter& shared : problem.shared) {
    for (std::size_t i = 0; i < shared.cells.size(); ++i) {
      const Eigen::Index k = shared.cells[i];
      result[k] = shared.loadings.row(static_cast<Eigen::Index>(i)).cwiseAbs().sum() *
                  problem.deviation_N[k];
    }
  }
  return result;
}

// Readings of one problem, and others as they would be if nothing but noise and mountings moved
// them. The problem must outlive it.
class JudgedCells {
 public:
  JudgedCells(const Problem& problem, const Forecast& at, const Noise& noise)
      : problem_(problem),
        expected_N_(expected_readings(problem, at)),
        reading_N_(at.reading_N),
        off_N_(own_residuals(problem, at).cwiseProduct(problem.deviation_N)),
        noise_N_(deviations_if_near(*problem.dataset, noise, at.reading_N)),
        deviation_N_(
            (noise_N_.array().square() + of_mountings_N(problem).array().square()).sqrt()) {}

  std::vector<JudgedCell> measured() const { return cells(off_N_); }

  std::vector<JudgedCell> drawn(const MountedDraws& mountings, std::uint64_t seed,
                                std::uint32_t stream) const {
    Eigen::VectorXd off_N =
        mountings.draw(seed, stream, static_cast<std::uint64_t>(reading_N_.size())) - reading_N_;
    for (Eigen::Index i = 0; i < off_N.size(); ++i) {
      off_N[i] += noise_N_[i] * normal(seed, stream, static_cast<std::uint64_t>(i));
    }
    return cells(off_N);
  }

 private:
  std::vector<JudgedCell> cells(const Eigen::VectorXd& off_N) const {
    std::vector<JudgedCell> result;
    for (std::size_t i = 0; i < problem_.dataset->cells.size(); ++i) {
      const Cell& cell = problem_.dataset->cells[i];
      const auto k = static_cast<Eigen::Index>(i);
      result.push_back({cell.reading, problem_.dataset->data->readings[cell.reading].run,
                        cell.channel, expected_N_[k], off_N[k] / deviation_N_[k]});
    }
    return result;
  }

  const Problem& problem_;
  Eigen::VectorXd expected_N_;
  Eigen::VectorXd reading_N_;
  Eigen::VectorXd off_N_;
  Eigen::VectorXd noise_N_;
  Eigen::VectorXd deviation_N_;
};

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
  std::ranges::sort(rows, {}, &SidedRow::load_N);
  double sum = 0;
  for (std::size_t rank = 0; rank < rows.size(); ++rank) {
    if (rows[rank].side > 0) sum += static_cast<double>(rank + 1);
  }
  const double all = above + below;
  const double z = (sum - above * (all + 1) / 2) / std::sqrt(above * below * (all + 1) / 12);
  return std::erfc(std::abs(z) / std::numbers::sqrt2);
}

// A few hundred readings cannot tell that their noise has no heavier tails.
constexpr double most_degrees_of_far = 6;

struct OutlierCount {
  std::size_t all = 0;
  std::size_t far = 0;

  void add(bool is_far) {
    ++all;
    far += is_far ? 1 : 0;
  }
  OutlierCount without(const OutlierCount& part) const { return {all - part.all, far - part.far}; }
};

bool is_far(const JudgedCell& cell) { return std::abs(cell.z) > outlier_deviations; }

using ChannelRun = std::pair<std::size_t, std::size_t>;

struct OutlierCounts {
  OutlierCount whole;
  std::map<std::size_t, OutlierCount> channels;
  std::map<ChannelRun, OutlierCount> runs;

  double groups() const { return static_cast<double>(channels.size() + runs.size()); }
};

OutlierCounts counts_of(const std::vector<JudgedCell>& cells) {
  OutlierCounts counts;
  for (const JudgedCell& cell : cells) {
    const bool far = is_far(cell);
    counts.whole.add(far);
    counts.channels[cell.channel].add(far);
    counts.runs[{cell.channel, cell.run}].add(far);
  }
  return counts;
}

double family_wise_chance(const OutlierCount& part, const OutlierCounts& counts) {
  static const double by_noise = two_sided_p_value(outlier_deviations, most_degrees_of_far);
  const OutlierCount others = counts.whole.without(part);
  const double elsewhere =
      static_cast<double>(others.far + 1) / static_cast<double>(others.all + 1);
  return std::min(
      1.0, counts.groups() * at_least_so_many(part.far, part.all, std::max(by_noise, elsewhere)));
}

double least_chance(const OutlierCounts& counts) {
  double result = 1;
  for (const auto& [channel, count] : counts.channels) {
    result = std::min(result, family_wise_chance(count, counts));
  }
  for (const auto& [run, count] : counts.runs) {
    result = std::min(result, family_wise_chance(count, counts));
  }
  return result;
}

// Two channels, in the order of their readings.
bool read_as_each_other(const std::vector<JudgedCell>& cells, const MeasuredData& data) {
  constexpr double clearly = 5;
  double own = 0;
  double exchanged = 0;
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const JudgedCell& a = cells[i - 1];
    const JudgedCell& b = cells[i];
    if (a.reading != b.reading) continue;
    const auto& tension_N = data.readings[a.reading].tension_N;
    own += std::hypot(*tension_N[a.channel] - a.expected_N, *tension_N[b.channel] - b.expected_N);
    exchanged +=
        std::hypot(*tension_N[a.channel] - b.expected_N, *tension_N[b.channel] - a.expected_N);
  }
  return own > clearly * exchanged;
}

class OutlierFinder {
 public:
  OutlierFinder(const OutlierSearch& search, Workers& workers)
      : search_(search), workers_(workers), limit_(structure_share_of_alpha * search.alpha) {
    add(search.training);
    if (search.held_out != nullptr) add(*search.held_out);
    for (const Part& part : parts_) {
      const std::vector<JudgedCell> measured = part.cells.measured();
      cells_.insert(cells_.end(), measured.begin(), measured.end());
    }
    std::ranges::stable_sort(cells_, {}, &JudgedCell::reading);
    counts_ = counts_of(cells_);
  }

  OutlierReadings find() {
    if (least_chance(counts_) >= limit_) return {};
    if (shares_scatter()) draw_mountings();
    OutlierReadings result;
    std::set<ChannelRun> taken;
    for (const auto& [runs, channels] : channels_by_runs()) {
      for (const std::size_t channel : channels) {
        for (const std::size_t run : runs) taken.insert({channel, run});
      }
      result.together.push_back(together(channels, runs));
    }
    std::ranges::stable_sort(result.together, {}, &OutlierGroups::p_value);
    for (const auto& [run, count] : counts_.runs) {
      if (taken.count(run) > 0) continue;
      result.elsewhere += count.all;
      result.far_elsewhere += count.far;
    }
    return keep_to_something(result) ? result : OutlierReadings{};
  }

 private:
  struct Part {
    const Problem* problem;
    JudgedCells cells;
  };

  void add(const Problem& problem) {
    const Forecast at = forecast(*problem.dataset, search_.model);
    parts_.push_back({&problem, JudgedCells(problem, at, search_.noise)});
  }

  bool shares_scatter() const {
    return std::ranges::any_of(parts_,
                               [](const Part& part) { return !part.problem->shared.empty(); });
  }

  void draw_mountings() {
    std::vector<MountedDraws> mountings;
    for (const Part& part : parts_) {
      mountings.emplace_back(*part.problem->dataset, search_.model, search_.mounting);
    }
    rarest_drawn_.assign(search_.replicates.count, 1);
    workers_.for_each_block(rarest_drawn_.size(), 1, [&](const IndexBlock& block) {
      rarest_drawn_[block.begin] = rarest_of(mountings, block.begin);
    });
  }

  double rarest_of(const std::vector<MountedDraws>& mountings, std::size_t replicate) const {
    std::vector<JudgedCell> drawn;
    for (std::size_t p = 0; p < parts_.size(); ++p) {
      const auto own = parts_[p].cells.drawn(mountings[p], search_.replicates.seed + p,
                                             static_cast<std::uint32_t>(replicate));
      drawn.insert(drawn.end(), own.begin(), own.end());
    }
    return least_chance(counts_of(drawn));
  }

  // With what mountings do by themselves.
  double chance_of(const OutlierCount& part) const {
    const double chance = family_wise_chance(part, counts_);
    if (rarest_drawn_.empty() || chance >= limit_) return chance;
    const auto as_rare =
        std::ranges::count_if(rarest_drawn_, [&](double drawn) { return drawn <= chance; });
    return std::max(
        chance, static_cast<double>(as_rare + 1) / static_cast<double>(rarest_drawn_.size() + 1));
  }

  std::vector<std::size_t> runs_with(std::size_t channel) const {
    std::vector<std::size_t> runs;
    for (const auto& [run, count] : counts_.runs) {
      if (run.first == channel) runs.push_back(run.second);
    }
    return runs;
  }

  // If a channel has too many far readings even without its conspicuous runs, it has them in all
  // runs.
  std::vector<std::size_t> runs_of(std::size_t channel) const {
    std::vector<std::size_t> found;
    OutlierCount rest = counts_.channels.at(channel);
    for (const auto& [run, count] : counts_.runs) {
      if (run.first != channel) continue;
      if (chance_of(count) >= limit_) continue;
      found.push_back(run.second);
      rest = rest.without(count);
    }
    return rest.all > 0 && chance_of(rest) < limit_ ? runs_with(channel) : found;
  }

  std::map<std::vector<std::size_t>, std::vector<std::size_t>> channels_by_runs() const {
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> result;
    for (const auto& [channel, count] : counts_.channels) {
      std::vector<std::size_t> runs = runs_of(channel);
      if (!runs.empty()) result[std::move(runs)].push_back(channel);
    }
    return result;
  }

  OutlierGroups together(const std::vector<std::size_t>& channels,
                         const std::vector<std::size_t>& runs) const {
    OutlierGroups result;
    result.channels = channels;
    result.runs = runs;
    result.everywhere = true;
    std::vector<JudgedCell> own, far;
    for (const JudgedCell& cell : cells_) {
      if (!std::ranges::binary_search(channels, cell.channel) ||
          !std::ranges::binary_search(runs, cell.run)) {
        continue;
      }
      own.push_back(cell);
      if (is_far(cell)) far.push_back(cell);
    }
    result.readings = own.size();
    result.exchanged =
        channels.size() == 2 && read_as_each_other(own, *search_.training.dataset->data);
    for (const JudgedCell& cell : far) {
      if (result.outlier_rows.empty() || result.outlier_rows.back() != cell.reading) {
        result.outlier_rows.push_back(cell.reading);
      }
    }
    result.sides = outlier_sides(far);
    for (const std::size_t channel : channels) {
      result.everywhere &= runs == runs_with(channel);
      result.p_value = std::min(result.p_value, chance_of(counts_.channels.at(channel)));
      for (const std::size_t run : runs) {
        const auto count = counts_.runs.find({channel, run});
        if (count != counts_.runs.end()) {
          result.p_value = std::min(result.p_value, chance_of(count->second));
        }
      }
    }
    return result;
  }

  const OutlierSearch& search_;
  Workers& workers_;
  double limit_;
  std::vector<Part> parts_;
  std::vector<JudgedCell> cells_;
  OutlierCounts counts_;
  std::vector<double> rarest_drawn_;  // empty: no mountings were drawn
};

}  // namespace

OutlierSides outlier_sides(const std::vector<JudgedCell>& far) {
  OutlierSides sides;
  for (const JudgedCell& cell : far) ++(cell.z > 0 ? sides.above : sides.below);
  const std::vector<SidedRow> rows = sided_rows(far);
  const auto above = static_cast<std::size_t>(
      std::ranges::count_if(rows, [](const SidedRow& row) { return row.side > 0; }));
  const std::size_t below = rows.size() - above;
  const double by_load =
      rank_sum_test(rows, static_cast<double>(above), static_cast<double>(below));
  sides.p_value = std::min(1.0, 2 * std::min(sign_test(above, below), by_load));
  return sides;
}

OutlierReadings outlier_readings_together(const OutlierSearch& search, Workers& workers) {
  return OutlierFinder(search, workers).find();
}

bool keep_to_something(const OutlierReadings& found) {
  return static_cast<double>(found.far_elsewhere) <=
         most_far_elsewhere * static_cast<double>(found.elsewhere);
}

bool follow_something(const OutlierGroups& together, double alpha) {
  return !together.everywhere || together.sides.p_value < structure_share_of_alpha * alpha;
}

}  // namespace reeve::diagnosis
