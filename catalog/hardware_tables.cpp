#include "catalog/hardware_tables.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>
#include <utility>

#include "catalog/hand_tables.hpp"
#include "core/error.hpp"
#include "core/mechanics.hpp"
#include "core/routing.hpp"

namespace reeve::catalog {
namespace {

template <typename Number>
void read_if_given(const TomlNode& table, std::string_view key, Number& number) {
  if (const TomlNode* node = table.find(key)) number = node->number_from_zero();
}

void read_law_keys(const TomlNode& table, ContactLaw& law) {
  read_if_given(table, "mu", law.mu);
  read_if_given(table, "angle_rad", law.angle_rad);
  if (const TomlNode* known = table.find("known")) law.known = known->truth();
}

void read_law(const TomlNode& table, ContactLaw& law) {
  table.allow_only({"mu", "angle_rad", "known"});
  read_law_keys(table, law);
}

// A bend in degrees stands in place of the angle in radians.
template <typename Number>
void read_bend(const TomlNode& table, std::string_view bend_key, std::string_view angle_key,
               Number& angle_rad) {
  const TomlNode* bend = table.find(bend_key);
  if (bend == nullptr) return;
  if (table.find(angle_key) != nullptr) {
    bend->fail_at_key({.what = fmt::format("{} stands beside {}", bend_key, angle_key),
                       .expected = "one of them: both are the sum of the sheath's bends"});
  }
  angle_rad = bend->number_from_zero() * std::numbers::pi / 180;
}

void read_wobble(const TomlNode& sheath, ContactLaw& law) {
  read_if_given(sheath, "wobble_rad_per_m", law.wobble_rad_per_m);
  if (law.wobble_rad_per_m > 0 && !law.length_mm) {
    sheath.find("wobble_rad_per_m")
        ->fail_expected("a length_mm of the sheath beside it, on which the wobble adds up");
  }
}

void read_tube(const TomlNode& table, Hardware& hardware) { read_law(table, hardware.tube); }

void read_bearing(const TomlNode& table, Hardware& hardware) { read_law(table, hardware.bearing); }

void read_sheath(const TomlNode& table, Hardware& hardware) {
  table.allow_only({"mu", "angle_rad", "bend_deg", "length_mm", "wobble_rad_per_m", "known"});
  read_law_keys(table, hardware.sheath);
  read_bend(table, "bend_deg", "angle_rad", hardware.sheath.angle_rad);
  read_if_given(table, "length_mm", hardware.sheath.length_mm);
  read_wobble(table, hardware.sheath);
}

// Missing block parameters default to those of [bearing], so [bearing] is read first.
void read_block(const TomlNode& table, Hardware& hardware) {
  hardware.block = hardware.bearing;
  read_law(table, *hardware.block);
}

void read_lengths(const TomlNode& table, Hardware& hardware) {
  table.allow_only({"strand_mm", "motor_side_mm", "hand_mm"});
  read_if_given(table, "strand_mm", hardware.strand_mm);
  read_if_given(table, "motor_side_mm", hardware.motor_side_mm);
  read_if_given(table, "hand_mm", hardware.hand_mm);
}

// Returns the number that the key is, from 1 to `most`, or 0.
int number_of_key(const TomlNode& node, int most) {
  for (int number = 1; number <= most; ++number) {
    if (node.key == std::to_string(number)) return number;
  }
  return 0;
}

int finger_number(const TomlNode& node) {
  if (const int finger = number_of_key(node, max_fingers); finger > 0) return finger;
  node.fail_at_key({.what = "unknown table",
                    .value = node.name,
                    .expected = fmt::format("finger.1 to finger.{}", max_fingers)});
}

void read_finger(const TomlNode& node, Hardware& hardware) {
  FingerHardware finger;
  finger.finger = finger_number(node);
  node.table().allow_only({"tip_mu", "tip_angle_rad", "sheath_mu", "sheath_angle_rad",
                           "sheath_bend_deg", "strand_mm", "closing", "joints", "force_N"});
  read_if_given(node, "tip_mu", finger.tip_mu);
  read_if_given(node, "tip_angle_rad", finger.tip_angle_rad);
  read_if_given(node, "sheath_mu", finger.sheath_mu);
  read_if_given(node, "sheath_angle_rad", finger.sheath_angle_rad);
  read_bend(node, "sheath_bend_deg", "sheath_angle_rad", finger.sheath_angle_rad);
  read_if_given(node, "strand_mm", finger.strand_mm);
  read_if_given(node, "closing", finger.closing);
  finger.parts = read_finger_parts(node);
  const bool has_joints = !finger.parts.joints.empty() || !hardware.finger_parts.joints.empty();
  if (const TomlNode* closing = node.find("closing"); closing != nullptr && has_joints) {
    closing->fail_at_key({.what = "closing stands beside joints",
                          .expected = "one of them: how far fingers with "
                                      "joints close follows from these"});
  }
  hardware.fingers.push_back(finger);
  validate_at(node, hardware);
}

void read_contact(const TomlNode& node, Hardware& hardware) {
  node.table().allow_only({"mu", "angle_rad"});
  const std::size_t dash = node.key.find('-');
  if (dash == std::string::npos) {
    node.fail_at_key({.what = "contact",
                      .value = node.key,
                      .expected = "the two segments beside it, such as [contact.\"a-T1\"]"});
  }
  ContactHardware contact;
  contact.segment = node.key.substr(0, dash);
  contact.other_segment = node.key.substr(dash + 1);
  read_if_given(node, "mu", contact.mu);
  read_if_given(node, "angle_rad", contact.angle_rad);
  Hardware alone;
  alone.contacts = {contact};
  validate_at(node, alone);
  for (const ContactHardware& other : hardware.contacts) {
    if (mean_the_same(parse_contact(contact), parse_contact(other))) {
      node.fail_at_key({.what = "contact", .value = node.key, .expected = "each contact once"});
    }
  }
  hardware.contacts.push_back(contact);
}

void read_spools(const TomlNode& file, Hardware& hardware) {
  const TomlNode* node = file.find("spools");
  if (node == nullptr) return;
  Hardware alone;
  for (const TomlNode& end : node->table().children) {
    alone.spools = {{end.key, end.finite_number()}};
    validate_at(end, alone);
    hardware.spools.push_back(alone.spools.front());
  }
}

int tendon_number(const TomlNode& node) {
  constexpr int most = 2 * max_fingers;
  if (const int tendon = number_of_key(node, most); tendon > 0) return tendon;
  node.fail_at_key({.what = "unknown key",
                    .value = node.name,
                    .expected = fmt::format("EA_N, travel_mm, or a table [tendon.1] to "
                                            "[tendon.{}] with stiffness_N_mm or slack_mm",
                                            most)});
}

// The hardware says what range the number has.
void read_checked(const TomlNode& table, std::string_view key, std::optional<double>& number,
                  const Hardware& hardware) {
  const TomlNode* node = table.find(key);
  if (node == nullptr) return;
  if (!node->is_number()) node->fail_expected("a number");
  number = node->number;
  validate_at(*node, hardware);
}

void read_tendons(const TomlNode& file, Hardware& hardware) {
  const TomlNode* node = file.find("tendon");
  if (node == nullptr) return;
  TendonParts& parts = hardware.tendon;
  read_checked(node->table(), "EA_N", parts.EA_N, hardware);
  read_checked(*node, "travel_mm", parts.travel_mm, hardware);
  for (const TomlNode& own : node->children) {
    if (own.key == "EA_N" || own.key == "travel_mm") continue;
    TendonHardware& tendon = parts.own.emplace_back();
    tendon.tendon = tendon_number(own);
    own.table().allow_only({"stiffness_N_mm", "slack_mm"});
    read_checked(own, "stiffness_N_mm", tendon.stiffness_N_mm, hardware);
    read_checked(own, "slack_mm", tendon.slack_mm, hardware);
  }
}

void read_range(const TomlNode& table, std::string_view key, MuRange& range) {
  constexpr std::string_view expected =
      "two friction coefficients, the least and the greatest, such as [0.05, 0.20]";
  const TomlNode* node = table.find(key);
  if (node == nullptr) return;
  if (node->kind != TomlKind::array || node->children.size() != 2) node->fail_expected(expected);
  range = {node->children[0].number_from_zero(), node->children[1].number_from_zero()};
  if (range.low > range.high || range.high > 10) {
    node->fail_at_value({.what = node->name,
                         .value = fmt::format("[{}, {}]", range.low, range.high),
                         .expected = fmt::format("{}, at most 10", expected),
                         .form = InputForm::equals});
  }
}

// Reads a spread as a part of the value.
void read_spread(const TomlNode& table, std::string_view key, const char* what, double most,
                 double& spread) {
  read_if_given(table, key, spread);
  if (spread <= most) return;
  table.find(key)->fail_expected(
      fmt::format("{} from 0 to {}, as a part of the value", what, most));
}

void read_half_width(const TomlNode& table, std::string_view key, double& half_width) {
  read_spread(table, key, "a half-width", 1, half_width);
}

void read_deviation(const TomlNode& table, std::string_view key, double& deviation) {
  constexpr double most = 0.3;  // beyond, some exponents would be below 0
  read_spread(table, key, "a standard deviation", most, deviation);
}

UncertaintyRanges read_uncertainty(const TomlNode& file) {
  UncertaintyRanges ranges;
  const TomlNode* node = file.find("uncertainty");
  if (node == nullptr) return ranges;
  node->table().allow_only({"tube_mu", "sheath_mu", "bearing_mu_relative", "sheath_angle_relative",
                            "contact_relative", "bearing_contact_relative"});
  read_range(*node, "tube_mu", ranges.tube_mu);
  read_range(*node, "sheath_mu", ranges.sheath_mu);
  read_half_width(*node, "bearing_mu_relative", ranges.bearing_mu_relative);
  read_half_width(*node, "sheath_angle_relative", ranges.sheath_angle_relative);
  return ranges;
}

// It stands with the ranges, which say how well the hardware is known.
ContactScatter read_scatter(const TomlNode& file) {
  ContactScatter scatter;
  const TomlNode* node = file.find("uncertainty");
  if (node == nullptr) return scatter;
  read_deviation(*node, "contact_relative", scatter.relative);
  read_deviation(*node, "bearing_contact_relative", scatter.bearing_relative);
  return scatter;
}

std::string place_of(const TomlNode& node) {
  return fmt::format("{}:{}:{}", *node.file, node.key_at.line, node.key_at.column);
}

// A table of tables alone, such as the fingers, says nothing itself.
bool says_something(const TomlNode& node) {
  return std::ranges::any_of(node.children,
                             [](const TomlNode& child) { return child.kind != TomlKind::table; });
}

void add_places(const TomlNode& table, std::map<std::string, std::string>& places) {
  for (const TomlNode& node : table.children) {
    if (node.children.empty() || says_something(node)) places.emplace(node.name, place_of(node));
    add_places(node, places);
  }
}

VaryTable read_vary(const TomlNode& file) {
  VaryTable vary;
  const TomlNode* node = file.find("vary");
  if (node == nullptr) return vary;
  for (const TomlNode& entry : node->table().children) {
    if (entry.key == "equal") {
      for (const TomlNode& item : entry.items())
        vary.equal.push_back({item.text(), place_of(item) + ": vary"});
      continue;
    }
    if (entry.kind != TomlKind::array || entry.children.size() != 2) {
      entry.fail_expected("the least and the greatest, such as [3, 9]");
    }
    vary.bounds.push_back({entry.key, entry.children[0].number_from_zero(),
                           entry.children[1].number_from_zero(), place_of(entry) + ": vary"});
  }
  return vary;
}

}  // namespace

std::shared_ptr<const HardwareOrigin> origin_of(const TomlNode& file) {
  HardwareOrigin origin{*file.file, {}};
  add_places(file, origin.places);
  return std::make_shared<const HardwareOrigin>(std::move(origin));
}

void validate_at(const TomlNode& table, const Hardware& hardware) {
  try {
    const MechanicsBuilder checks_segment_names_too(hardware);
  } catch (const InputError& error) {
    table.fail_at_key(error.fault());
  }
}

std::vector<std::string_view> hardware_table_names() {
  return {"tube",   "bearing", "block",       "sheath", "lengths", "finger", "contact",
          "spools", "tendon",  "uncertainty", "hand",   "motor",   "vary"};
}

HardwareFile read_hardware_tables(const TomlNode& file) {
  HardwareFile result;
  const auto read = [&](const char* name, void (*read_table)(const TomlNode&, Hardware&)) {
    const TomlNode* node = file.find(name);
    if (node == nullptr) return;
    read_table(node->table(), result.hardware);
    validate_at(*node, result.hardware);
  };
  // The general laws first: those of a finger are checked together with them.
  read("tube", read_tube);
  read("bearing", read_bearing);
  read("block", read_block);
  read("sheath", read_sheath);
  read("lengths", read_lengths);
  read("hand", read_hand);
  if (const TomlNode* fingers = file.find("finger")) {
    for (const TomlNode& finger : fingers->table().children) read_finger(finger, result.hardware);
  }
  if (const TomlNode* contacts = file.find("contact")) {
    for (const TomlNode& contact : contacts->table().children) {
      read_contact(contact, result.hardware);
    }
  }
  read_spools(file, result.hardware);
  read_tendons(file, result.hardware);
  read("motor", read_motor);
  require_joints(file, result.hardware);
  result.uncertainty = read_uncertainty(file);
  result.hardware.scatter = read_scatter(file);
  result.vary = read_vary(file);
  return result;
}

}  // namespace reeve::catalog
