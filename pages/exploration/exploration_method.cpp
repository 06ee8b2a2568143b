#include <fmt/format.h>

#include "core/finger_guides.hpp"
#include "pages/exploration/exploration_words.hpp"
#include "pages/page_words.hpp"
#include "pages/shell/settings.hpp"
#include "reports/data_text.hpp"
#include "reports/exploration/part_words.hpp"
#include "reports/model_text.hpp"

namespace reeve::pages {
namespace {

std::string friction_text(const Hardware& hardware) {
  const auto law = [](const char* what, const ContactLaw& contact) {
    return fmt::format("{} μ {:.4g} over {:.4g}°", what, contact.mu,
                       in_deg(contact.whole_angle_rad()));
  };
  std::string text =
      fmt::format("Friction: {}, {}, {}{}.", law("tubes", hardware.tube),
                  law("bearings", hardware.bearing), law("sheaths", hardware.sheath),
                  hardware.block ? ", " + law("floating blocks", *hardware.block) : "");
  if (!hardware.fingers.empty() || !hardware.contacts.empty()) {
    text += fmt::format(" {} and {} have values of their own.",
                        plural(hardware.fingers.size(), "finger"),
                        plural(hardware.contacts.size(), "contact"));
  }
  return text;
}

std::string ranked_text(const ExploreOptions& options) {
  if (options.order.by_score) return ". " + order_text(options.order, options.score);
  return fmt::format(" and ranked over {}, front by front", titles(options.order.objectives));
}

}  // namespace

std::vector<std::string> explored_words(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  const GeneratorOptions& generator = options.generator;
  std::vector<std::string> text{fmt::format(
      "{} of {} of {} were generated: {}; {}; fingers {}.", report.result.generated,
      plural(report.result.total, "routing"),
      plural(static_cast<std::uint64_t>(generator.fingers), "finger"),
      reports::parts_text(generator.parts),
      generator.one_tendon ? "one tendon" : "any number of tendons",
      generator.identity == FingerIdentity::identical ? "count as alike" : "are told apart")};
  text.push_back(fmt::format("Each was judged over the grasps {} (which fingers are held){}.",
                             to_text(options.grasps), ranked_text(options)));
  text.push_back(friction_text(effective_hardware(options.model)));
  const std::string hand = hand_text(options.model.hardware);
  if (!hand.empty()) text.push_back("Hand: " + hand + ".");
  for (const DocumentLine& line : model_lines(options.model, report.result.unconverged)) {
    text.push_back(line.text);
  }
  return text;
}

std::vector<std::string> rejected_words(const ExploreReport& report) {
  const std::uint64_t without_tensions = report.result.without_tensions.count;
  std::uint64_t sum = without_tensions;
  for (const Rejection& rejection : report.result.rejected) sum += rejection.count;
  std::vector<std::string> text{fmt::format("{} of {} were rejected; {} are left and ranked.", sum,
                                            plural(report.result.generated, "generated routing"),
                                            ranked_designs(report))};
  for (const Rejection& rejection : report.result.rejected) {
    text.push_back(
        fmt::format("{}: {}{}.", rejection.count, rejection_text(rejection, report.options),
                    rejection.constraint ? " not met" : "; one of the tendons hangs on no motor"));
  }
  if (without_tensions > 0) {
    text.push_back(fmt::format("{}: no tensions in one of the grasps.", without_tensions));
  }
  return text;
}

}  // namespace reeve::pages
