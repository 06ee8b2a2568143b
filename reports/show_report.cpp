#include "reports/show_report.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contact_name.hpp"
#include "core/motor_sides.hpp"
#include "core/text.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "reports/assumed_words.hpp"
#include "reports/data_text.hpp"
#include "reports/hand_report.hpp"
#include "reports/jam_words.hpp"
#include "reports/model_text.hpp"
#include "reports/output/stamp.hpp"
#include "reports/shown_value.hpp"

namespace reeve::reports {
namespace {

// "T1->a", "a->T1" or "no"
std::string sliding(const Network& network, const ContactEnds& ends, double slip) {
  const std::string left = segment_name(network.segments[ends.left]);
  const std::string right = segment_name(network.segments[ends.right]);
  if (slip == 0) return "no";
  return slip > 0 ? left + "->" + right : right + "->" + left;
}

// "tube", "tube 90 deg"
std::string kind_text(const Contact& contact) {
  const std::string kind = contact_kind_name(contact.kind);
  return contact.angle.is_given() ? fmt::format("{} {} deg", kind, contact.angle.degrees()) : kind;
}

template <typename Visit>
void for_each_contact(const Network& network, Visit visit) {
  for (const TendonSpan& tendon : network.tendons) {
    for (std::size_t k = 0; k < tendon.contacts; ++k) {
      visit(ends_of(tendon, k), tendon.first_contact + k);
    }
  }
}

Json grasp_json(const Network& network, const ShownGrasp& shown) {
  Json json{{"held", held_fingers(shown.grasp)}, {"jams", shown.state.jams}};
  if (shown.state.opposed > 0) json["opposed_finger"] = shown.state.opposed;
  add_ends(json, shown.grasp);
  if (carriage_count(network) > 1) {
    json["motors"] = list_json(motor_tensions(network, shown.state), number);
  }
  json["tensions"] = Json::object();
  json["shares"] = Json::object();
  for (std::size_t i = 0; i < network.segments.size(); ++i) {
    json["tensions"][segment_name(network.segments[i])] = number(shown.state.tension[i]);
    if (network.segments[i].kind != SegmentKind::strand) continue;
    json["shares"][segment_name(network.segments[i])] =
        number(shown.state.tension[i] / shown.performance.force_transmission);
  }
  json["contacts"] = Json::array();
  for_each_contact(network, [&](const ContactEnds& ends, std::size_t contact) {
    Json one{
        {"between",
         {segment_name(network.segments[ends.left]), segment_name(network.segments[ends.right])}},
        {"kind", contact_kind_name(network.contacts[contact].kind)},
        {"slides", sliding(network, ends, shown.state.slip[contact])}};
    const WrapAngle angle = network.contacts[contact].angle;
    if (angle.is_given()) one["angle_deg"] = angle.degrees();
    json["contacts"].push_back(std::move(one));
  });
  json["uniformity"] = number(shown.performance.uniformity);
  json["efficiency"] = number(shown.performance.efficiency);
  json["force_transmission"] = number(shown.performance.force_transmission);
  return json;
}

std::string heading(const SolvedRouting& report) {
  std::string text = report.is_named() ? report.name + "  " + report.word : report.word;
  std::vector<std::string> beside;
  if (report.canonical != report.word) beside.push_back("canonical " + report.canonical);
  if (!report.is_named() && !report.name.empty()) beside.push_back("routing of " + report.name);
  return beside.empty() ? text : fmt::format("{}  ({})", text, fmt::join(beside, "; "));
}

// Friction that depends on the load makes the motor tension matter.
std::string unit_text(const ShownRouting& report) {
  if (report.model.effects.empty()) return "at motor tension 1";
  return fmt::format("over the motor tension of {:.6g} N", report.model.conditions.motor_tension_N);
}

std::string held_text(const Network& network, const ShownGrasp& shown) {
  return to_text(shown.grasp) + jam_mark(network, shown.state);
}

std::string held_heading(const Network& /*network*/, const ShownGrasp& shown) {
  return "held " + to_text(shown.grasp);
}

Table share_table(const SolvedRouting& report) {
  const std::vector<Segment>& segments = report.network.segments;
  Table table{{text_column("held")}, {}};
  for (const Segment& segment : segments) {
    if (segment.kind != SegmentKind::strand) continue;
    table.columns.push_back(number_column(segment_name(segment), "%"));
  }
  for (const ShownGrasp& shown : report.grasps) {
    std::vector<std::string> cells{held_text(report.network, shown)};
    for (std::size_t i = 0; i < segments.size(); ++i) {
      if (segments[i].kind != SegmentKind::strand) continue;
      cells.push_back(
          fixed(100 * shown.state.tension[i] / shown.performance.force_transmission, 1));
    }
    table.add(cells);
  }
  return table;
}

std::optional<double> spool_ratio(const Hardware& hardware, const std::string& segment) {
  for (const SpoolHardware& spool : hardware.spools) {
    if (spool.segment == segment) return spool.ratio;
  }
  return std::nullopt;
}

// Holds what stands between a motor-side segment and its motor.
struct Between {
  std::optional<double> spool;
  std::optional<double> spring_N_mm;
  std::optional<double> slack_mm;
};

Between between(const Network& network, const Hardware& hardware, std::size_t side) {
  Between result{spool_ratio(hardware, segment_name(network.segments[side])), {}, {}};
  for (const TendonHardware& own : hardware.tendon.own) {
    const TendonSpan& tendon = network.tendons[static_cast<std::size_t>(own.tendon) - 1];
    if (side < tendon.first_segment || side >= tendon.first_segment + tendon.segments) continue;
    if (find_motor_end(network, network.segments[side])) result.spring_N_mm = own.stiffness_N_mm;
    result.slack_mm = own.slack_mm;
  }
  return result;
}

// "a at T1, b at T4": which letter is where, since letters run in walk order; of several motors
// "a at T1 (M), b at T4 (M2)"; on a spool of its own "b at T4 (spool 0.5)", and likewise a spring
// or slack.
std::string letter_key(const Network& network, const Hardware& hardware) {
  const bool several = carriage_count(network) > 1;
  std::string key;
  for (const MotorSide& side : motor_sides(network)) {
    const std::string name = segment_name(network.segments[side.motor_side]);
    key += (key.empty() ? "" : ", ") + name + " at " + segment_name(network.segments[side.hand]);
    if (several) key += " (" + motor_name(network.segments[side.motor_side].carriage) + ")";
    const auto [spool, spring_N_mm, slack_mm] = between(network, hardware, side.motor_side);
    if (spool) key += fmt::format(" (spool {})", *spool);
    if (spring_N_mm) key += fmt::format(" (spring {} N/mm)", *spring_N_mm);
    if (slack_mm) key += fmt::format(" (slack {} mm)", *slack_mm);
  }
  return key;
}

Json letter_key_json(const Network& network, const Hardware& hardware) {
  const bool several = carriage_count(network) > 1;
  return list_json(motor_sides(network), [&](const MotorSide& side) {
    const std::string name = segment_name(network.segments[side.motor_side]);
    Json json{{"segment", name}, {"beside", segment_name(network.segments[side.hand])}};
    if (several) json["motor"] = network.segments[side.motor_side].carriage;
    const auto [spool, spring_N_mm, slack_mm] = between(network, hardware, side.motor_side);
    if (spool) json["spool"] = *spool;
    if (spring_N_mm) json["spring_N_mm"] = *spring_N_mm;
    if (slack_mm) json["slack_mm"] = *slack_mm;
    return json;
  });
}

}  // namespace

std::vector<ShownContact> shown_contacts(const SolvedRouting& report) {
  const Network& network = report.network;
  std::vector<ShownContact> contacts;
  for_each_contact(network, [&](const ContactEnds& ends, std::size_t contact) {
    contacts.push_back({contact_name(network, contact), kind_text(network.contacts[contact]), {}});
    for (const ShownGrasp& shown : report.grasps) {
      contacts.back().slides.push_back(sliding(network, ends, shown.state.slip[contact]));
    }
  });
  return contacts;
}

std::vector<std::string> grasp_names(const SolvedRouting& report,
                                     std::string (*name_of)(const Network&, const ShownGrasp&)) {
  std::vector<std::string> names;
  for (const ShownGrasp& shown : report.grasps) names.push_back(name_of(report.network, shown));
  return names;
}

Table tension_table(const SolvedRouting& report, const ShownWords& words) {
  Table table{{text_column(words.grasp)}, {}};
  for (const Segment& segment : report.network.segments) {
    table.columns.push_back(number_column(segment_name(segment), words.unit));
  }
  const int motors = carriage_count(report.network);
  for (int motor = 1; motors > 1 && motor <= motors; ++motor) {
    table.columns.push_back(number_column(motor_name(motor), words.unit));
  }
  for (const std::string& figure :
       {std::string("uniformity"), std::string("efficiency"), words.transmission}) {
    table.columns.push_back(number_column(figure));
  }
  for (std::size_t i = 0; i < report.grasps.size(); ++i) {
    const auto& [grasp, state, performance] = report.grasps[i];
    std::vector<double> values = state.tension;
    if (motors > 1) append(values, motor_tensions(report.network, state));
    append(values,
           {performance.uniformity, performance.efficiency, performance.force_transmission});
    std::vector<std::string> cells{words.grasps[i]};
    for (const double value : values) cells.push_back(fixed(value));
    table.add(std::move(cells));
  }
  return table;
}

Table contact_table(const SolvedRouting& report, const std::vector<std::string>& grasps) {
  Table table{{text_column("contact"), text_column("kind")}, {}};
  for (const std::string& grasp : grasps) table.columns.push_back(text_column(grasp));
  for (const ShownContact& contact : shown_contacts(report)) {
    std::vector<std::string> cells{contact.between, contact.kind};
    append(cells, contact.slides);
    table.add(std::move(cells));
  }
  return table;
}

Table objective_list(const ShownRouting& report) {
  const ObjectiveValues& values = report.values;
  Table table{{text_column("objective"), number_column("value"), text_column("unit"),
               text_column("meaning")},
              {}};
  for (const ObjectiveRow& row : objective_table()) {
    if (!is_there(row, values)) continue;
    if (row.objective == Objective::cost && !report.prices) continue;
    const bool priced = row.objective == Objective::cost && !report.prices->unit.empty();
    table.add({row.name, objective_text(row.objective, value(values, row.objective)),
               priced ? report.prices->unit : row.unit, row.meaning});
  }
  return table;
}

Document show_document(const ShownRouting& report) {
  std::vector<DocumentLine> lines{{heading(report)}};
  if (const std::string key = letter_key(report.network, report.model.hardware); !key.empty()) {
    lines.push_back({"Motor-side segments, in walk order: " + key});
  }
  if (const std::string shared = shared_carriage_text(report.network, report.model.hardware.tendon);
      !shared.empty()) {
    lines.push_back({shared});
  }
  lines.push_back({jam_sentence(report.smallest_jams, report.values, report.network)});
  lines.push_back({assumed_text(report.model)});
  append(lines, model_lines(report.model, report.unconverged));
  append(lines, note_lines(model_notes(report.model, {report.network})));
  if (report.hand && report.hand->drawn) {
    append(lines,
           note_lines(range_notes(effective_hardware(report.model), report.hand->drawn->ranges)));
    append(lines, note_lines(undrawn_notes(report.model.hardware,
                                           [&](ValueUse& use) { use.look_at(report.network); })));
  }
  Document document{
      {{"", std::nullopt, lines},
       {fmt::format("Tensions {}, {}", unit_text(report),
                    report.direction == Direction::pull ? "pulling" : "releasing"),
        tension_table(report, {"held", "N/N", "force", grasp_names(report, held_text)}),
        {}},
       {"Shares of the strands, %", share_table(report), {}},
       {"Sliding", contact_table(report, grasp_names(report, held_heading)), {}},
       {"Over these grasps, pulling", objective_list(report), {}}}};
  if (report.hand) document.add_all(hand_sections(*report.hand));
  return document;
}

Json to_json(const ShownRouting& report) {
  Json json{{"routing", report.word},
            {"name", text_or_null(report.name)},
            {"canonical", report.canonical},
            {"direction", direction_field(report.direction)},
            {"motor_sides", letter_key_json(report.network, report.model.hardware)},
            {"trees", tree_count(report.network)}};
  if (report.own_hardware) json["own_hardware"] = to_json(report.model.hardware);
  json["grasps"] = list_json(
      report.grasps, [&](const ShownGrasp& shown) { return grasp_json(report.network, shown); });
  add_objectives(json, report.values);
  json["smallest_jams"] = grasps_json(report.smallest_jams);
  if (report.hand) add_hand(json["hand"], *report.hand);
  json["model"] = model_json(report.model, report.unconverged);
  if (report.prices) json["prices"] = to_json(*report.prices);
  return json;
}

std::string show_json(const ShownRouting& report) { return print_stamped(to_json(report)); }

std::string show_svg(const SolvedRouting& report, const ShownGrasp* shown, const std::string& ids) {
  const std::string title = report.title();
  if (shown == nullptr) return schematic_svg(schematic(report.network, title), ids);
  const GraspView view{shown->grasp, report.direction, shown->state};
  return schematic_svg(schematic(report.network, title, view), ids);
}

}  // namespace reeve::reports
