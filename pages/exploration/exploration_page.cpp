#include "pages/exploration/exploration_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "drawing/schematic/schematic_svg.hpp"
#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/exploration/exploration_figures.hpp"
#include "pages/exploration/exploration_holdings.hpp"
#include "pages/exploration/exploration_words.hpp"
#include "pages/figures.hpp"
#include "pages/routing_parts.hpp"
#include "pages/shell/asset_table.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/template.hpp"
#include "pages/sweep_figures.hpp"
#include "reports/assumed_words.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/exploration/part_words.hpp"
#include "reports/jam_words.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t schematics_of_the_front = 3;

// Places of what is ranked by among the objectives that are shown.
Json ranking_json(const ExploreReport& report) {
  const std::vector<Objective> objectives = page_objectives(report);
  return list_json(report.options.order.objectives, [&](Objective objective) {
    return std::ranges::find(objectives, objective) - objectives.begin();
  });
}

// Returns the chart specifications that the page's script fills with data.
Json specifications() {
  Json all = Json::object();
  for (const char* chart : {"pareto", "parallel", "tensions", "ranks"}) {
    all[chart] = Json::parse(asset(std::string(chart) + ".json"));
  }
  return all;
}

std::vector<Routing> drawn_routings(const ExploreReport& report) {
  std::vector<Routing> routings;
  for (const ListedDesign& design : report.front) {
    if (routings.size() == schematics_of_the_front) break;
    routings.push_back(design.routing);
  }
  for (const Routing& known : report.options.references) {
    if (std::ranges::find(routings, known) == routings.end()) {
      routings.push_back(known);
    }
  }
  return routings;
}

// Fit for an element.
std::string schematic_id(std::string word) {
  for (std::size_t at = word.find('+'); at != std::string::npos; at = word.find('+', at)) {
    word.replace(at, 1, "-and-");
  }
  return "schematic-" + word;
}

// Returns the parts that the schematics of this page can show. Slack strands depend on the grasp,
// so they are always included.
DrawnParts drawn_parts(const ExplorationView& view) {
  DrawnParts parts;
  const auto add = [&](const Routing& routing) { parts |= reports::drawn_parts(expand(routing)); };
  for (const Routing& routing : drawn_routings(view.report)) add(routing);
  const DetailedDesigns detailed = detailed_designs(view);
  for (const Routing* routing : detailed.whole) add(*routing);
  for (const Routing* routing : detailed.brief) add(*routing);
  parts.slack = true;
  return parts;
}

struct ExploredSchematic {
  std::string html;
  FigureFile file;
};

// In the first grasp.
ExploredSchematic schematic(const SolvedRouting& routing, const std::string& stem,
                            const std::string& id) {
  const ShownGrasp& shown = routing.grasps.front();
  const std::string svg = grasp_svg(routing, 0, id);
  const std::string file = schematic_name(stem, shown.grasp);
  return {schematic_html(id, svg, file), {file, svg, schematic_caption(routing, shown)}};
}

std::vector<ExploredSchematic> schematics(const ExplorationView& view) {
  std::vector<SolvedRouting> routings;
  std::vector<NamedRouting> named;
  for (const Routing& routing : drawn_routings(view.report)) {
    routings.push_back(view.solve(routing));
    named.push_back({routings.back().name, routings.back().word});
  }
  const std::vector<std::string> stems = file_stems(named);
  std::vector<ExploredSchematic> result;
  for (std::size_t i = 0; i < routings.size(); ++i) {
    result.push_back(schematic(routings[i], stems[i], schematic_id(routings[i].word)));
  }
  return result;
}

// The first design where it jams, if it does.
std::optional<ExploredSchematic> jammed_schematic(const ExploreReport& report) {
  if (!report.jammed_first) return std::nullopt;
  const SolvedRouting& first = *report.jammed_first;
  return schematic(first, file_stems({{first.name, first.word}}).front(), "schematic-jammed");
}

std::string held_flags(const GraspSet& grasps, int fingers) {
  const GraspSet usual = single_grasps(fingers);
  if (std::ranges::equal(grasps, usual, {}, &WeightedGrasp::grasp, &WeightedGrasp::grasp))
    return "";
  std::string flags;
  for (const WeightedGrasp& grasp : grasps) flags += " --held " + to_text(grasp.grasp);
  return flags;
}

Json commands(const ExplorationView& view) {
  const ExploreOptions& options = view.report.options;
  const auto held = [](const WeightedGrasp& grasp) { return to_text(grasp.grasp); };
  return {{"show", "reeve show"},
          {"held", held_flags(options.grasps, options.generator.fingers)},
          {"one", list_json(options.grasps, held)},
          {"options", view.show_options}};
}

std::string title(const ExploreReport& report) {
  return fmt::format("Exploration of {}-finger routings", report.options.generator.fingers);
}

Page page(const ExplorationView& view, const HeldDesigns& held, const DesignDetails& details,
          Json body) {
  body["details_text"] = details_text(view, details);
  return {title(view.report),
          render("exploration.mustache", body),
          "exploration_labels.js exploration_window.js exploration_charts.js "
          "exploration_parallel.js "
          "exploration_parts.js exploration_state.js exploration_columns.js exploration_table.js "
          "exploration_details.js exploration_cards.js exploration_panel.js "
          "exploration_finder.js exploration_brushes.js exploration_moves.js exploration.js",
          {{"objectives",
            objectives_json(page_objectives(view.report), cost_unit(view.report.options.prices))},
           {"ranking", ranking_json(view.report)},
           {"specifications", specifications()},
           {"columns", held.packed},
           {"commands", commands(view)},
           {"tradeoff", tradeoff_marks(view.report)},
           {"standings", standings_json(view.report)},
           {"chunks", details.chunks}},
          true};
}

// The first screen says it beside the answer, which hangs on it.
std::string assumed(const ExploreReport& report) {
  const ExploreOptions& options = report.options;
  return assumed_text(options.model) + ". Parts: " + routings_text(options.generator) +
         ". Fingers held: " + to_text(options.grasps) + ".";
}

Json words_json(const ExploreReport& report) {
  const ExplorationWords words = exploration_words(report);
  return {{"won", words.won},         {"explored", words.explored}, {"rejected", words.rejected},
          {"changes", words.changes}, {"caveats", words.caveats},   {"assumed", assumed(report)}};
}

}  // namespace

PageFiles exploration_page(const ExplorationView& view) {
  const ExploreReport& report = view.report;
  const HeldDesigns held = held_designs(report);
  const LiveFigure pareto =
      pareto_figure(held.designs, report.options.order.objectives, advised_designs(report));
  const LiveFigure parallel = parallel_figure(held.designs, page_objectives(report));
  const std::vector<ExploredSchematic> drawn = schematics(view);
  Json body = words_json(report);
  body.update(static_tables(report));
  body.update(answer_body(report, view.solve));
  body["tradeoff"] = tradeoff_html(report.tradeoff);
  std::vector<GlossaryTerm> terms = ranking_terms();
  append(terms, objective_terms(page_objectives(report)));
  body["glossary"] = glossary_html("Front, alike and the objectives: what they mean", terms);
  const auto sampled = std::ranges::count_if(
      held.designs, [](const PageDesign& design) { return design.kind == DesignKind::sample; });
  body["has_sample"] = sampled > 0;
  body["has_designs"] = !held.designs.empty();  // known routings, if none is ranked
  body["is_ranked"] = !listed_designs(report).empty();
  body["title"] = title(report);
  body["held_text"] = held_text(report, held.listed) + sample_text(sampled);
  body["pareto"] = live_figure_html(pareto);
  body["parallel"] = live_figure_html(parallel);
  const std::vector<Figure> swept =
      report.sweep ? sweep_figures(*report.sweep) : std::vector<Figure>{};
  body["sweep"] = report.sweep ? sweep_html(*report.sweep, swept) : "";
  body["command"] = view.command;
  body["legend"] = schematic_html("schematic-legend",
                                  schematic_legend(640, "schematic-legend", drawn_parts(view)));
  body["first_grasp"] = "held: " + to_text(report.options.grasps.front().grasp);
  body["schematics"] = Json::array();
  std::vector<FigureFile> figures;
  for (const ExploredSchematic& schematic : drawn) {
    body["schematics"].push_back(schematic.html);
    figures.push_back(schematic.file);
  }
  body["jammed"] = false;
  if (const std::optional<ExploredSchematic> jammed = jammed_schematic(report)) {
    const ShownGrasp& shown = report.jammed_first->grasps.front();
    body["jammed"] = {{"held", held_words(shown.grasp)}, {"html", jammed->html}};
    const bool is_drawn = std::ranges::any_of(
        figures, [&](const FigureFile& other) { return other.id == jammed->file.id; });
    if (!is_drawn) figures.push_back(jammed->file);
  }
  const std::size_t without = page_html(page(view, held, {}, body)).size();
  const DesignDetails details =
      design_details(detailed_designs(view), view.solve,
                     without < page_bytes ? page_bytes - without : 0, report.options.threads);
  for (const Figure& figure : {pareto.figure, parallel.figure}) {
    figures.push_back(captioned(figure, report.options.model));
  }
  for (const Figure& figure : swept) figures.push_back({figure.id, figure.svg});
  return {page_html(page(view, held, details, body)), std::move(figures)};
}

}  // namespace reeve::pages
