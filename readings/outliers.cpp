#include "readings/outliers.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <tuple>

#include "numerics/robust.hpp"
#include "readings/polished_levels.hpp"

namespace reeve::readings {
namespace {

constexpr std::size_t least_rows = 5;

// The channel behind the last is the motor tension.
const std::optional<double>& cell_value(const Reading& reading, std::size_t channel) {
  return channel < reading.tension_N.size() ? reading.tension_N[channel] : reading.motor_tension_N;
}

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
  bool is_held = false;  // its value is that of the row above
};

// Cells whose value is exactly that of the row above in their run, and nowhere else: what a sensor
// reads at its end or in coarse steps comes again.
class HeldValues {
 public:
  explicit HeldValues(const MeasuredData& data) : cells_(data.channels.size() + 1) {
    for (std::size_t channel = 0; channel < cells_.size(); ++channel) add(data, channel);
  }

  bool has(const KindCell& cell) const {
    return cells_[cell.channel].at(cell.value_N).contains(cell.reading);
  }

 private:
  using Rows = std::set<std::size_t>;

  void add(const MeasuredData& data, std::size_t channel) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> rows;  // by run and line
    for (std::size_t r = 0; r < data.readings.size(); ++r) {
      if (cell_value(data.readings[r], channel)) {
        rows[{data.readings[r].run, data.readings[r].line}] = r;
      }
    }
    std::map<double, std::size_t> times;  // that the channel comes to a value
    const Reading* above = nullptr;
    for (const auto& [place, r] : rows) {
      const Reading& reading = data.readings[r];
      const double value_N = *cell_value(reading, channel);
      Rows& held = cells_[channel][value_N];
      const bool repeats =
          above != nullptr && above->run == reading.run && cell_value(*above, channel) == value_N;
      if (repeats) {
        held.insert(r);
      } else {
        ++times[value_N];
      }
      above = &reading;
    }
    for (auto& [value_N, held] : cells_[channel]) {
      if (times[value_N] > 1) held.clear();
    }
  }

  std::vector<std::map<double, Rows>> cells_;  // [channel], the motor's last
};

void add_far_cells(const KindCells& cells, std::size_t motor, const HeldValues& held,
                   std::vector<FarCell>& far) {
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
    const double step_N = outlier_steps * least_step(spread.readings);
    const double usual_log = median(spread.logs);
    const double usual_N = median(spread.newtons);
    for (const KindCell& cell : cells) {
      const double expected_N = levels.expected_N(cell);
      if (cell.channel != channel || !(expected_N > 0)) continue;
      const bool is_held = held.has(cell);
      const double deviations = is_held ? held_deviations : outlier_deviations;
      const double log_bound =
          std::max(std::log(is_held ? held_factor : outlier_factor), deviations * usual_log);
      const double newton_bound = std::max(deviations * usual_N, step_N);
      // A cell below zero is far only if its size is too large: a drifting zero is no slip.
      const double off = std::log(std::abs(cell.value_N) / expected_N);
      const bool is_far = cell.value_N > 0 ? std::abs(off) > log_bound : off > log_bound;
      if (is_far && std::abs(cell.value_N - expected_N) > newton_bound) {
        far.push_back({cell, expected_N, is_held});
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

enum class Fate : std::uint8_t { held, left_out, kept };

DataNote note_on(const MeasuredData& data, const std::vector<FarCell>& far, Fate fate) {
  constexpr const char* ends[] = {
      ". Each repeats the line above, and is left out: does the logger hold its last value?",
      ". These readings are left out: are they slips of a decimal point?",
      ". That is more than slips are, so nothing is left out"};
  constexpr std::size_t most_told = 5;
  DataNote note{NoteKind::outlier, "", {}};
  for (std::size_t i = 0; i < far.size(); ++i) {
    note.lines.push_back(data.readings[far[i].cell.reading].line);
    if (i < most_told) note.text += (i == 0 ? "" : "; ") + told(data, far[i]);
  }
  if (far.size() > most_told) note.text += fmt::format("; and {} more", far.size() - most_told);
  note.text += ends[static_cast<std::size_t>(fate)];
  std::sort(note.lines.begin(), note.lines.end());
  note.lines.erase(std::unique(note.lines.begin(), note.lines.end()), note.lines.end());
  return note;
}

}  // namespace

void set_outliers_aside(MeasuredData& data) {
  const std::vector<KindCells> all = cells_by_kind(data);
  const HeldValues held(data);
  std::size_t count = 0;
  std::vector<FarCell> far;
  for (const KindCells& cells : all) {
    count += cells.size();
    add_far_cells(cells, data.channels.size(), held, far);
  }
  const Patterns patterns(data, all, far);
  std::erase_if(far, [&](const FarCell& cell) { return patterns.has(cell.cell); });
  std::sort(far.begin(), far.end(), [](const FarCell& a, const FarCell& b) {
    return std::tie(a.cell.reading, a.cell.channel) < std::tie(b.cell.reading, b.cell.channel);
  });
  const auto slips = std::stable_partition(far.begin(), far.end(),
                                           [](const FarCell& cell) { return cell.is_held; });
  const std::vector<FarCell> slipped(slips, far.end());
  far.erase(slips, far.end());
  const bool kept = static_cast<double>(slipped.size()) >
                    std::max(1.0, std::floor(most_outliers * static_cast<double>(count)));
  if (!far.empty()) data.notes.push_back(note_on(data, far, Fate::held));
  if (!slipped.empty()) {
    data.notes.push_back(note_on(data, slipped, kept ? Fate::kept : Fate::left_out));
  }
  if (!kept) far.insert(far.end(), slipped.begin(), slipped.end());
  for (const FarCell& cell : far) value(data, cell.cell).reset();
  if (far.empty()) return;
  std::erase_if(data.readings, [](const Reading& reading) {
    return std::none_of(reading.tension_N.begin(), reading.tension_N.end(),
                        [](const auto& tension) { return tension.has_value(); });
  });
}

}  // namespace reeve::readings
