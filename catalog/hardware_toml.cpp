#include <fmt/format.h>

#include <optional>

#include "catalog/hand_tables.hpp"
#include "catalog/hardware_tables.hpp"

namespace reeve::catalog {
namespace {

// fmt's shortest form reads back as the same number.
std::string line(std::string_view key, double value) {
  return fmt::format("{} = {}\n", key, value);
}

std::string line(std::string_view key, const std::optional<double>& value) {
  return value ? line(key, *value) : "";
}

std::string line(std::string_view key, const MuRange& range) {
  return fmt::format("{} = [{}, {}]\n", key, range.low, range.high);
}

std::string table(std::string_view name, const ContactLaw& law) {
  return fmt::format("[{}]\n", name) + line("mu", law.mu) + line("angle_rad", law.angle_rad) +
         line("length_mm", law.length_mm) +
         (law.wobble_rad_per_m > 0 ? line("wobble_rad_per_m", law.wobble_rad_per_m) : "") +
         (law.known ? "known = true\n" : "") + "\n";
}

std::string table(const FingerHardware& finger) {
  return fmt::format("[finger.{}]\n", finger.finger) + line("tip_mu", finger.tip_mu) +
         line("tip_angle_rad", finger.tip_angle_rad) + line("sheath_mu", finger.sheath_mu) +
         line("sheath_angle_rad", finger.sheath_angle_rad) + line("strand_mm", finger.strand_mm) +
         line("closing", finger.closing) + finger_parts_toml(finger.parts) + "\n";
}

std::string table(const ContactHardware& contact) {
  return fmt::format("[contact.\"{}-{}\"]\n", contact.segment, contact.other_segment) +
         line("mu", contact.mu) + line("angle_rad", contact.angle_rad) + "\n";
}

std::string table(const TendonParts& parts) {
  if (parts == TendonParts{}) return "";
  std::string text = "[tendon]\n" + line("EA_N", parts.EA_N) + line("travel_mm", parts.travel_mm);
  for (const TendonHardware& own : parts.own) {
    text += fmt::format("\n[tendon.{}]\n", own.tendon) +
            line("stiffness_N_mm", own.stiffness_N_mm) + line("slack_mm", own.slack_mm);
  }
  return text + "\n";
}

std::string table(const VaryTable& vary) {
  if (vary.bounds.empty() && vary.equal.empty()) return "";
  std::string text = "\n[vary]\n";
  for (const GivenBounds& bounds : vary.bounds) {
    text += fmt::format("\"{}\" = [{}, {}]\n", bounds.name, bounds.low, bounds.high);
  }
  if (vary.equal.empty()) return text;
  std::string list;
  for (const GivenEqual& equal : vary.equal) {
    list += fmt::format("{}\"{}\"", list.empty() ? "" : ", ", equal.text);
  }
  return text + fmt::format("equal = [{}]\n", list);
}

}  // namespace

std::string hardware_toml(const Hardware& hardware, const UncertaintyRanges& uncertainty,
                          const VaryTable& vary) {
  std::string text = table("tube", hardware.tube) + table("bearing", hardware.bearing);
  if (hardware.block) text += table("block", *hardware.block);
  text += table("sheath", hardware.sheath);
  text += "[lengths]\n" + line("strand_mm", hardware.strand_mm) +
          line("motor_side_mm", hardware.motor_side_mm) + line("hand_mm", hardware.hand_mm) + "\n";
  text += hand_toml(hardware);
  for (const FingerHardware& finger : hardware.fingers) text += table(finger);
  for (const ContactHardware& contact : hardware.contacts) text += table(contact);
  if (!hardware.spools.empty()) {
    text += "[spools]\n";
    for (const SpoolHardware& spool : hardware.spools) text += line(spool.segment, spool.ratio);
    text += "\n";
  }
  text += table(hardware.tendon);
  return text + "[uncertainty]\n" + line("tube_mu", uncertainty.tube_mu) +
         line("sheath_mu", uncertainty.sheath_mu) +
         line("bearing_mu_relative", uncertainty.bearing_mu_relative) +
         line("sheath_angle_relative", uncertainty.sheath_angle_relative) +
         line("contact_relative", hardware.scatter.relative) +
         line("bearing_contact_relative", hardware.scatter.bearing_relative) + table(vary);
}

}  // namespace reeve::catalog
