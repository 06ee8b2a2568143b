#include "reports/data_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/output/csv_field.hpp"

namespace reeve::reports {
namespace {

std::string lines_text(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 8;
  if (lines.empty()) return "";
  std::string text = lines.size() == 1 ? " (line " : " (lines ";
  for (std::size_t i = 0; i < lines.size() && i < most; ++i) {
    text += (i == 0 ? "" : ", ") + std::to_string(lines[i]);
  }
  if (lines.size() > most) text += fmt::format(" and {} more", lines.size() - most);
  return text + ")";
}

}  // namespace

std::string plural(std::size_t count, const std::string& noun) {
  return fmt::format("{} {}{}", count, noun, count == 1 ? "" : "s");
}

DocumentLine simulated_line() { return {fmt::format("The data are {}.", simulated_text), true}; }

std::string held_field(Grasp grasp) {
  return fmt::format("{}", fmt::join(held_fingers(grasp), ";"));
}

const char* direction_field(Direction direction) {
  return direction == Direction::pull ? "pull" : "release";
}

std::string group_heading(const MeasuredData& data) { return data.groups.empty() ? "" : ",group"; }

std::string group_field(const MeasuredData& data, const Reading& reading) {
  if (data.groups.empty()) return "";
  return "," + (reading.group ? csv_field(data.groups[*reading.group]) : "");
}

Section notes_section(const std::vector<DataNote>& notes) {
  Section section{"Notes", std::nullopt, {}};
  for (const DataNote& note : notes) {
    section.lines.push_back({"- " + note.text + lines_text(note.lines)});
  }
  return section;
}

Json notes_json(const std::vector<DataNote>& notes) {
  return list_json(notes, [](const DataNote& note) {
    return Json{{"kind", note_kind_name(note.kind)}, {"text", note.text}, {"lines", note.lines}};
  });
}

}  // namespace reeve::reports
