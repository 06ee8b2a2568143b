// Reads a chart's SVG as a person does: marks against the numbers at the ticks. So a test sees what
// a reader sees, whatever the program thought it drew.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace reeve::testing {

struct ReadMark {
  double x = 0;  // px; of a rectangle the middle
  double y = 0;  // px; of a rectangle the top
  double bottom = 0;
  std::string title;
};

// The marks of a layer.
struct ReadGroup {
  std::string kind;        // "points", "bars", …
  std::string series;      // "" if it has no name
  std::string attributes;  // of the group
  std::vector<ReadMark> marks;
};

struct ReadTick {
  double at = 0;  // px
  std::string text;
};

struct ReadPanel {
  std::vector<ReadGroup> groups;
  std::vector<ReadTick> x;
  std::vector<ReadTick> y;
  std::vector<std::string> texts;
  double top = 0;  // of the frame
  double bottom = 0;

  // By the numbers at the two ticks that lie farthest apart, "50 %" being 0.5.
  double x_of(const ReadMark& mark) const;
  double y_of(const ReadMark& mark) const;
  // The category at whose tick it lies.
  std::string category_of(const ReadMark& mark) const;
  std::vector<ReadMark> marks(const std::string& kind, const std::string& series = "") const;
};

// The panels of a chart, in their order. Where panels share the y axis, each has its ticks.
std::vector<ReadPanel> read_chart(const std::string& svg);

}  // namespace reeve::testing
