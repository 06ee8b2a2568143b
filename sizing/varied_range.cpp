#include "sizing/varied_range.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::sizing {
namespace {

// Between commas that stand in no bracket.
std::vector<std::string> items_in(const std::string& text) {
  std::vector<std::string> items{""};
  int depth = 0;
  for (const char c : text) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (c == ',' && depth == 0) {
      items.emplace_back();
    } else {
      items.back() += c;
    }
  }
  return items;
}

DimensionName name_in_group(const std::string& item) {
  for (const QuantityRow& row : quantity_table()) {
    if (*row.plural != '\0' && item == row.plural) return {row.quantity, {}};
  }
  return parse_dimensions(item);
}

}  // namespace

VariedRange varied_range(const std::string& name, const Interval& bounds, const std::string& text) {
  VariedRange range{{}, bounds, text};
  try {
    range.name = parse_dimensions(name);
  } catch (const InputError& error) {
    throw error.at(text);
  }
  const QuantityRow& about = row(range.name.quantity);
  if (bounds.low == bounds.high) {
    throw InputError({.where = text,
                      .what = fmt::format("{} has no room between {} and {}", about.name,
                                          bounds.low, bounds.high),
                      .expected = "a least and a greater value; what is to stay as it is stands in "
                                  "the hardware file, and is not varied",
                      .form = InputForm::unknown});
  }
  if (bounds.low <= bounds.high && bounds.low >= about.possible.low &&
      bounds.high <= about.possible.high) {
    return range;
  }
  throw InputError(
      {.where = text,
       .what = about.name,
       .value = fmt::format("{}..{}", bounds.low, bounds.high),
       .expected = fmt::format("the least and the greatest, from {} to {}{}{}", about.possible.low,
                               about.possible.high, *about.unit == '\0' ? "" : " ", about.unit),
       .form = InputForm::equals});
}

VariedRange parse_varied(const std::string& text) {
  const std::string option = fmt::format("vary '{}'", text);
  const std::size_t equals = text.find('=');
  const std::size_t dots = text.find("..", equals == std::string::npos ? 0 : equals);
  if (equals != std::string::npos && dots != std::string::npos) {
    const auto low =
        number_in(trimmed(std::string_view(text).substr(equals + 1, dots - equals - 1)));
    const auto high = number_in(trimmed(std::string_view(text).substr(dots + 2)));
    if (low && high) return varied_range(text.substr(0, equals), {*low, *high}, option);
  }
  throw InputError({.what = "vary",
                    .value = text,
                    .expected = "a dimension and its bounds, such as sheath_angle[1]=3..9"});
}

std::vector<SameGroup> parse_same(const std::string& text) {
  const std::string option = fmt::format("same '{}'", text);
  std::vector<SameGroup> groups;
  for (const std::string& item : items_in(text)) {
    try {
      groups.push_back({name_in_group(std::string(trimmed(item))), option});
    } catch (const InputError& error) {
      throw InputError({.what = "same",
                        .value = text,
                        .expected = "tips, sheaths, strands, or dimensions of one quantity such as "
                                    "sheath_angle[2,3,4]"});
    }
  }
  return groups;
}

}  // namespace reeve::sizing
