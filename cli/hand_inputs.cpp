#include "cli/hand_inputs.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "core/hand.hpp"

namespace reeve::cli {

void require_known_fingers(const Hardware& hardware, int fingers) {
  const auto known = hand(hardware);
  const int unknown = known ? first_unknown_finger(*known, fingers) : 0;
  if (unknown == 0) return;
  const char* lacking = known->finger(unknown).joints.empty() ? "joints" : "force_N";
  throw InputError(
      {.where = hardware_place(hardware, fmt::format("finger.{}", unknown)),
       .what = fmt::format("finger {} has no {}", unknown, lacking),
       .expected = fmt::format("{} in [finger.{}], or in [hand] for all fingers", lacking, unknown),
       .form = InputForm::unknown});
}

void require_hand_for(const std::string& option, const std::vector<Objective>& objectives,
                      const Hardware& hardware) {
  if (hand(hardware)) return;
  for (const Objective objective : objectives) {
    if (!row(objective).of_hand) continue;
    throw InputError({.where = option,
                      .what = fmt::format("{} needs a hand", row(objective).name),
                      .expected =
                          "the joints of its fingers, or a pull wanted of them, in the file of "
                          "--hardware or --model (docs/hand.md)",
                      .form = InputForm::unknown});
  }
}

void require_hand_for(const std::string& option, const Score& score, const Hardware& hardware) {
  std::vector<Objective> objectives;
  for (const ScoreTerm& term : score.terms) objectives.push_back(term.objective);
  require_hand_for(option, objectives, hardware);
}

}  // namespace reeve::cli
