// A table in columns that are aligned, numbers to the right.
#pragma once

#include <cstddef>
#include <string>

#include "reports/document/document.hpp"

namespace reeve::reports {

// Where text is shown. By default no window limits it and nothing can show colour: a file, a pipe.
struct TextStyle {
  std::size_t width = 0;  // in columns; 0: any
  bool colour = false;
};

// In a narrow window dispensable columns are left out, which a line below says; then texts are
// wrapped; and what still finds no room follows below, with the first column again.
std::string text(const Table& table, const TextStyle& look = {});

enum class Ink : std::uint8_t { plain, strong, good, notable, bad };

// The line with the codes for its ink around it, if the look has colour.
std::string inked(const std::string& line, Ink ink, const TextStyle& look);

}  // namespace reeve::reports
