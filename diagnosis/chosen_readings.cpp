#include "diagnosis/chosen_readings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "core/error.hpp"
#include "numerics/random.hpp"
#include "numerics/streams.hpp"
#include "readings/copies.hpp"

namespace reeve::diagnosis {
namespace {

// Runs by the routings they were measured on, each list in an order drawn by the seed; the longest
// list first, lists of one length in an order drawn by the seed. Runs that are nothing but
// repetitions cannot be held out.
std::vector<std::vector<std::size_t>> strata(const MeasuredData& data,
                                             const std::set<std::size_t>& dropped,
                                             std::uint64_t seed) {
  std::vector<std::set<std::size_t>> routings(data.runs.size());
  for (std::size_t i = 0; i < data.readings.size(); ++i) {
    if (dropped.count(i) != 0) continue;
    routings[data.readings[i].run].insert(data.readings[i].routing);
  }
  std::map<std::set<std::size_t>, std::vector<std::size_t>> by_routings;
  for (std::size_t run = 0; run < data.runs.size(); ++run) {
    if (!routings[run].empty()) by_routings[routings[run]].push_back(run);
  }
  const auto drawn = [&](std::size_t run) { return uniform(seed, streams::hold_out, run); };
  std::vector<std::vector<std::size_t>> result;
  for (auto& [key, runs] : by_routings) {
    std::ranges::stable_sort(runs,
                             [&](std::size_t a, std::size_t b) { return drawn(a) < drawn(b); });
    result.push_back(runs);
  }
  std::ranges::stable_sort(result, [&](const auto& a, const auto& b) {
    if (a.size() != b.size()) return a.size() > b.size();
    return drawn(a.front()) < drawn(b.front());
  });
  return result;
}

std::set<std::size_t> draw_held_out(const MeasuredData& data, const std::set<std::size_t>& dropped,
                                    double share, std::uint64_t seed) {
  std::set<std::size_t> held;
  auto left = strata(data, dropped, seed);
  std::size_t count = 0;
  for (const auto& runs : left) count += runs.size();
  if (share <= 0 || count < 2) return held;
  const auto wanted = std::clamp<std::size_t>(
      static_cast<std::size_t>(std::lround(share * static_cast<double>(count))), 1, count - 1);
  // If every routing has one run only, a run that is alone on its routing may be held out.
  for (const std::size_t least : {std::size_t{2}, std::size_t{1}}) {
    for (bool found = true; found && held.size() < wanted;) {
      found = false;
      for (auto& runs : left) {
        if (runs.size() < least || held.size() == wanted) continue;
        held.insert(runs.back());
        runs.pop_back();
        found = true;
      }
    }
    if (!held.empty()) break;
  }
  return held;
}

void add_note(Sample& sample, std::string text, std::vector<std::size_t> lines = {}) {
  sample.notes.push_back({NoteKind::not_compared, std::move(text), std::move(lines)});
}

void note_what_is_left_out(const MeasuredData& data, const RunSplit& split, Sample& sample) {
  if (!split.dropped.empty()) {
    std::vector<std::size_t> lines;
    for (const std::size_t i : split.dropped) lines.push_back(data.readings[i].line);
    add_note(sample, "rows that are copies of an earlier one are left out of the diagnosis",
             std::move(lines));
  }
  const std::size_t silent =
      split.training.size() + split.held_out.size() - sample.rows - sample.thinned_rows;
  if (silent > 0) {
    add_note(sample,
             fmt::format("{} rows without motor tension, or with a motor tension of 0, have fewer "
                         "than two tensions that say something: they are left out of the diagnosis",
                         silent));
  }
  if (sample.thinned_rows > 0) {
    add_note(sample, fmt::format("{} rows are left out evenly: {} say as much about which cause it "
                                 "is",
                                 sample.thinned_rows, sample.rows));
  }
  if (data.runs.size() < 2) {
    add_note(sample, "there is one run only: nothing can be held out, so no gain can be tested");
  }
}

}  // namespace

RunSplit split_by_run(const MeasuredData& data, double share, std::uint64_t seed,
                      const std::vector<std::size_t>& incomplete) {
  RunSplit split;
  split.dropped = repeated_readings(data);
  std::set<std::size_t> dropped(split.dropped.begin(), split.dropped.end());
  dropped.insert(incomplete.begin(), incomplete.end());
  const std::set<std::size_t> held = draw_held_out(data, dropped, share, seed);
  for (std::size_t i = 0; i < data.readings.size(); ++i) {
    if (dropped.count(i) != 0) continue;
    (held.count(data.readings[i].run) != 0 ? split.held_out : split.training).push_back(i);
  }
  for (std::size_t run = 0; run < data.runs.size(); ++run) {
    if (held.count(run) != 0) split.held_out_runs.push_back(run);
  }
  return split;
}

std::vector<std::size_t> thinned(const MeasuredData& data, std::vector<std::size_t> readings,
                                 std::size_t most) {
  if (readings.size() <= most) return readings;
  std::map<std::size_t, std::vector<std::size_t>> by_run;
  for (const std::size_t i : readings) by_run[data.readings[i].run].push_back(i);
  const double share = static_cast<double>(most) / static_cast<double>(readings.size());
  std::vector<std::size_t> kept;
  // Goes on from run to run: rounded in each, many short runs would keep more than `most`.
  double due = 0.5;
  for (const auto& [run, list] : by_run) {
    for (const std::size_t i : list) {
      due += share;
      if (due < 1) continue;
      due -= 1;
      kept.push_back(i);
    }
  }
  std::ranges::sort(kept);
  return kept;
}

Sample sample(const MeasuredData& data, double share, std::uint64_t seed,
              const std::vector<std::size_t>& incomplete) {
  const RunSplit split = split_by_run(data, share, seed, incomplete);
  Sample result;
  const auto thin = [&](const std::vector<std::size_t>& readings) {
    std::vector<std::size_t> kept = thinned(data, readings, most_readings);
    result.thinned_rows += readings.size() - kept.size();
    return kept;
  };
  result.training = dataset(data, thin(split.training));
  result.held_out = dataset(data, thin(split.held_out));
  if (result.training.cells.empty()) {
    throw InputError(
        {.where = data.file,
         .what = "there is nothing to diagnose",
         .expected = "rows with motor_tension_N, or with two tensions that are not both slack"});
  }
  result.rows = result.training.rows.size() + result.held_out.rows.size();
  result.runs = data.runs.size();
  result.held_out_runs = result.held_out.cells.empty() ? 0 : split.held_out_runs.size();
  result.dropped_duplicates = split.dropped.size();
  result.notes = data.notes;
  note_what_is_left_out(data, split, result);
  return result;
}

}  // namespace reeve::diagnosis
