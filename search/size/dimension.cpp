#include "search/size/dimension.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "core/hand/hand.hpp"
#include "core/mechanics.hpp"
#include "core/routing.hpp"
#include "core/text.hpp"

namespace reeve::search {
namespace {

constexpr Interval angles{0, 1000};
constexpr Interval lengths{1e-3, 1e6};
constexpr Interval weights{1e-3, 1e3};
constexpr Interval arms{0.01, 1000};

constexpr std::array quantities{
    QuantityRow{Quantity::sheath_angle, "sheath_angle", "sheaths", "rad", QuantityOf::finger,
                angles},
    QuantityRow{Quantity::tip_angle, "tip_angle", "tips", "rad", QuantityOf::finger, angles},
    QuantityRow{Quantity::strand_mm, "strand_mm", "strands", "mm", QuantityOf::finger, lengths},
    QuantityRow{Quantity::closing, "closing", "", "", QuantityOf::finger, weights},
    QuantityRow{Quantity::arm_mm, "arm_mm", "arms", "mm", QuantityOf::finger, arms},
    QuantityRow{Quantity::contact_angle, "contact_angle", "", "rad", QuantityOf::contact, angles},
    QuantityRow{Quantity::motor_side_mm, "motor_side_mm", "", "mm", QuantityOf::hand, lengths},
    QuantityRow{Quantity::hand_mm, "hand_mm", "", "mm", QuantityOf::hand, lengths},
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
  int finger = 0;
  const char* last = text.data() + text.size();
  const auto [end, error] = std::from_chars(text.data(), last, finger);
  if (error != std::errc{} || end != last || finger < 1 || finger > max_fingers) {
    fail(whole, fmt::format("numbers of fingers from 1 to {}, such as {}[1] or {}[2,3]",
                            max_fingers, row.name, row.name));
  }
  return {row.quantity, finger, {}, {}};
}

Dimension of_contact(const QuantityRow& row, const std::string& text, const std::string& whole) {
  const std::size_t dash = std::min(text.find('-'), text.size());
  const std::optional<Segment> from = segment_named(text.substr(0, dash));
  const std::optional<Segment> to = segment_named(dash == text.size() ? "" : text.substr(dash + 1));
  if (!from || !to) fail(whole, "the two segments beside a contact, such as contact_angle[T2-T3]");
  return {row.quantity, 0, *from, *to};
}

bool is_between(const Dimension& dimension, const Segment& left, const Segment& right) {
  return (dimension.from == left && dimension.to == right) ||
         (dimension.from == right && dimension.to == left);
}

bool has_own_angle(const Hardware& hardware, const Segment& left, const Segment& right) {
  return std::any_of(
      hardware.contacts.begin(), hardware.contacts.end(), [&](const ContactHardware& contact) {
        return contact.angle_rad &&
               is_between(
                   {{}, 0, parse_segment(contact.segment), parse_segment(contact.other_segment)},
                   left, right);
      });
}

// Calls `visit` with each contact, the segments beside it, and its law.
template <typename Visit>
void for_each_contact(const Network& network, const Hardware& hardware, Visit visit) {
  const MechanicsBuilder builder(hardware);
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      const auto [left, right] = ends_of(tendon, k);
      visit(network.contacts[tendon.first_contact + k], network.segments[left],
            network.segments[right], builder.law_at(network, tendon, k));
    }
  }
}

void sort_by_finger(std::vector<PlacedDimension>& found) {
  std::stable_sort(found.begin(), found.end(),
                   [](const PlacedDimension& a, const PlacedDimension& b) {
                     return (a.dimension.finger == 0 ? max_fingers + 1 : a.dimension.finger) <
                            (b.dimension.finger == 0 ? max_fingers + 1 : b.dimension.finger);
                   });
}

std::vector<PlacedDimension> angles_of_fingers(const Network& network, const Hardware& hardware,
                                               Quantity quantity) {
  const bool sheaths = quantity == Quantity::sheath_angle;
  const ContactPlace place = sheaths ? ContactPlace::sheath : ContactPlace::tip;
  std::vector<PlacedDimension> found;
  for_each_contact(
      network, hardware,
      [&](const Contact& contact, const Segment& left, const Segment& right,
          const ContactLaw& law) {
        if (contact.place != place) return;
        PlacedDimension here{{quantity, contact.finger, {}, {}}, law.angle_rad, sheaths};
        if (contact.finger == 0) {
          here.dimension = {Quantity::contact_angle, 0, left, right};
        } else if (has_own_angle(hardware, left, right)) {
          return;
        }
        for (const PlacedDimension& other : found) {
          if (other.dimension == here.dimension) return;
        }
        found.push_back(here);
      });
  sort_by_finger(found);
  return found;
}

std::vector<PlacedDimension> angles_of_contacts(const Network& network, const Hardware& hardware) {
  std::vector<PlacedDimension> found;
  for_each_contact(network, hardware,
                   [&](const Contact& contact, const Segment& left, const Segment& right,
                       const ContactLaw& law) {
                     if (contact.kind == ContactKind::bar) return;
                     found.push_back({{Quantity::contact_angle, 0, left, right},
                                      law.angle_rad,
                                      contact.kind == ContactKind::sheath});
                   });
  return found;
}

const FingerHardware* find_finger(const Hardware& hardware, int finger) {
  for (const FingerHardware& here : hardware.fingers) {
    if (here.finger == finger) return &here;
  }
  return nullptr;
}

std::vector<PlacedDimension> arms_of_fingers(const Network& network, const Hardware& hardware) {
  std::vector<PlacedDimension> found;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    const FingerParts parts = finger_parts(hardware, finger);
    if (parts.joints.empty()) continue;
    found.push_back({{Quantity::arm_mm, finger, {}, {}}, parts.joints.front().arm_mm, false});
  }
  return found;
}

std::vector<PlacedDimension> numbers_of_fingers(const Network& network, const Hardware& hardware,
                                                Quantity quantity) {
  std::vector<PlacedDimension> found;
  if (quantity == Quantity::closing && hand(hardware)) return found;
  for (int finger = 1; finger <= network.fingers; ++finger) {
    const FingerHardware* own = find_finger(hardware, finger);
    const double nominal = quantity == Quantity::closing ? (own != nullptr ? own->closing : 1)
                           : own != nullptr ? own->strand_mm.value_or(hardware.strand_mm)
                                            : hardware.strand_mm;
    found.push_back({{quantity, finger, {}, {}}, nominal, false});
  }
  return found;
}

std::vector<PlacedDimension> lengths_of_hand(const Network& network, const Hardware& hardware,
                                             Quantity quantity) {
  const bool motor = quantity == Quantity::motor_side_mm;
  const SegmentKind kind = motor ? SegmentKind::motor_side : SegmentKind::hand;
  const bool there = std::any_of(network.segments.begin(), network.segments.end(),
                                 [&](const Segment& segment) { return segment.kind == kind; });
  if (!there) return {};
  return {{{quantity, 0, {}, {}}, motor ? hardware.motor_side_mm : hardware.hand_mm, false}};
}

FingerHardware& finger_of(Hardware& hardware, int finger) {
  for (FingerHardware& here : hardware.fingers) {
    if (here.finger == finger) return here;
  }
  // In the order of the fingers, for who reads the file.
  const auto place = std::find_if(hardware.fingers.begin(), hardware.fingers.end(),
                                  [&](const FingerHardware& here) { return here.finger > finger; });
  FingerHardware& added = *hardware.fingers.emplace(place);
  added.finger = finger;
  return added;
}

ContactHardware& contact_of(Hardware& hardware, const Dimension& dimension) {
  for (ContactHardware& here : hardware.contacts) {
    if (is_between(dimension, parse_segment(here.segment), parse_segment(here.other_segment))) {
      return here;
    }
  }
  hardware.contacts.push_back(
      {segment_name(dimension.from), segment_name(dimension.to), std::nullopt, std::nullopt});
  return hardware.contacts.back();
}

void set_arm(Hardware& hardware, int finger, double value) {
  std::vector<FingerJoint> joints = finger_parts(hardware, finger).joints;
  const double factor = value / joints.front().arm_mm;
  for (FingerJoint& joint : joints) joint.arm_mm *= factor;
  finger_of(hardware, finger).parts.joints = std::move(joints);
}

}  // namespace

std::span<const QuantityRow> quantity_table() { return quantities; }

const QuantityRow& row(Quantity quantity) { return quantities[static_cast<std::size_t>(quantity)]; }

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

std::vector<PlacedDimension> dimensions_of(const Network& network, const Hardware& hardware,
                                           Quantity quantity) {
  switch (quantity) {
    case Quantity::sheath_angle:
    case Quantity::tip_angle:
      return angles_of_fingers(network, hardware, quantity);
    case Quantity::contact_angle:
      return angles_of_contacts(network, hardware);
    case Quantity::strand_mm:
    case Quantity::closing:
      return numbers_of_fingers(network, hardware, quantity);
    case Quantity::arm_mm:
      return arms_of_fingers(network, hardware);
    case Quantity::motor_side_mm:
    case Quantity::hand_mm:
      return lengths_of_hand(network, hardware, quantity);
  }
  return {};
}

void set(Hardware& hardware, const Dimension& dimension, double value) {
  switch (dimension.quantity) {
    case Quantity::sheath_angle:
      finger_of(hardware, dimension.finger).sheath_angle_rad = value;
      break;
    case Quantity::tip_angle:
      finger_of(hardware, dimension.finger).tip_angle_rad = value;
      break;
    case Quantity::strand_mm:
      finger_of(hardware, dimension.finger).strand_mm = value;
      break;
    case Quantity::closing:
      finger_of(hardware, dimension.finger).closing = value;
      break;
    case Quantity::arm_mm:
      set_arm(hardware, dimension.finger, value);
      break;
    case Quantity::contact_angle:
      contact_of(hardware, dimension).angle_rad = value;
      break;
    case Quantity::motor_side_mm:
      hardware.motor_side_mm = value;
      break;
    case Quantity::hand_mm:
      hardware.hand_mm = value;
      break;
  }
}

}  // namespace reeve::search
