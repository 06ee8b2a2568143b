#include "reports/data_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/output/csv_field.hpp"

namespace reeve::reports {
namespace {

std::string lines_text(const std::vector<std::size_t>& lines) {
  constexpr std::size_t most = 8;
  if (lines.empty()) return "";
  std::vector<std::string> numbers;
  for (const std::size_t line : lines) numbers.push_back(std::to_string(line));
  return fmt::format(" (line{} {})", lines.size() == 1 ? "" : "s", enumerated(numbers, ", ", most));
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
