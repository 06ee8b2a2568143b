#include "reports/exploration/explore_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "core/notation.hpp"
#include "core/text.hpp"
#include "reports/assumed_words.hpp"
#include "reports/data_text.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/part_words.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "reports/exploration/target_report.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/jam_words.hpp"
#include "reports/model_text.hpp"
#include "reports/motor_words.hpp"
#include "reports/output/stamp.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t shown_at_most = 10;

// Not only counted.
std::uint64_t made(const ExploreResult& result) {
  return result.made_all ? result.evaluated : result.evaluated - result.pruned;
}

double rate(const ExploreResult& result) {
  return result.seconds > 0 ? static_cast<double>(made(result)) / result.seconds : 0;
}

// Each routing in one class, so that the numbers add up to those generated.
std::string counts_text(const ExploreReport& report) {
  const ExploreResult& result = report.result;
  std::string text = fmt::format("{} of {} routings generated in {:.2f} s:", result.generated,
                                 result.total, result.seconds);
  for (const Rejection& rejection : result.rejected) {
    text += fmt::format(" {} {},", rejection.count,
                        rejection.constraint
                            ? "fail " + report.options.constraints[*rejection.constraint].text
                            : "not actuated");
  }
  if (result.without_tensions.count > 0) {
    text += fmt::format(" {} without tensions,", result.without_tensions.count);
  }
  return text + fmt::format(" {} ranked", ranked_designs(report));
}

std::string evaluated_text(const ExploreResult& result) {
  if (made(result) == result.evaluated) {
    return fmt::format("{} evaluated, {:.0f} a second", result.evaluated, rate(result));
  }
  // Shards that are put together do not say whether these were evaluated, too.
  return fmt::format(
      "Of the {} that are actuated {} fail by their parts alone; the other {} evaluated, {:.0f} a "
      "second",
      result.evaluated, result.pruned, made(result), rate(result));
}

std::vector<Objective> objectives_to_show(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  return search::shown_objectives(options.order, options.score, options.constraints);
}

Section front_section(const ExploreReport& report, const ListColumns& columns) {
  std::string text = fmt::format("Pareto front over {}: {} with {} of values",
                                 objective_names(report.options.order.objectives),
                                 plural(report.front.size(), "design"),
                                 plural(distinct_on_front(report), "distinct set"));
  if (report.result.front_equals_left_out > 0) {
    text +=
        fmt::format(", and {} more that equal one of them", report.result.front_equals_left_out);
  }
  const auto lines = static_cast<std::size_t>(std::ranges::count_if(
      report.front, [](const ListedDesign& design) { return design.same_as.empty(); }));
  if (lines < report.front.size()) {
    text += fmt::format("; {} equivalent to others", report.front.size() - lines);
  }
  if (lines > shown_at_most) text += fmt::format("; the first {}", shown_at_most);
  return {
      text,
      design_table(one_of_each(report.front, shown_at_most), objectives_to_show(report), columns),
      {}};
}

std::string rank_cell(const ExploreReport& report, const ReferenceStanding& reference) {
  if (reference.rank > 0) return std::to_string(reference.rank);
  const bool is_beyond = reference.generated && !reference.rejected_by;
  return is_beyond ? fmt::format(">{}", report.options.top) : "-";
}

// Why it has no rank; "" if it has.
std::string why_unranked(const ExploreReport& report, const ReferenceStanding& reference) {
  if (!reference.generated) return "not in this set of parts";
  if (!reference.rejected_by) return "";
  return "fails " + report.options.constraints[*reference.rejected_by].text;
}

Section known_section(const ExploreReport& report) {
  if (report.result.references.empty()) return {};
  Table table{{text_column("name"), text_column("routing"), number_column("rank"),
               number_column("front", "", 1), number_column("dominated by", "", 2),
               number_column("uniformity"), number_column("efficiency")},
              {}};
  const std::vector<ReferenceStanding>& references = report.result.references;
  const bool some_unranked = std::ranges::any_of(references, [&](const ReferenceStanding& known) {
    return !why_unranked(report, known).empty();
  });
  if (some_unranked) table.columns.push_back(text_column("reason"));
  for (std::size_t i = 0; i < references.size(); ++i) {
    const ReferenceStanding& reference = references[i];
    const std::string why = why_unranked(report, reference);
    std::vector<std::string> cells{
        report.reference_names[i], reference.design.word, rank_cell(report, reference),
        reference.front > 0 ? std::to_string(reference.front) : "-",
        // If a design is rejected, the number of others that beat it says nothing.
        reference.rejected_by ? "-" : std::to_string(reference.dominated_by),
        fixed(value(reference.design.values, Objective::uniformity_mean)),
        fixed(value(reference.design.values, Objective::efficiency_mean))};
    if (some_unranked) cells.push_back(why);
    table.add(std::move(cells));
  }
  return {"Known routings", table, {}};
}

std::vector<DocumentLine> opening_lines(const ExploreReport& report) {
  const ExploreResult& result = report.result;
  std::vector<DocumentLine> lines{{counts_text(report)}, {evaluated_text(result)}};
  lines.push_back({assumed_text(report.options.model)});
  lines.push_back({"Parts: " + routings_text(report.options.generator)});
  const std::string note = partial_note(report);
  if (!note.empty()) lines.push_back({"PARTIAL: " + note, true});
  append(lines, note_lines(notes(report)));
  append(lines, model_lines(report.options.model, result.unconverged));
  if (report.options.order.by_score) {
    lines.push_back({order_text(report.options.order, report.options.score)});
  }
  lines.push_back(
      {"Uniformity and efficiency are given as mean/worst over the grasps (held fingers) " +
       to_text(report.options.grasps)});
  return lines;
}

// Lines name the limits that nobody has asked for, if the best design asks for more than the motor
// has.
std::vector<DocumentLine> limit_lines(const ExploreReport& report) {
  if (!report.motor) return {};
  const MotorParts& motor = report.options.model.hardware.motor;
  bool is_missed = false;
  std::string options;
  const auto add = [&](Objective objective, const std::optional<double>& limit, double asked) {
    const auto is_of_it = [&](const Constraint& constraint) {
      return constraint.objective == objective;
    };
    if (!limit || std::ranges::any_of(report.options.constraints, is_of_it)) return;
    is_missed |= asked > *limit;
    options += fmt::format(" --constraint '{}<={}'", row(objective).name, *limit);
  };
  add(Objective::motor_force, motor.force_N, report.motor->nominal_N);
  add(Objective::stroke, motor.stroke_mm, report.motor->stroke_mm);
  const bool is_possible =
      energy_lines(report.motor->least_work_J, motor, report.motor->motors.size()).empty();
  if (!is_missed || !is_possible) return {};
  return {{"Designs for this motor alone:" + options}};
}

Section answer_section(const ExploreReport& report) {
  std::vector<DocumentLine> lines = target_lines(report.target);
  const bool has_target = !lines.empty();
  append(lines, infeasible_lines(report.options, report.result));
  const std::vector<DocumentLine> best = answer_lines(report.top, report.tradeoff);
  if (has_target && !best.empty()) lines.push_back({"Apart from the target:"});
  append(lines, best);
  const MotorParts& motor = report.options.model.hardware.motor;
  append(lines, motor_lines(report.motor, motor));
  append(lines, limit_lines(report));
  append(lines, robust_lines(report.robust_first));
  append(lines, shared_first_lines(report.top));
  return {"", std::nullopt, lines};
}

Json known_json(const ExploreReport& report) {
  Json json = Json::array();
  for (std::size_t i = 0; i < report.result.references.size(); ++i) {
    const ReferenceStanding& reference = report.result.references[i];
    Json entry{{"name", report.reference_names[i]},
               {"routing", reference.design.word},
               {"rank", reference.rank > 0 ? Json(reference.rank) : Json(nullptr)},
               {"front", reference.front > 0 ? Json(reference.front) : Json(nullptr)},
               {"dominated_by", reference.dominated_by},
               {"generated", reference.generated},
               {"rejected_by", value_or_null(reference.rejected_by, [&](std::size_t constraint) {
                  return Json(report.options.constraints[constraint].text);
                })}};
    add_objectives(entry, reference.design.values);
    if (!report.reference_bands.empty()) entry["bands"] = bands_json(report.reference_bands[i]);
    json.push_back(entry);
  }
  return json;
}

Json nearest_json(const Nearest& nearest) {
  return {{"below", value_or_null(nearest.below, number)},
          {"above", value_or_null(nearest.above, number)}};
}

Json infeasible_json(const ExploreReport& report) {
  Json json = Json::array();
  for (std::size_t c = 0; c < report.result.infeasible.size(); ++c) {
    const ConstraintReach& reach = report.result.infeasible[c];
    json.push_back(
        {{"constraint", report.options.constraints[c].text},
         {"met_by_any", reach.met},
         {"nearest", nearest_json(reach.of_all)},
         {"nearest_with_the_others_met", nearest_json(reach.of_those_that_meet_the_others)}});
  }
  return json;
}

}  // namespace

Document explore_document(const ExploreReport& report, const ListColumns& wanted) {
  const ListColumns columns = priced(wanted, report.options.prices);
  const std::vector<ListedDesign> top = one_of_each(report.top, shown_at_most);
  const Section best{fmt::format("Top {}", top.size()),
                     design_table(top, objectives_to_show(report), columns), list_notes(top)};
  Document document{{{"", std::nullopt, opening_lines(report)}, answer_section(report)}};
  if (!columns.chosen.empty()) {
    document.add(best);
    return document;
  }
  // If the constraints leave no design, the answer section says so.
  document.add(target_section(report.target));
  if (!top.empty()) {
    document.add(front_section(report, columns));
    document.add(best);
    if (report.uncertainty) {
      document.add(band_section(top, report.options.order, *report.uncertainty));
    }
  }
  document.add(tradeoff_section(report.tradeoff));
  document.add(known_section(report));
  if (report.sweep) document.add_all(sweep_sections(*report.sweep));
  return document;
}

std::vector<std::string> notes(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  const Hardware hardware = effective_hardware(options.model);
  const bool equivalent = treats_fingers_alike(options.grasps, options.generator.fingers) &&
                          treats_fingers_alike(options.model, options.generator.fingers);
  std::vector<std::string> notes = model_notes(options.model, options.generator.fingers);
  if (options.generator.parts.motors > 1) notes.emplace_back(motors_together_note);
  if (options.left_out) notes.insert(notes.begin(), left_out_text(*options.left_out));
  if (const std::uint64_t count = report.result.without_tensions.count; count > 0) {
    notes.push_back(fmt::format("{} left out for want of tensions in a grasp, such as {}",
                                plural(count, "design"), report.result.why_without_tensions));
  }
  if (report.uncertainty) {
    append(notes, range_notes(hardware, report.uncertainty->ranges));
  } else if (report.motor) {
    append(notes, range_notes(hardware, report.motor->ranges));
  }
  if (report.uncertainty || report.motor) {
    const auto listed = looks_at_designs(listed_designs(report));
    append(notes, undrawn_notes(options.model.hardware, listed));
  }
  if (options.generator.identity == FingerIdentity::distinct) return notes;
  if (!treats_motors_alike(options.grasps)) {
    notes.insert(notes.begin(),
                 "the grasps tell the motors apart, but routings were listed for identical motors: "
                 "each was evaluated with the motor numbers of its word only; --distinct-fingers "
                 "evaluates all");
  }
  if (equivalent) return notes;
  notes.insert(
      notes.begin(),
      "the grasps, the hardware or a law tell the fingers apart, but routings were listed for "
      "identical fingers: each was evaluated with the finger numbers of its word only; "
      "--distinct-fingers evaluates all");
  return notes;
}

std::string partial_note(const ExploreReport& report) {
  if (report.draws_stopped) {
    return "stopped while drawing coefficients; ranks and objectives have no distributions";
  }
  if (report.sweep_over && !report.sweep && !report.result.partial) {
    return "stopped while sweeping; there is no sweep";
  }
  if (report.target && report.target->partial) {
    return "stopped while looking for designs that meet the target";
  }
  if (!report.result.partial) return "";
  if (report.result.generated == report.result.total) {
    return "stopped while it was worked out how near designs come to the constraints";
  }
  return fmt::format("stopped after {} of {} routings; ranks are among these",
                     report.result.generated, report.result.total);
}

std::uint64_t ranked_designs(const ExploreReport& report) {
  std::uint64_t count = report.result.evaluated;
  for (const Rejection& rejection : report.result.rejected) {
    if (rejection.constraint) count -= rejection.count;
  }
  return count;
}

std::string rejection_text(const Rejection& rejection, const ExploreOptions& options) {
  if (!rejection.constraint) return "not actuated";
  return "constraint " + options.constraints[*rejection.constraint].text;
}

Json explore_settings(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  const GeneratorOptions& generator = options.generator;
  Json json{{"fingers", generator.fingers},
            {"identical_fingers", generator.identity == FingerIdentity::identical},
            {"parts", parts_json(generator.parts)},
            {"tendons", generator.one_tendon ? "one" : "any"},
            {"shard", fmt::format("{}/{}", options.shard.index, options.shard.count)},
            {"top", options.top}};
  json["constraints"] =
      list_json(options.constraints, [](const Constraint& constraint) { return constraint.text; });
  json.update(settings_json(options.order, options.score, options.grasps, options.model,
                            report.result.unconverged));
  json["uncertainty"] = report.uncertainty ? to_json(*report.uncertainty) : Json(nullptr);
  add_tradeoff_settings(json, options.tradeoff, options.prices);
  json["sweep"] = sweep_settings(report.sweep_over);
  json["target_shares"] = report.target_shares.empty() ? Json(nullptr) : Json(report.target_shares);
  return json;
}

std::string whole_exploration_id(const ExploreReport& report) {
  Json asked = explore_settings(report);
  asked["shard"] = "1/1";
  // Counted on the way, not asked.
  if (asked["model"].is_object()) asked["model"].erase("unconverged");
  Json known = Json::array();
  for (std::size_t i = 0; i < report.options.references.size(); ++i) {
    known.push_back({report.reference_names[i], to_word(report.options.references[i])});
  }
  return hash_of({asked, known, version_json()});
}

std::string exploration_id(const ExploreReport& report) {
  std::string whole = whole_exploration_id(report);
  const Shard& shard = report.options.shard;
  const ExploreResult& result = report.result;
  if (shard.count == 1 && !result.partial && !report.draws_stopped) return whole;
  return hash_of(
      {whole, shard.index, shard.count, result.partial, result.generated, report.draws_stopped});
}

std::string explore_summary_json(const ExploreReport& report) {
  const ExploreResult& result = report.result;
  Json json{{"generated", result.generated}};
  json["rejected"] = Json::object();
  for (const Rejection& rejection : result.rejected) {
    json["rejected"][rejection_text(rejection, report.options)] = rejection.count;
  }
  if (result.without_tensions.count > 0) {
    json["rejected"]["no tensions"] = result.without_tensions.count;
  }
  json["evaluated"] = result.evaluated;
  json["pruned"] = result.pruned;
  json["ranked"] = ranked_designs(report);
  json["partial"] = !partial_note(report).empty();
  json["notes"] = notes(report);
  json["left_out"] = left_out_json(report.options.left_out);
  json["total"] = result.total;
  json["seconds"] = result.seconds;
  json["designs_per_second"] = rate(result);
  const std::optional<Visited>& visited = result.visited;
  json["designs_visited"] = visited ? Json(visited->designs) : Json(nullptr);
  json["beginnings_visited"] = visited ? Json(visited->beginnings) : Json(nullptr);
  json["front_equals_left_out"] = result.front_equals_left_out;
  json["front_distinct"] = distinct_on_front(report);
  ObjectText text;
  text.add_members(json);
  const auto listed = [](const ListedDesign& design) { return to_json(design); };
  text.add_list("front", report.front, listed);
  text.add_list("top", report.top, listed);
  json = {{"best", to_json(report.result.best)}};
  json["known"] = known_json(report);
  json["tradeoff"] = tradeoff_json(report.tradeoff);
  json["never_jams"] = never_jams_json(report.tradeoff);
  json["robust_first"] = robust_json(report.robust_first);
  json["target"] = target_json(report.target);
  json["motor"] = motor_force_json(report.motor, report.options.model.hardware.motor);
  json["unmet"] = infeasible_json(report);
  if (report.sweep_over) json["sweep"] = value_or_null(report.sweep, sweep_json);
  json["exploration"] = exploration_id(report);
  json["settings"] = explore_settings(report);
  json["version"] = version_json();
  text.add_members(json);
  return std::move(text).text();
}

}  // namespace reeve::reports
