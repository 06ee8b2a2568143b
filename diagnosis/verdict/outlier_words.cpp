#include "diagnosis/verdict/outlier_words.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "diagnosis/verdict/run_words.hpp"

namespace reeve::diagnosis {
namespace {

std::string channels_text(const std::vector<std::size_t>& channels, const MeasuredData& data) {
  std::vector<std::string> names;
  for (const std::size_t channel : channels) names.push_back(data.channels[channel].name);
  return listed(names);
}

std::string sides_text(const OutlierSides& sides) {
  if (sides.below == 0) return "all of them more";
  if (sides.above == 0) return "all of them less";
  return fmt::format("{} more, {} less", sides.above, sides.below);
}

}  // namespace

std::string where_text(const OutlierGroups& together, const MeasuredData& data) {
  return channels_text(together.channels, data) + " in " + runs_text(together.runs, data);
}

DataNote note_on(const OutlierGroups& together, const OutlierReadings& all,
                 const MeasuredData& data, double alpha) {
  DataNote note{NoteKind::outlier_groups, "", {}};
  for (const std::size_t reading : together.outlier_rows) {
    note.lines.push_back(data.readings[reading].line);
  }
  std::sort(note.lines.begin(), note.lines.end());
  note.text = fmt::format(
      "{} of the {} readings of {} are more than {:g} standard deviations off what the model says "
      "({}), and {} of {} elsewhere. ",
      together.far(), together.readings, where_text(together, data), outlier_deviations,
      sides_text(together.sides), all.far_elsewhere, all.elsewhere);
  note.text +=
      follow_something(together, alpha)
          ? "Noise chooses no channel, no run and no side: look at the sensor there, and at what was "
            "written down of these rows"
          : fmt::format(
                "That is in all runs and on either side: if {} known to scatter so, give its noise",
                channels_text(together.channels, data) +
                    (together.channels.size() == 1 ? " is" : " are"));
  return note;
}

}  // namespace reeve::diagnosis
