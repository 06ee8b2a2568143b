// Measured data from the text of a CSV file; routings are words, and TR3 and TR5 names.
#pragma once

#include <string>
#include <vector>

#include "core/notation.hpp"
#include "readings/measured_data.hpp"
#include "tests/support/input_error.hpp"

namespace reeve::testing {

inline MeasuredData read_data(const std::string& text, const ReadingOptions& options = {}) {
  return parse_measured_data(
      text, "d.csv",
      [](const std::string& routing) {
        if (routing == "TR3") return parse_routing("F-1-P-2-F");
        if (routing == "TR5") return parse_routing("M-1-P-2-M");
        return parse_routing(routing);
      },
      options);
}

inline std::string data_error(const std::string& text, const ReadingOptions& options = {}) {
  return input_error([&] { read_data(text, options); });
}

// The lines of the first note of a kind; empty if there is none.
inline std::vector<std::size_t> noted_lines(const std::vector<DataNote>& notes, NoteKind kind) {
  for (const DataNote& note : notes) {
    if (note.kind == kind) return note.lines;
  }
  return {};
}

// The text of the first note of a kind; empty if there is none.
inline std::string note_text(const std::vector<DataNote>& notes, NoteKind kind) {
  for (const DataNote& note : notes) {
    if (note.kind == kind) return note.text;
  }
  return {};
}

inline std::size_t count_notes(const std::vector<DataNote>& notes, NoteKind kind) {
  std::size_t count = 0;
  for (const DataNote& note : notes) count += note.kind == kind ? 1 : 0;
  return count;
}

}  // namespace reeve::testing
