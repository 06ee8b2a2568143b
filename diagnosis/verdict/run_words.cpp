#include "diagnosis/verdict/run_words.hpp"

#include <fmt/format.h>

#include <algorithm>

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
  std::ranges::sort(note.lines);
  note.text = fmt::format(
      "{} of the {} readings of {} are more than {:g} standard deviations off what the model says "
      "({}), and {} of {} elsewhere. ",
      together.far(), together.readings, where_text(together, data), outlier_deviations,
      sides_text(together.sides), all.far_elsewhere, all.elsewhere);
  if (together.exchanged) {
    note.text += "Each reads as the other should: are they exchanged there?";
    return note;
  }
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

std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i) {
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  }
  return text;
}

std::string runs_text(const std::vector<std::size_t>& runs, const MeasuredData& data) {
  if (runs.size() > 1 && runs.size() == data.runs.size()) return "all runs";
  std::vector<std::string> names;
  for (const std::size_t run : runs) names.push_back(data.runs[run]);
  const bool say_it = std::ranges::all_of(names, [](const std::string& name) {
    return name.starts_with("run") || name.starts_with("Run");
  });
  const std::string what = say_it ? "" : names.size() == 1 ? "run " : "runs ";
  const bool in_a_row = runs.back() - runs.front() + 1 == runs.size();
  return what +
         (runs.size() > 2 && in_a_row ? names.front() + " to " + names.back() : listed(names));
}

}  // namespace reeve::diagnosis
