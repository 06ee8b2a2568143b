#include "reports/mujoco/mjcf.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/mechanics.hpp"
#include "core/motor_sides.hpp"
#include "core/notation.hpp"
#include "core/version.hpp"
#include "reports/jam_words.hpp"
#include "reports/model_text.hpp"
#include "reports/mujoco/mjcf_rig.hpp"

namespace reeve::reports {
namespace {

constexpr double default_pull_N = 10;
// MuJoCo's constraints give way in proportion to 1 − the first two numbers of `hard`: a tendon
// under load should keep its length to some micrometres.
constexpr const char* quick = "0.004 1";
constexpr const char* hard = "0.9999 0.9999 0.001";

void require_no_slack(const Hardware& hardware) {
  for (const TendonHardware& own : hardware.tendon.own) {
    if (!own.slack_mm) continue;
    const std::string key = fmt::format("tendon.{}.slack_mm", own.tendon);
    throw InputError({.where = hardware_place(hardware, key),
                      .what = key,
                      .value = fmt::format("{}", *own.slack_mm),
                      .expected = "none in an export to MuJoCo, whose tendons are always taut",
                      .form = InputForm::equals});
  }
}

bool has_joints(const MjcfRig& rig) {
  return !rig.layout.fingers.empty() && !rig.layout.fingers.front().joints.empty();
}

// No comment of XML holds two hyphens, and none of ours a line that somebody else's name begins.
std::string in_comment(const std::string& name) {
  std::string text;
  for (const char c : name) {
    if (c == '-' && text.ends_with('-')) text += ' ';
    text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  return text;
}

std::string title(const std::string& word, const MjcfOrigin& origin) {
  return origin.name.empty() ? word : fmt::format("{} ({})", in_comment(origin.name), word);
}

std::string hardware_line(const MjcfOrigin& origin) {
  return origin.hardware.empty() ? "" : fmt::format("Hardware: {}.\n", in_comment(origin.hardware));
}

std::string trees_lines(const Network& network) {
  if (carriage_count(network) > 1) {
    return "Each motor pulls with the same force; reeve's own figures have the carriages travel as a\n"
           "grasp says, by default alike.\n";
  }
  if (tree_count(network) < 2) return "";
  return "Several trees of tendons hang on the carriage: here they share its pull as the springs of\n"
         "their fingers ask; reeve's own figures have them take up alike.\n";
}

std::string absent_lines(const Hardware& hardware, const Network& network) {
  std::string lines;
  for (const std::string& note : model_notes({hardware, {}, {}}, std::vector{network})) {
    lines += "Note: " + note + ".\n";
  }
  return lines;
}

std::string explanation(const std::string& word, const MjcfRig& rig, const Hardware& hardware,
                        const MjcfOrigin& origin) {
  return fmt::format(
      " The routing {} without friction, by reeve {}.\n"
      "{}{}"
      "Metres, kilograms, newtons, radians.\n"
      "MuJoCo's tendons have no capstan friction: the friction exponents of the contacts stand below\n"
      "as data (contact_..., friction_exponents) that nothing acts on, and the tensions are those of\n"
      "a routing whose contacts do not rub.\n"
      "{}\n"
      "{}"
      "Masses and damping are not the hardware's: they bring the rig to rest.\n"
      "Activate the constraints hold_... to hold a finger. ",
      title(word, origin), version().number, hardware_line(origin),
      absent_lines(hardware, rig.network),
      has_joints(rig)
          ? "What a finger's joints give up, their arms times their angles, is what its runner "
            "travels."
          : "The hardware has no joints: each finger is a slider on a spring that is not the "
            "hardware's.",
      trees_lines(rig.network));
}

std::string contact_name(const Network& network, const ContactEnds& ends) {
  return fmt::format("contact_{}_{}", segment_name(network.segments[ends.left]),
                     segment_name(network.segments[ends.right]));
}

void write_friction(const MjcfRig& rig, const MechanicsBuilder& mechanics, MjcfText& out) {
  std::string exponents;
  for (const TendonSpan& span : rig.network.tendons) {
    for (std::size_t k = 0; k < span.contacts; ++k) {
      const ContactLaw law = mechanics.law_at(rig.network, span, k);
      const Contact& contact = rig.network.contacts[span.first_contact + k];
      out.leaf("text",
               {{"name", contact_name(rig.network, ends_of(span, k))},
                {"data", fmt::format("{}: mu {}, angle {} rad, exponent {}",
                                     contact_kind_name(contact.kind), MjcfText::number(law.mu),
                                     MjcfText::number(law.whole_angle_rad()),
                                     MjcfText::number(law.exponent()))}});
      exponents += (exponents.empty() ? "" : " ") + MjcfText::number(law.exponent());
    }
  }
  if (exponents.empty()) return;
  out.leaf("numeric", {{"name", "friction_exponents"}, {"data", exponents}});
}

void write_segments(const MjcfRig& rig, MjcfText& out) {
  for (std::size_t r = 0; r < rig.plan.ropes.size(); ++r) {
    const std::string names = joined(rig.plan.ropes[r].segments, " ", [&](std::size_t segment) {
      return segment_name(rig.network.segments[segment]);
    });
    out.leaf("text", {{"name", "segments_of_" + rope_name(r)}, {"data", names}});
  }
}

void write_settings(MjcfText& out) {
  out.leaf("compiler", {{"angle", "radian"}, {"autolimits", "true"}});
  out.open("option", {{"timestep", "0.001"}, {"gravity", "0 0 0"}});
  out.leaf("flag", {{"contact", "disable"}});
  out.close();
  out.open("default");
  out.leaf("equality", {{"solref", quick}, {"solimp", hard}});
  out.leaf("joint", {{"solreflimit", quick}, {"solimplimit", hard}});
  out.close();
}

void write_motors(double pull_N, int motors, MjcfText& out) {
  const std::string pull = MjcfText::number(pull_N);
  std::string pulls;
  out.open("actuator");
  for (int motor = 1; motor <= std::max(1, motors); ++motor) {
    out.leaf("motor", {{"name", motor == 1 ? "motor" : fmt::format("motor_{}", motor)},
                       {"joint", carriage_name(static_cast<std::size_t>(motor))},
                       {"ctrlrange", "0 " + pull}});
    pulls += (motor == 1 ? "" : " ") + pull;
  }
  out.close();
  out.open("keyframe");
  out.leaf("key", {{"name", "pull"}, {"ctrl", pulls}});
  out.close();
}

}  // namespace

std::string mjcf(const Routing& routing, const Hardware& hardware, const MjcfOrigin& origin) {
  require_no_slack(hardware);
  const MechanicsBuilder mechanics(hardware);
  Network network = expand(routing);
  RopePlan plan = rope_plan(routing, network);
  RigLayout layout = rig_layout(network, hardware, plan);
  const MjcfRig rig{std::move(network), std::move(plan), std::move(layout)};
  const std::string word = to_word(routing);
  MjcfText out;
  out.open("mujoco", {{"model", word}});
  out.comment(explanation(word, rig, hardware, origin));
  write_settings(out);
  out.open("custom");
  write_friction(rig, mechanics, out);
  write_segments(rig, out);
  out.close();
  write_world(rig, out);
  write_tendons(rig, out);
  write_equalities(rig, out);
  write_motors(hardware.motor.force_N.value_or(default_pull_N), carriage_count(rig.network), out);
  out.close();
  return out.text();
}

}  // namespace reeve::reports
