#include "pages/exploration_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "pages/chart_engine.hpp"
#include "pages/compressed.hpp"
#include "pages/exploration_designs.hpp"
#include "pages/exploration_tables.hpp"
#include "pages/exploration_words.hpp"
#include "pages/objective_title.hpp"
#include "pages/template.hpp"
#include "reports/schematic_svg.hpp"

namespace reeve {
namespace {

constexpr const char* charts = "exploration_charts.js";
constexpr std::size_t column_bytes = 2'000'000;
constexpr std::size_t schematics_of_the_front = 3;

struct HeldDesigns {
  Json data;           // of charts
  std::string packed;  // its columns
  std::size_t listed = 0;
};

// As many as fit.
HeldDesigns held_designs(const ExploreReport& report) {
  std::size_t most = listed_designs(report).size();
  for (;;) {
    Json columns = design_columns(report, most);
    std::string packed = compressed(columns.dump());
    if (packed.size() <= column_bytes) {
      return {chart_data(report, std::move(columns)), std::move(packed), most};
    }
    const double share = static_cast<double>(column_bytes) / static_cast<double>(packed.size());
    most = static_cast<std::size_t>(0.97 * share * static_cast<double>(most));
  }
}

Json axes(const std::vector<Objective>& ranking) {
  const auto first = static_cast<std::size_t>(ranking.front());
  if (ranking.size() > 1) return {first, static_cast<std::size_t>(ranking[1])};
  const auto other = ranking.front() == Objective::efficiency_mean ? Objective::uniformity_mean
                                                                   : Objective::efficiency_mean;
  return {first, static_cast<std::size_t>(other)};
}

Figure chart(Figure figure, const Json& drawn) {
  return reeve::figure(std::move(figure), drawn["spec"]);
}

Figure pareto_figure(const Json& data, const ExploreReport& report) {
  const Json drawn = script_value(charts, "explorationCharts.pareto",
                                  {{"data", data},
                                   {"axes", axes(report.options.order.objectives)},
                                   {"grid", {{"columns", 90}, {"lines", 60}}}});
  return chart({"pareto", "Designs by two objectives.",
                "The dashed line is the edge of the Pareto front, drawn where both axes are what "
                "the ranking counts. Where several designs share a spot, the first is drawn.",
                fmt::format("Scatter plot of the designs over {}; {} marks stand for {} designs.",
                            objective_titles(report.options.order.objectives),
                            drawn["drawn"].dump(), drawn["of"].dump()),
                Json(), ""},
               drawn);
}

Figure parallel_figure(const Json& data) {
  const Json drawn =
      script_value(charts, "explorationCharts.parallel", {{"data", data}, {"most", 250}});
  return chart(
      {"parallel", "Designs by all objectives.",
       "A line for each design. Up is better on every axis: where less is better (↓) the "
       "axis is turned round. The numbers are the best and the worst value.",
       fmt::format("Parallel coordinates of all objectives; {} lines stand for {} designs.",
                   drawn["drawn"].dump(), drawn["of"].dump()),
       Json(), ""},
      drawn);
}

// Known routings, then in the order of the ranking, which the front begins.
std::vector<std::string> in_order_of_details(const ExploreReport& report) {
  std::vector<std::string> words;
  for (const ReferenceStanding& reference : report.result.references) {
    words.push_back(reference.design.word);
  }
  const std::set<std::string> known(words.begin(), words.end());
  for (const ListedDesign& design : listed_designs(report)) {
    if (!known.contains(design.ranked.design.word)) words.push_back(design.ranked.design.word);
  }
  return words;
}

std::vector<std::string> drawn_words(const ExploreReport& report) {
  std::vector<std::string> words;
  for (const ListedDesign& design : report.front) {
    if (words.size() == schematics_of_the_front) break;
    words.push_back(design.ranked.design.word);
  }
  for (const ReferenceStanding& reference : report.result.references) {
    if (std::find(words.begin(), words.end(), reference.design.word) == words.end()) {
      words.push_back(reference.design.word);
    }
  }
  return words;
}

// Fit for an element and a file.
std::string schematic_id(std::string word) {
  for (std::size_t at = word.find('+'); at != std::string::npos; at = word.find('+', at)) {
    word.replace(at, 1, "-and-");
  }
  return "schematic-" + word;
}

std::vector<FigureFile> schematics(const ExplorationView& view) {
  std::vector<FigureFile> files;
  for (const std::string& word : drawn_words(view.report)) {
    const std::string id = schematic_id(word);
    files.push_back({id, grasp_svg(view.solve(word), 0, id)});
  }
  return files;
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

// Why a known routing is not in the list.
std::string standing(const ReferenceStanding& reference, bool partial) {
  if (!reference.generated && partial) return "it was not reached before the exploration stopped";
  if (!reference.generated) return "these parts, or this shard, do not give it";
  if (!reference.rejected_by.empty()) return "it fails " + reference.rejected_by;
  return fmt::format("its rank is beyond the list, and {} designs dominate it",
                     reference.dominated_by);
}

Json standings(const ExploreReport& report) {
  Json json = Json::object();
  for (const ReferenceStanding& reference : report.result.references) {
    json[reference.design.word] = standing(reference, report.result.partial);
  }
  return json;
}

Page page(const ExplorationView& view, const HeldDesigns& held, const DesignDetails& details,
          Json body) {
  const std::size_t wanted = in_order_of_details(view.report).size();
  body["details_text"] =
      details.designs >= wanted
          ? fmt::format(
                "All {} listed designs and known routings have schematics, tensions and "
                "contacts here.",
                wanted)
          : fmt::format(
                "{} of {} listed designs and known routings have schematics, tensions and "
                "contacts here: known routings first, then by rank. For the others the "
                "page gives the values and the command that shows the rest.",
                details.designs, wanted);
  return {title(view.report),
          render("exploration.mustache", body),
          "exploration_charts.js exploration_state.js exploration_table.js exploration_cards.js "
          "exploration.js",
          {{"objectives", held.data["objectives"]},
           {"ranking", held.data["ranking"]},
           {"columns", held.packed},
           {"commands", commands(view)},
           {"standings", standings(view.report)},
           {"chunks", details.chunks}}};
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
  const Figure pareto = pareto_figure(held.data, report);
  const Figure parallel = parallel_figure(held.data);
  std::vector<FigureFile> figures = schematics(view);
  Json body = words_json(report);
  body.update(static_tables(report));
  const Json& kinds = held.data["designs"]["kind"];
  const auto sampled = std::count(kinds.begin(), kinds.end(), Json(static_cast<int>(Kind::sample)));
  body["has_sample"] = sampled > 0;
  body["title"] = title(report);
  body["held_text"] = held_text(report, held.listed) + sample_text(report, sampled);
  body["pareto"] = figure_html(pareto);
  body["parallel"] = figure_html(parallel);
  body["command"] = view.command;
  body["legend"] = schematic_html("schematic-legend", schematic_legend(640, "schematic-legend"));
  body["first_grasp"] = "held: " + to_text(report.options.grasps.front().grasp);
  body["schematics"] = Json::array();
  for (const FigureFile& file : figures) {
    body["schematics"].push_back(schematic_html(file.id, file.svg));
  }
  const std::size_t without = page_html(page(view, held, {}, body)).size();
  const DesignDetails details =
      design_details(in_order_of_details(report), view.solve,
                     without < page_bytes ? page_bytes - without : 0, report.options.threads);
  figures.push_back({pareto.id, pareto.svg});
  figures.push_back({parallel.id, parallel.svg});
  return {page_html(page(view, held, details, body)), std::move(figures)};
}

}  // namespace reeve
