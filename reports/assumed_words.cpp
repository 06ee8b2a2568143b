#include "reports/assumed_words.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>

#include "reports/data_text.hpp"

namespace reeve::reports {
namespace {

constexpr double degrees_in_rad = 180 / std::numbers::pi;
// No tendon is wound so often round a part of a hand, and 30 deg taken for radians are as many.
constexpr double doubtful_turns = 4;

std::string contact_words(const char* parts, const ContactLaw& law) {
  return fmt::format("{} mu {:.4g} over {:.4g} deg", parts, law.mu,
                     law.whole_angle_rad() * degrees_in_rad);
}

std::string own_values_words(const Hardware& hardware) {
  std::string owners;
  const auto add = [&](std::size_t count, const char* one) {
    if (count > 0) owners += (owners.empty() ? ", " : " and ") + plural(count, one);
  };
  add(hardware.fingers.size(), "finger");
  add(hardware.contacts.size(), "contact");
  return owners.empty() ? "" : owners + " with own values where a routing has them";
}

// Returns the hardware's file without its folder, or the mechanism of the catalogue that has it.
std::string owner_words(const Hardware& hardware) {
  if (!hardware.origin) return "default";
  return std::filesystem::path(hardware.origin->file).filename().string();
}

std::string friction_words(const Hardware& hardware) {
  std::string text = fmt::format("{}, {}, {}", contact_words("tubes", hardware.tube),
                                 contact_words("bearings", hardware.bearing),
                                 contact_words("sheaths", hardware.sheath));
  if (hardware.block) text += ", " + contact_words("blocks", *hardware.block);
  return text + own_values_words(hardware);
}

void question(const std::string& where, double angle_rad, std::vector<std::string>& notes) {
  const double turns = angle_rad / (2 * std::numbers::pi);
  if (turns <= doubtful_turns) return;
  notes.push_back(
      fmt::format("the angle of {} is {:.4g} rad, {:.3g} turns: are degrees meant? {:.4g} deg are "
                  "{:.4g} rad",
                  where, angle_rad, turns, angle_rad, angle_rad / degrees_in_rad));
}

}  // namespace

std::string assumed_text(const Model& model) {
  const char* const law =
      model.effects.empty() ? "only capstan friction" : "capstan friction with effects";
  return fmt::format("Assumed, by {}: {}; {}", owner_words(model.hardware),
                     friction_words(effective_hardware(model)), law);
}

std::vector<std::string> angle_notes(const Hardware& hardware) {
  std::vector<std::string> notes;
  question("the tubes", hardware.tube.angle_rad, notes);
  question("the bearings", hardware.bearing.angle_rad, notes);
  question("the sheaths", hardware.sheath.angle_rad, notes);
  if (hardware.block) question("the blocks", hardware.block->angle_rad, notes);
  for (const FingerHardware& finger : hardware.fingers) {
    const std::string name = fmt::format("finger {}", finger.finger);
    question("the tip of " + name, finger.tip_angle_rad.value_or(0), notes);
    question("the sheaths of " + name, finger.sheath_angle_rad.value_or(0), notes);
  }
  for (const ContactHardware& contact : hardware.contacts) {
    question("contact " + name_of(contact), contact.angle_rad.value_or(0), notes);
  }
  return notes;
}

}  // namespace reeve::reports
