#include "cli/progress_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace reeve::cli {
namespace {

constexpr std::size_t least_bar = 10;
constexpr std::size_t most_bar = 40;

std::string bar(double share, std::size_t cells) {
  const auto full = static_cast<std::size_t>(std::floor(share * static_cast<double>(cells)));
  std::string text(std::min(full, cells), '=');
  if (text.size() < cells) text += '>';
  text.resize(cells, ' ');
  return "[" + text + "]";
}

}  // namespace

std::string progress_bar(const std::string& what, const Progress& progress, double seconds,
                         std::size_t width) {
  const double share = static_cast<double>(progress.done) / static_cast<double>(progress.total);
  const double rate = static_cast<double>(progress.done - progress.before) / seconds;
  const double left = static_cast<double>(progress.total - progress.done) / rate;
  const std::string figures =
      fmt::format("{:3.0f} %, {:.0f} a second, {:.0f} s left", 100 * share, rate, left);
  constexpr std::size_t around_bar = 4;  // brackets and spaces
  const std::size_t used = what.size() + around_bar + figures.size();
  if (used + least_bar > width) return (what + " " + figures).substr(0, width);
  return what + " " + bar(share, std::min(width - used, most_bar)) + " " + figures;
}

}  // namespace reeve::cli
