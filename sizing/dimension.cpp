#include "sizing/dimension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/routing.hpp"
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

constexpr Interval angles{0, 1000};
constexpr Interval lengths{1e-3, 1e6};
constexpr Interval weights{1e-3, 1e3};
constexpr Interval arms{0.01, 1000};

constexpr std::array quantities{
    QuantityRow{SizedQuantity::sheath_angle, "sheath_angle", "sheaths", "rad", QuantityOf::finger,
                angles},
    QuantityRow{SizedQuantity::tip_angle, "tip_angle", "tips", "rad", QuantityOf::finger, angles},
    QuantityRow{SizedQuantity::strand_mm, "strand_mm", "strands", "mm", QuantityOf::finger,
                lengths},
    QuantityRow{SizedQuantity::closing, "closing", "", "", QuantityOf::finger, weights},
    QuantityRow{SizedQuantity::arm_mm, "arm_mm", "arms", "mm", QuantityOf::finger, arms},
    QuantityRow{SizedQuantity::contact_angle, "contact_angle", "", "rad", QuantityOf::contact,
                angles},
    QuantityRow{SizedQuantity::motor_side_mm, "motor_side_mm", "", "mm", QuantityOf::hand, lengths},
    QuantityRow{SizedQuantity::hand_mm, "hand_mm", "", "mm", QuantityOf::hand, lengths},
};

std::string quantity_names() {
  std::string list;
  for (const QuantityRow& row : quantities) {
    list += (list.empty() ? "" : ", ") + std::string(row.name) +
            (row.of == QuantityOf::finger    ? "[1]"
             : row.of == QuantityOf::contact ? "[T2-T3]"
                                             : "");
  }
  return list;
}

[[noreturn]] void fail(const std::string& text, const std::string& expected) {
  throw InputError({.what = "dimension", .value = text, .expected = expected});
}

SizedDimension of_finger(const QuantityRow& row, const std::string& text,
                         const std::string& whole) {
  const auto finger = whole_number_in(text);
  if (!finger || *finger < 1 || *finger > max_fingers) {
    fail(whole, fmt::format("numbers of fingers from 1 to {}, such as {}[1] or {}[2,3]",
                            max_fingers, row.name, row.name));
  }
  return {row.quantity, *finger, {}, {}};
}

SizedDimension of_contact(const QuantityRow& row, const std::string& text,
                          const std::string& whole) {
  const std::optional<ContactName> contact = contact_named(text);
  if (!contact) fail(whole, "the two segments beside a contact, such as contact_angle[T2-T3]");
  return {row.quantity, 0, contact->from, contact->to};
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

std::vector<EqualGroup> parse_equal(const std::string& text) {
  const std::string option = fmt::format("equal '{}'", text);
  std::vector<EqualGroup> groups;
  for (const std::string& item : items_in(text)) {
    try {
      groups.push_back({name_in_group(std::string(trimmed(item))), option});
    } catch (const InputError& error) {
      throw InputError({.what = "equal",
                        .value = text,
                        .expected = "tips, sheaths, strands, or dimensions of one quantity such as "
                                    "sheath_angle[2,3,4]"});
    }
  }
  return groups;
}

std::span<const QuantityRow> quantity_table() { return quantities; }

const QuantityRow& row(SizedQuantity quantity) {
  return quantities[static_cast<std::size_t>(quantity)];
}

bool operator==(const SizedDimension& a, const SizedDimension& b) {
  return a.quantity == b.quantity && a.finger == b.finger && a.contact() == b.contact();
}

bool mean_the_same(const SizedDimension& a, const SizedDimension& b) {
  return a.quantity == b.quantity && a.finger == b.finger &&
         core::mean_the_same(a.contact(), b.contact());
}

std::string to_text(const SizedDimension& dimension) {
  const QuantityRow& about = row(dimension.quantity);
  switch (about.of) {
    case QuantityOf::finger:
      return fmt::format("{}[{}]", about.name, dimension.finger);
    case QuantityOf::contact:
      return fmt::format("{}[{}]", about.name, to_text(dimension.contact()));
    case QuantityOf::hand:
      break;
  }
  return about.name;
}

std::string to_text(const DimensionName& name) {
  std::string subjects;
  for (const SizedDimension& one : name.named) {
    subjects += (subjects.empty() ? "" : ",") +
                (one.finger > 0 ? std::to_string(one.finger) : to_text(one.contact()));
  }
  return subjects.empty() ? row(name.quantity).name
                          : fmt::format("{}[{}]", row(name.quantity).name, subjects);
}

bool DimensionName::has(const SizedDimension& dimension) const {
  return std::ranges::any_of(
      named, [&](const SizedDimension& one) { return mean_the_same(one, dimension); });
}

DimensionName parse_dimensions(const std::string& text) {
  const std::size_t bracket = std::min(text.find('['), text.size());
  const std::string name(trimmed(text.substr(0, bracket)));
  const auto about = std::ranges::find(quantities, name, &QuantityRow::name);
  const bool closed = bracket == text.size() || text.back() == ']';
  if (about == quantities.end() || !closed) {
    std::vector<std::string> names;
    for (const QuantityRow& row : quantities) names.emplace_back(row.name);
    fail(text, fmt::format("one of {}{}", quantity_names(), did_you_mean(name, names)));
  }
  DimensionName result{about->quantity, {}};
  if (bracket == text.size()) {
    if (about->of == QuantityOf::contact) fail(text, "a contact, such as contact_angle[T2-T3]");
    return result;
  }
  if (about->of == QuantityOf::hand) fail(text, fmt::format("{} alone", about->name));
  for (const std::string& item :
       comma_separated(text.substr(bracket + 1, text.size() - bracket - 2))) {
    const std::string subject(trimmed(item));
    const SizedDimension dimension = about->of == QuantityOf::finger
                                         ? of_finger(*about, subject, text)
                                         : of_contact(*about, subject, text);
    if (result.has(dimension)) fail(text, "each of them once");
    result.named.push_back(dimension);
  }
  return result;
}

}  // namespace reeve::sizing
