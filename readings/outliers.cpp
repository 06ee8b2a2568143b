#include "readings/outliers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <tuple>

#include "numerics/robust.hpp"
#include "readings/polished_levels.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_rows = 5;

std::optional<double>& value(MeasuredData& data, const KindCell& cell) {
  Reading& reading = data.readings[cell.reading];
  return cell.channel < data.channels.size() ? reading.tension_N[cell.channel]
                                             : reading.motor_tension_N;
}

// Distances of one channel's cells from their levels.
struct CellSpread {
  std::vector<double> logs;
  std::vector<double> newtons;
  std::vector<double> readings;
};

struct FarCell {
  KindCell cell;
  double expected_N = 0;
};

void add_far_cells(const KindCells& cells, std::size_t motor, std::vector<FarCell>& far) {
  const PolishedLevels levels = polished_levels(cells, motor);
  std::map<std::size_t, CellSpread> spreads;
  for (const KindCell& cell : cells) {
    const double expected_N = levels.expected_N(cell);
    if (!(expected_N > 0)) continue;
    CellSpread& spread = spreads[cell.channel];
    spread.readings.push_back(cell.value_N);
    spread.newtons.push_back(std::abs(cell.value_N - expected_N));
    if (cell.value_N > 0) spread.logs.push_back(std::abs(std::log(cell.value_N / expected_N)));
  }
  for (auto& [channel, spread] : spreads) {
    if (spread.logs.size() < least_rows) continue;
    const double log_bound =
        std::max(std::log(outlier_factor), outlier_deviations * median(spread.logs));
    const double newton_bound = std::max(outlier_deviations * median(spread.newtons),
                                         outlier_steps * least_step(spread.readings));
    for (const KindCell& cell : cells) {
      const double expected_N = levels.expected_N(cell);
      if (cell.channel != channel || !(expected_N > 0)) continue;
      // A cell below zero is far only if its size is too large: a drifting zero is no slip.
      const double off = std::log(std::abs(cell.value_N) / expected_N);
      const bool is_far = cell.value_N > 0 ? std::abs(off) > log_bound : off > log_bound;
      if (is_far && std::abs(cell.value_N - expected_N) > newton_bound) {
        far.push_back({cell, expected_N});
      }
    }
  }
}

// Finds rows, and channels of runs, of which more than half of the cells are far.
class Patterns {
 public:
  Patterns(const MeasuredData& data, const std::vector<KindCells>& all,
           const std::vector<FarCell>& far)
      : data_(data) {
    for (const KindCells& cells : all) {
      for (const KindCell& cell : cells) {
        ++rows_[cell.reading].all;
        ++runs_[of_run(cell)].all;
      }
    }
    for (const FarCell& cell : far) {
      ++rows_[cell.cell.reading].far;
      ++runs_[of_run(cell.cell)].far;
    }
  }

  bool has(const KindCell& cell) const {
    const Count& row = rows_.at(cell.reading);
    const Count& run = runs_.at(of_run(cell));
    if (2 * row.far > row.all) return true;
    return run.all == 1 ? row.far > 1 : 2 * run.far > run.all;
  }

 private:
  struct Count {
    std::size_t all = 0;
    std::size_t far = 0;
  };

  std::pair<std::size_t, std::size_t> of_run(const KindCell& cell) const {
    return {data_.readings[cell.reading].run, cell.channel};
  }

  const MeasuredData& data_;
  std::map<std::size_t, Count> rows_;
  std::map<std::pair<std::size_t, std::size_t>, Count> runs_;
};

std::string told(const MeasuredData& data, const FarCell& far) {
  const std::string name = far.cell.channel < data.channels.size()
                               ? data.channels[far.cell.channel].name
                               : "the motor tension";
  return fmt::format(
      "{} reads {:.4g} N in line {}, where by all others it should read about "
      "{:.3g} N",
      name, far.cell.value_N, data.readings[far.cell.reading].line, far.expected_N);
}

DataNote note_on(const MeasuredData& data, const std::vector<FarCell>& far, bool kept) {
  constexpr std::size_t most_told = 5;
  DataNote note{NoteKind::outlier, "", {}};
  for (std::size_t i = 0; i < far.size(); ++i) {
    note.lines.push_back(data.readings[far[i].cell.reading].line);
    if (i < most_told) note.text += (i == 0 ? "" : "; ") + told(data, far[i]);
  }
  if (far.size() > most_told) note.text += fmt::format("; and {} more", far.size() - most_told);
  note.text += kept ? ". That is more than slips are, so nothing is left out"
                    : ". These readings are left out: are they slips of a decimal point?";
  std::sort(note.lines.begin(), note.lines.end());
  note.lines.erase(std::unique(note.lines.begin(), note.lines.end()), note.lines.end());
  return note;
}

}  // namespace

void set_outliers_aside(MeasuredData& data) {
  const std::vector<KindCells> all = cells_by_kind(data);
  std::size_t count = 0;
  std::vector<FarCell> far;
  for (const KindCells& cells : all) {
    count += cells.size();
    add_far_cells(cells, data.channels.size(), far);
  }
  const Patterns patterns(data, all, far);
  std::erase_if(far, [&](const FarCell& cell) { return patterns.has(cell.cell); });
  if (far.empty()) return;
  std::sort(far.begin(), far.end(), [](const FarCell& a, const FarCell& b) {
    return std::tie(a.cell.reading, a.cell.channel) < std::tie(b.cell.reading, b.cell.channel);
  });
  const bool kept = static_cast<double>(far.size()) >
                    std::max(1.0, std::floor(most_outliers * static_cast<double>(count)));
  data.notes.push_back(note_on(data, far, kept));
  if (kept) return;
  for (const FarCell& cell : far) value(data, cell.cell).reset();
  std::erase_if(data.readings, [](const Reading& reading) {
    return std::none_of(reading.tension_N.begin(), reading.tension_N.end(),
                        [](const auto& tension) { return tension.has_value(); });
  });
}

}  // namespace reeve::readings
