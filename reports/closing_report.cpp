#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <string>

#include "core/finger_guides.hpp"
#include "core/text.hpp"
#include "reports/hand_report.hpp"

namespace reeve::reports {
namespace {

bool has_objects(const ShownClosing& closing) {
  return std::ranges::any_of(closing.motion.stops, &JointStop::at_object);
}

bool has_forces(const std::vector<FingerPosture>& postures) {
  return std::ranges::any_of(
      postures, [](const FingerPosture& posture) { return !posture.contact_N.empty(); });
}

std::string force_or_torque(const FingerPosture& posture, std::size_t joint, bool forces) {
  if (!forces) return fixed(posture.object_Nmm[joint], 2);
  return posture.contact_N.empty() ? "-" : fixed(posture.contact_N[joint], 2);
}

Table closing_table(const ShownClosing& closing) {
  // Every second step: the figure and the JSON have them all.
  constexpr std::size_t stride = 2;
  const std::vector<FingerPosture>& postures = closing.motion.closing;
  const std::size_t joints = postures.front().flexion_rad.size();
  const bool objects = has_objects(closing);
  const bool forces = objects && has_forces(postures);
  Table table{{number_column("excursion", "mm"), number_column("pull", "N")}, {}};
  for (std::size_t j = 1; j <= joints; ++j) {
    table.columns.push_back(number_column(fmt::format("joint {}", j), "deg"));
  }
  for (std::size_t j = 1; j <= joints && objects; ++j) {
    table.columns.push_back(forces ? number_column(fmt::format("contact {}", j), "N")
                                   : number_column(fmt::format("object {}", j), "N mm"));
  }
  for (std::size_t i = 0; i < postures.size(); i += stride) {
    const FingerPosture& posture = postures[i];
    std::vector<std::string> cells{fixed(posture.excursion_mm, 1), fixed(posture.pull_N, 2)};
    for (const double flexion : posture.flexion_rad) cells.push_back(fixed(in_deg(flexion), 1));
    for (std::size_t j = 0; j < joints && objects; ++j) {
      cells.push_back(force_or_torque(posture, j, forces));
    }
    table.add(std::move(cells));
  }
  return table;
}

DocumentLine stop_line(const ShownClosing& closing) {
  std::vector<std::string> parts;
  for (const JointStop& stop : closing.motion.stops) {
    parts.push_back(fmt::format("joint {} at {} mm{}", stop.joint + 1, fixed(stop.excursion_mm, 1),
                                stop.at_object ? " (object)" : ""));
  }
  return {fmt::format("Joints stop in this order: {}", fmt::join(parts, ", "))};
}

// "Once all have stopped, each newton of pull adds 0.5 N at contact 1"
std::vector<DocumentLine> further_lines(const ShownClosing& closing) {
  const FurtherPull& further = closing.motion.further;
  const bool forces = !further.contact.empty();
  if (!forces && has_forces(closing.motion.closing)) return {};
  std::vector<std::string> parts;
  for (std::size_t j = 0; j < closing.joints.size(); ++j) {
    if (!closing.joints[j].object_deg) continue;
    parts.push_back(
        forces ? fmt::format("{} N at contact {}", fixed(further.contact[j], 2), j + 1)
               : fmt::format("{} N mm at object {}", fixed(further.object_mm[j], 2), j + 1));
  }
  if (parts.empty()) return {};
  const bool loses_one = std::ranges::any_of(further.contact, [](double f) { return f < 0; });
  return {
      {fmt::format("Once all have stopped, each newton of pull adds {}{}", fmt::join(parts, ", "),
                   loses_one ? "; a contact whose force falls to 0 is lost" : "")}};
}

// Explains the dashes of the table.
std::vector<DocumentLine> dash_lines(const ShownClosing& closing) {
  const std::vector<FingerPosture>& postures = closing.motion.closing;
  const bool lacks_some = std::ranges::any_of(
      postures, [](const FingerPosture& posture) { return posture.contact_N.empty(); });
  if (!has_objects(closing) || !has_forces(postures) || !lacks_some) return {};
  return {{"-: no contact forces, since a joint nearer to the palm than an object would give way"}};
}

Json further_json(const FurtherPull& further) {
  return {{"object_mm", further.object_mm},
          {"contact", further.contact.empty() ? Json(nullptr) : Json(further.contact)}};
}

Json posture_json(const FingerPosture& posture, const std::vector<FingerJoint>& joints) {
  std::vector<double> torques_Nmm;
  for (std::size_t j = 0; j < joints.size(); ++j) {
    torques_Nmm.push_back(joints[j].arm_mm * posture.tension_N[j]);
  }
  return {{"excursion_mm", posture.excursion_mm},
          {"pull_N", posture.pull_N},
          {"flexion_deg", list_json(posture.flexion_rad, in_deg)},
          {"tension_N", posture.tension_N},
          {"torque_Nmm", torques_Nmm},
          {"object_Nmm", posture.object_Nmm},
          {"contact_N", posture.contact_N.empty() ? Json(nullptr) : Json(posture.contact_N)}};
}

Json stop_json(const JointStop& stop) {
  return {{"joint", stop.joint + 1},
          {"excursion_mm", stop.excursion_mm},
          {"at_object", stop.at_object}};
}

}  // namespace

std::string fingers_text(const ShownClosing& closing) {
  return fmt::format("finger{} {}", closing.fingers.size() == 1 ? "" : "s",
                     fmt::join(closing.fingers, ", "));
}

std::vector<Section> closing_sections(const std::vector<ShownClosing>& closings) {
  std::vector<Section> sections;
  for (const ShownClosing& closing : closings) {
    std::vector<DocumentLine> lines{stop_line(closing)};
    append(lines, further_lines(closing));
    append(lines, dash_lines(closing));
    sections.push_back({fmt::format("Hand: closing of {} in free motion, joint angles over the "
                                    "excursion of the tendon",
                                    fingers_text(closing)),
                        closing_table(closing), lines});
  }
  return sections;
}

Json closings_json(const std::vector<ShownClosing>& closings) {
  return list_json(closings, [](const ShownClosing& closing) {
    const auto posture = [&](const FingerPosture& of) { return posture_json(of, closing.joints); };
    return Json{{"fingers", closing.fingers},
                {"closing", list_json(closing.motion.closing, posture)},
                {"opening", list_json(closing.motion.opening, posture)},
                {"stops", list_json(closing.motion.stops, stop_json)},
                {"further_pull", further_json(closing.motion.further)}};
  });
}

}  // namespace reeve::reports
