#include "reports/rank_report.hpp"

#include <array>
#include <utility>

#include "core/text.hpp"
#include "reports/assumed_words.hpp"
#include "reports/data_text.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/model_text.hpp"
#include "reports/motor_words.hpp"
#include "reports/output/json.hpp"
#include "reports/output/stamp.hpp"
#include "reports/show_report.hpp"
#include "search/evaluate/shown_objectives.hpp"
#include "studies/tension_distributions.hpp"

namespace reeve::reports {
namespace {

const char* word(FrictionKind kind) {
  // In the order of FrictionKind.
  constexpr std::array names{"coefficient", "model", "diagnosed"};
  return names.at(static_cast<std::size_t>(kind));
}

Json strand_json(const StrandShare& strand) {
  Json json{{"strand", strand.strand}, {"model", number(strand.model)},
            {"published", nullptr},    {"published_fault", nullptr},
            {"measured", nullptr},     {"measured_deviation", nullptr}};
  if (strand.published) {
    json["published"] = strand.published->share;
    json["published_fault"] = text_or_null(strand.published->fault);
  }
  if (strand.measured) {
    json["measured"] = strand.measured->mean;
    if (strand.measured->deviation) json["measured_deviation"] = *strand.measured->deviation;
  }
  return json;
}

Json shares_json(const RoutingShares& routing) {
  return {{"routing", routing.word},
          {"name", text_or_null(routing.name)},
          {"published_source", text_or_null(routing.published_source)},
          {"readings", routing.readings},
          {"strands", list_json(routing.strands, strand_json)}};
}

Json distribution_json(const TensionDistribution& distribution) {
  const bool one = distribution.kind == FrictionKind::coefficient;
  return {{"mu", one ? Json(distribution.tube_mu) : Json(nullptr)},
          {"friction", word(distribution.kind)},
          {"tube_mu", distribution.tube_mu},
          {"sheath_mu", distribution.sheath_mu},
          {"held", held_fingers(distribution.grasp)},
          {"rms_measured", value_or_null(distribution.rms_measured, number)},
          {"share_error", value_or_null(distribution.share_errors.model, number)},
          {"published_share_error", value_or_null(distribution.share_errors.published, number)},
          {"routings", list_json(distribution.routings, shares_json)}};
}

Json shared_data_json(const SharedData& data) {
  return {{"file", data.file}, {"simulated", data.simulated}, {"notes", notes_json(data.notes)}};
}

std::string name_of(const RankReport& report, const std::string& word) {
  for (const ListedDesign& design : report.designs) {
    if (design.ranked.design.word == word && !design.name.empty()) return design.name;
  }
  return word;
}

Section margin_section(const RankReport& report) {
  if (!report.margins || report.margins->empty()) return {};
  Table table{{text_column("over"), number_column("lead"), number_column("least lead"),
               number_column("mu tube"), number_column("mu sheath"), number_column("mu bearing"),
               number_column("sheath angle, rad")},
              {}};
  for (const Margin& margin : *report.margins) {
    table.add({name_of(report, margin.challenger), fixed(margin.nominal_lead, 4),
               fixed(margin.least_lead, 4), fixed(margin.at.tube.mu), fixed(margin.at.sheath.mu),
               fixed(margin.at.bearing.mu, 5), fixed(margin.at.sheath.angle_rad, 2)});
  }
  return {
      "Lead of the best design in mean uniformity x mean efficiency, and the coefficients within\n"
      "their ranges at which it is least; below 0 the order changes there",
      table,
      {}};
}

Json margin_json(const Margin& margin) {
  return {{"over", margin.challenger},
          {"lead", margin.nominal_lead},
          {"least_lead", margin.least_lead},
          {"at",
           {{"tube_mu", margin.at.tube.mu},
            {"sheath_mu", margin.at.sheath.mu},
            {"bearing_mu", margin.at.bearing.mu},
            {"sheath_angle_rad", margin.at.sheath.angle_rad}}}};
}

void add_details(Json& json, const RankDetails& details) {
  json["best"] = to_json(details.best);
  json["routings"] =
      list_json(details.routings, [](const ShownRouting& routing) { return to_json(routing); });
  json["tension_distributions"] = list_json(details.distributions.list, distribution_json);
  json["measured_data"] = value_or_null(details.distributions.data, shared_data_json);
}

}  // namespace

Document rank_document(const RankReport& report, const ListColumns& wanted) {
  const ListColumns columns = priced(wanted, report.prices);
  std::vector<DocumentLine> lines{{assumed_text(report.model)}};
  append(lines, model_lines(report.model, report.unconverged));
  if (!report.designs.empty()) {
    const int fingers = finger_count(report.designs.front().routing);
    append(lines, note_lines(model_notes(report.model, fingers)));
  }
  if (report.uncertainty || report.margins || report.motor) {
    const Hardware nominal = effective_hardware(report.model);
    append(lines, note_lines(range_notes(nominal, report.ranges)));
    append(lines,
           note_lines(undrawn_notes(report.model.hardware, looks_at_designs(report.designs))));
  }
  lines.push_back({order_text(report.order, report.score) +
                   "; uniformity and efficiency as mean/worst over the grasps (held fingers) " +
                   to_text(report.grasps)});
  const std::vector<ListedDesign> shown = one_of_each(report.designs);
  Document document{
      {{"", std::nullopt, lines},
       {"", design_table(shown, shown_objectives(report.order, report.score), columns),
        list_notes(shown, report.model.hardware.tendon)}}};
  const std::vector<DocumentLine> motor = motor_lines(report.motor, report.model.hardware.motor);
  if (report.designs.size() == 1) document.add({"", std::nullopt, motor});
  if (report.designs.size() > 1) {
    std::vector<DocumentLine> answer = answer_lines(report.designs, report.tradeoff);
    append(answer, motor);
    append(answer, robust_lines(report.robust_first));
    append(answer, shared_first_lines(report.designs));
    document.add({"", std::nullopt, answer});
  }
  if (!columns.chosen.empty()) return document;
  if (report.uncertainty) document.add(band_section(shown, report.order, *report.uncertainty));
  document.add(tradeoff_section(report.tradeoff));
  document.add(margin_section(report));
  if (report.sweep) document.add_all(sweep_sections(*report.sweep));
  return document;
}

std::string rank_json(const RankReport& report) {
  Json json{{"designs", to_json(report.designs)},
            {"settings", settings_json(report.order, report.score, report.grasps, report.model,
                                       report.unconverged)}};
  json["settings"]["uncertainty"] =
      report.uncertainty ? to_json(*report.uncertainty) : Json(nullptr);
  add_tradeoff_settings(json["settings"], report.tradeoff.tradeoff.options, report.prices);
  json["settings"]["sweep"] =
      sweep_settings(report.sweep ? std::optional(report.sweep->sweep.over) : std::nullopt);
  json["tradeoff"] = tradeoff_json(report.tradeoff);
  json["never_jams"] = never_jams_json(report.tradeoff);
  json["robust_first"] = robust_json(report.robust_first);
  json["motor"] = motor_force_json(report.motor, report.model.hardware.motor);
  if (report.margins) json["margins"] = list_json(*report.margins, margin_json);
  if (report.details) add_details(json, *report.details);
  if (report.sweep) json["sweep"] = sweep_json(*report.sweep);
  json["version"] = version_json();
  return print_stamped(std::move(json));
}

}  // namespace reeve::reports
