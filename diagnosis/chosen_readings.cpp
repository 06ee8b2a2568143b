#include "diagnosis/chosen_readings.hpp"

#include <fmt/format.h>

#include <utility>

#include "core/error.hpp"
#include "diagnosis/run_split.hpp"

namespace reeve::diagnosis {
namespace {

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
      data.readings.size() - split.dropped.size() - sample.rows - sample.thinned_rows;
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
  if (sample.held_out.cells.empty()) {
    add_note(sample,
             data.runs.size() < 2
                 ? "there is one run only: nothing can be held out, so no gain can be tested"
                 : "nothing is held out, so no gain can be tested");
  }
}

}  // namespace

Sample sample(const MeasuredData& data, double share, std::uint64_t seed) {
  const RunSplit split = split_by_run(data, share, seed);
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
