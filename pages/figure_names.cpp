#include "pages/figure_names.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <set>

namespace reeve::pages {
namespace {

// With the grasp and the ending a name has to stay below 255 bytes; words of many fingers are long.
constexpr std::size_t longest_stem = 120;

std::string safe(const std::string& label) {
  std::string stem;
  for (const char c : label) {
    const auto byte = static_cast<unsigned char>(c);
    const bool stays = byte < 0x80 && (std::isalnum(byte) != 0 || c == '-');
    if (stays) {
      stem += c;
    } else if (stem.empty() || stem.back() != '_') {
      stem += '_';
    }
  }
  // A name that begins with '-' is taken for an option by every program that reads the file.
  if (stem.empty() || stem.front() == '-') stem.insert(stem.begin(), '_');
  if (stem.size() > longest_stem) stem.resize(longest_stem);
  return stem;
}

std::string folded(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(), [](char c) {
    return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  });
  return text;
}

}  // namespace

std::vector<std::string> file_stems(const std::vector<NamedRouting>& routings) {
  std::set<std::string> taken{"tensions", "figure-9"};  // charts with grasps in their names
  std::vector<std::string> stems;
  for (const std::string& label : labels(routings)) {
    const std::string wanted = safe(label);
    std::string stem = wanted;
    for (int number = 2; !taken.insert(folded(stem)).second; ++number) {
      stem = fmt::format("{}-{}", wanted, number);
    }
    stems.push_back(stem);
  }
  return stems;
}

std::string schematic_name(const std::string& stem, Grasp grasp) {
  return stem + "-" + grasp_id(grasp);
}

}  // namespace reeve::pages
