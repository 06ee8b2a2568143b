#include "cli/choice.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <utility>

#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::cli {

CLI::Validator one_of(std::vector<std::string> names) {
  const std::string set = fmt::format("{{{}}}", fmt::join(names, ","));
  return CLI::Validator(
      [names = std::move(names), set](const std::string& text) {
        if (std::ranges::find(names, text) != names.end()) return std::string();
        return fmt::format("{} not in {}{}", text, set, core::did_you_mean(text, names));
      },
      set);
}

CLI::Validator number_from(double low, double high) {
  return CLI::Validator(
      [=](const std::string& text) {
        const auto number = number_in(text);
        if (number && *number >= low && *number <= high) return std::string();
        return fmt::format("Value '{}': expected a number from {} to {}", text, low, high);
      },
      "");
}

}  // namespace reeve::cli
