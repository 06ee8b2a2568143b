#include "pages/exploration/exploration_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "core/notation.hpp"
#include "pages/exploration/exploration_answer.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/exploration/exploration_method.hpp"
#include "pages/exploration/exploration_pictures.hpp"
#include "pages/exploration/exploration_tables.hpp"
#include "pages/exploration/exploration_words.hpp"
#include "pages/exploration/ladder_part.hpp"
#include "pages/routing/figure_captions.hpp"
#include "pages/routing/figure_names.hpp"
#include "pages/shell/asset_table.hpp"
#include "pages/shell/compressed.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/template.hpp"
#include "pages/uncertainty/sweep_figures.hpp"
#include "reports/schematic/schematic_svg.hpp"
#include "reports/uncertainty/band_report.hpp"

namespace reeve::pages {
namespace {

constexpr std::size_t column_bytes = 2'000'000;
constexpr std::size_t schematics_of_the_front = 3;

struct HeldDesigns {
  std::vector<PageDesign> designs;
  std::string packed;  // their columns
  std::size_t listed = 0;
};

// As many as fit.
HeldDesigns held_designs(const ExploreReport& report) {
  std::size_t most = listed_designs(report).size();
  for (;;) {
    std::vector<PageDesign> designs = page_designs(report, most);
    Json columns = design_columns(designs, page_objectives(report));
    if (report.uncertainty) {
      columns["bands"] =
          band_columns(designs, page_objectives(report), report.options.order.objectives);
    }
    std::string packed = compressed(columns.dump());
    if (packed.size() <= column_bytes) return {std::move(designs), std::move(packed), most};
    const double share = static_cast<double>(column_bytes) / static_cast<double>(packed.size());
    most = static_cast<std::size_t>(0.97 * share * static_cast<double>(most));
  }
}

// Places of what is ranked by among the objectives that are shown.
Json ranking_json(const ExploreReport& report) {
  const std::vector<Objective> objectives = page_objectives(report);
  Json list = Json::array();
  for (const Objective objective : report.options.order.objectives) {
    list.push_back(std::find(objectives.begin(), objectives.end(), objective) - objectives.begin());
  }
  return list;
}

// What the page's script fills with data.
Json specifications() {
  Json all = Json::object();
  for (const char* chart : {"pareto", "parallel", "tensions", "ranks"}) {
    all[chart] = Json::parse(asset(std::string(chart) + ".json"));
  }
  return all;
}

// Those of the ladder, known routings, then the best in the order of the ranking, which the front
// begins.
std::vector<const Routing*> in_order_of_details(const ExploreReport& report, std::size_t best) {
  std::vector<const Routing*> routings;
  std::set<std::string> held;
  const auto add = [&](const Routing& routing) {
    if (held.insert(to_word(routing)).second) routings.push_back(&routing);
  };
  for (const Routing* routing : ladder_routings(report)) add(*routing);
  for (const Routing& known : report.options.references) add(known);
  const std::vector<ListedDesign>& listed = listed_designs(report);
  for (std::size_t i = 0; i < std::min(best, listed.size()); ++i) add(listed[i].routing);
  return routings;
}

std::size_t details_of(const ExplorationView& view) {
  return view.details.value_or(usual_schematics / view.report.options.grasps.size());
}

// Unless it was said how many, further ones are drawn in the first grasp, so that whatever is
// pointed at near the top has a drawing.
DetailedDesigns detailed_designs(const ExplorationView& view) {
  DetailedDesigns designs{in_order_of_details(view.report, details_of(view)), {}};
  if (view.details) return designs;
  const std::vector<const Routing*> more =
      in_order_of_details(view.report, details_of(view) + usual_first_schematics);
  designs.brief.assign(more.begin() + static_cast<std::ptrdiff_t>(designs.whole.size()),
                       more.end());
  return designs;
}

std::vector<Routing> drawn_routings(const ExploreReport& report) {
  std::vector<Routing> routings;
  for (const ListedDesign& design : report.front) {
    if (routings.size() == schematics_of_the_front) break;
    routings.push_back(design.routing);
  }
  for (const Routing& known : report.options.references) {
    if (std::find(routings.begin(), routings.end(), known) == routings.end()) {
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

// What those schematics show besides the parts of every routing.
FloatingParts drawn_parts(const ExplorationView& view) {
  FloatingParts parts;
  for (const Routing& routing : drawn_routings(view.report)) {
    parts |= floating_parts(view.solve(routing).network);
  }
  return parts;
}

struct ExploredSchematic {
  std::string html;
  FigureFile file;
};

// In the first grasp.
std::vector<ExploredSchematic> schematics(const ExplorationView& view) {
  std::vector<ShownRouting> routings;
  std::vector<NamedRouting> named;
  for (const Routing& routing : drawn_routings(view.report)) {
    routings.push_back(view.solve(routing));
    named.push_back({routings.back().name, routings.back().word});
  }
  const std::vector<std::string> stems = file_stems(named);
  std::vector<ExploredSchematic> result;
  for (std::size_t i = 0; i < routings.size(); ++i) {
    const ShownGrasp& shown = routings[i].grasps.front();
    const std::string id = schematic_id(routings[i].word);
    const std::string svg = grasp_svg(routings[i], 0, id);
    const std::string file = schematic_name(stems[i], shown.grasp);
    result.push_back(
        {schematic_html(id, svg, file), {file, svg, schematic_caption(routings[i], shown)}});
  }
  return result;
}

std::string held_flags(const GraspSet& grasps, int fingers) {
  const GraspSet usual = single_grasps(fingers);
  const auto same = [](const WeightedGrasp& a, const WeightedGrasp& b) {
    return a.grasp == b.grasp;
  };
  if (std::equal(grasps.begin(), grasps.end(), usual.begin(), usual.end(), same)) return "";
  std::string flags;
  for (const WeightedGrasp& grasp : grasps) flags += " --held " + to_text(grasp.grasp);
  return flags;
}

Json commands(const ExplorationView& view) {
  const ExploreOptions& options = view.report.options;
  Json held = Json::array();
  for (const WeightedGrasp& grasp : options.grasps) held.push_back(to_text(grasp.grasp));
  return {{"show", "reeve show"},
          {"held", held_flags(options.grasps, options.generator.fingers)},
          {"one", held},
          {"options", view.show_options}};
}

std::string title(const ExploreReport& report) {
  return fmt::format("Exploration of {}-finger routings", report.options.generator.fingers);
}

std::string held_text(const ExploreReport& report, std::size_t held) {
  const std::size_t listed = listed_designs(report).size();
  std::string text =
      fmt::format("{} of {} ranked designs are listed", listed, ranked_designs(report));
  if (held < listed) text += fmt::format("; this page holds the first {}", held);
  return text + fmt::format(". {} of them {} on the front.", report.front.size(),
                            report.front.size() == 1 ? "is" : "are");
}

std::string sample_text(const ExploreReport& report, std::ptrdiff_t others) {
  if (others == 0) return "";
  return fmt::format(
      " What they stand out from is shown by {} more: the rest of {} drawn at random from all.",
      others, report.result.sample.size());
}

// Why a known routing is not in the list, or one of the ladder.
std::string standing(const ReferenceStanding& reference, const ExploreReport& report) {
  if (!reference.generated && report.result.partial)
    return "it was not reached before the exploration stopped";
  if (!reference.generated) return "these parts, or this shard, do not give it";
  if (reference.rejected_by) {
    return "it fails " + report.options.constraints[*reference.rejected_by].text;
  }
  return fmt::format("its rank is beyond the list, and {} designs dominate it",
                     reference.dominated_by);
}

Json standings_json(const ExploreReport& report) {
  Json json = Json::object();
  for (const ListedDesign& rung : report.ladder.rungs) {
    json[rung.ranked.design.word] = "On the ladder; its rank is beyond the list.";
  }
  for (const ReferenceStanding& reference : report.result.references) {
    json[reference.design.word] = fmt::format("Known routing, not among the listed designs: {}.",
                                              standing(reference, report));
  }
  return json;
}

std::string details_text(const ExplorationView& view, const DesignDetails& details) {
  const std::size_t listed = listed_designs(view.report).size();
  const std::size_t all = in_order_of_details(view.report, listed).size();
  if (details.designs >= all) {
    return fmt::format(
        "All {} listed designs and known routings have schematics, tensions and contacts here.",
        all);
  }
  const bool full = details.designs < in_order_of_details(view.report, details_of(view)).size();
  const std::string brief =
      details.brief == 0
          ? ""
          : fmt::format(", and {} more their schematic in the first grasp", details.brief);
  return fmt::format(
      "{} of {} listed designs and known routings have schematics, tensions and contacts here{}: "
      "those of the ladder and known routings first, then by rank. For the others the page gives "
      "the values and the command that shows the rest; {}.",
      details.designs, all, brief,
      full ? "there is no room for more of them, whatever --details says"
           : fmt::format("with --details {} it has all, as far as there is room", listed));
}

Page page(const ExplorationView& view, const HeldDesigns& held, const DesignDetails& details,
          Json body) {
  body["details_text"] = details_text(view, details);
  return {title(view.report),
          render("exploration.mustache", body),
          "exploration_labels.js exploration_charts.js exploration_parallel.js "
          "exploration_state.js exploration_columns.js exploration_table.js "
          "exploration_details.js exploration_cards.js exploration_panel.js "
          "exploration_brushes.js exploration.js",
          {{"objectives", objectives_json(page_objectives(view.report))},
           {"ranking", ranking_json(view.report)},
           {"specifications", specifications()},
           {"columns", held.packed},
           {"commands", commands(view)},
           {"ladder", ladder_marks(view.report)},
           {"standings", standings_json(view.report)},
           {"chunks", details.chunks}},
          true};
}

Json words_json(const ExploreReport& report) {
  const ExplorationWords words = exploration_words(report);
  return {{"won", words.won},
          {"explored", words.explored},
          {"rejected", words.rejected},
          {"changes", words.changes},
          {"caveats", words.caveats}};
}

}  // namespace

PageFiles exploration_page(const ExplorationView& view) {
  const ExploreReport& report = view.report;
  const HeldDesigns held = held_designs(report);
  const ExplorationPicture pareto =
      pareto_picture(held.designs, report.options.order.objectives, advised_designs(report));
  const ExplorationPicture parallel = parallel_picture(held.designs, page_objectives(report));
  const std::vector<ExploredSchematic> drawn = schematics(view);
  Json body = words_json(report);
  body.update(static_tables(report));
  body.update(answer_body(report, view.solve));
  body["ladder"] = ladder_html(report.ladder);
  std::vector<Term> terms = ranking_terms();
  for (Term& term : objective_terms(page_objectives(report))) terms.push_back(std::move(term));
  body["glossary"] = glossary_html("Front, alike and the objectives: what they mean", terms);
  const auto sampled =
      std::count_if(held.designs.begin(), held.designs.end(),
                    [](const PageDesign& design) { return design.kind == Kind::sample; });
  body["has_sample"] = sampled > 0;
  body["title"] = title(report);
  body["held_text"] = held_text(report, held.listed) + sample_text(report, sampled);
  body["pareto"] = live_figure_html(pareto.figure, pareto.alt);
  body["parallel"] = live_figure_html(parallel.figure, parallel.alt);
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
