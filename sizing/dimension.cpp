#include "sizing/dimension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "core/error.hpp"
#include "core/routing.hpp"
#include "core/text.hpp"

namespace reeve::sizing {
namespace {

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

Dimension of_finger(const QuantityRow& row, const std::string& text, const std::string& whole) {
  const auto finger = whole_number_in(text);
  if (!finger || *finger < 1 || *finger > max_fingers) {
    fail(whole, fmt::format("numbers of fingers from 1 to {}, such as {}[1] or {}[2,3]",
                            max_fingers, row.name, row.name));
  }
  return {row.quantity, *finger, {}, {}};
}

Dimension of_contact(const QuantityRow& row, const std::string& text, const std::string& whole) {
  const std::size_t dash = std::min(text.find('-'), text.size());
  const std::optional<Segment> from = segment_named(text.substr(0, dash));
  const std::optional<Segment> to = segment_named(dash == text.size() ? "" : text.substr(dash + 1));
  if (!from || !to) fail(whole, "the two segments beside a contact, such as contact_angle[T2-T3]");
  return {row.quantity, 0, *from, *to};
}

}  // namespace

bool is_between(const Dimension& dimension, const Segment& left, const Segment& right) {
  return (dimension.from == left && dimension.to == right) ||
         (dimension.from == right && dimension.to == left);
}

std::span<const QuantityRow> quantity_table() { return quantities; }

const QuantityRow& row(SizedQuantity quantity) {
  return quantities[static_cast<std::size_t>(quantity)];
}

bool operator==(const Dimension& a, const Dimension& b) {
  return a.quantity == b.quantity && a.finger == b.finger &&
         (row(a.quantity).of != QuantityOf::contact || is_between(a, b.from, b.to));
}

std::string to_text(const Dimension& dimension) {
  const QuantityRow& about = row(dimension.quantity);
  switch (about.of) {
    case QuantityOf::finger:
      return fmt::format("{}[{}]", about.name, dimension.finger);
    case QuantityOf::contact:
      return fmt::format("{}[{}-{}]", about.name, segment_name(dimension.from),
                         segment_name(dimension.to));
    case QuantityOf::hand:
      break;
  }
  return about.name;
}

std::string to_text(const DimensionName& name) {
  std::string subjects;
  for (const Dimension& one : name.named) {
    subjects +=
        (subjects.empty() ? "" : ",") +
        (one.finger > 0 ? std::to_string(one.finger)
                        : fmt::format("{}-{}", segment_name(one.from), segment_name(one.to)));
  }
  return subjects.empty() ? row(name.quantity).name
                          : fmt::format("{}[{}]", row(name.quantity).name, subjects);
}

bool DimensionName::has(const Dimension& dimension) const {
  return std::find(named.begin(), named.end(), dimension) != named.end();
}

DimensionName parse_dimensions(const std::string& text) {
  const std::size_t bracket = std::min(text.find('['), text.size());
  const std::string name(trimmed(text.substr(0, bracket)));
  const auto about = std::find_if(quantities.begin(), quantities.end(),
                                  [&](const QuantityRow& row) { return row.name == name; });
  const bool closed = bracket == text.size() || text.back() == ']';
  if (about == quantities.end() || !closed) fail(text, "one of " + quantity_names());
  DimensionName result{about->quantity, {}};
  if (bracket == text.size()) {
    if (about->of == QuantityOf::contact) fail(text, "a contact, such as contact_angle[T2-T3]");
    return result;
  }
  if (about->of == QuantityOf::hand) fail(text, fmt::format("{} alone", about->name));
  for (const std::string& item :
       comma_separated(text.substr(bracket + 1, text.size() - bracket - 2))) {
    const std::string subject(trimmed(item));
    const Dimension dimension = about->of == QuantityOf::finger ? of_finger(*about, subject, text)
                                                                : of_contact(*about, subject, text);
    if (result.has(dimension)) fail(text, "each of them once");
    result.named.push_back(dimension);
  }
  return result;
}

}  // namespace reeve::sizing
