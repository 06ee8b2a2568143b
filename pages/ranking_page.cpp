#include <fmt/format.h>

#include <utility>

#include "core/text.hpp"
#include "pages/distribution_figure.hpp"
#include "pages/figures.hpp"
#include "pages/page_words.hpp"
#include "pages/pages.hpp"
#include "pages/ranking_parts.hpp"
#include "pages/routing_parts.hpp"
#include "pages/shell/glossary.hpp"
#include "pages/shell/settings.hpp"
#include "pages/shell/template.hpp"
#include "pages/sweep_figures.hpp"
#include "reports/exploration/band_report.hpp"
#include "reports/exploration/decision_words.hpp"
#include "reports/shown_value.hpp"
#include "search/evaluate/shown_objectives.hpp"

namespace reeve::pages {
namespace {

// The page draws so many of the best; more would make it unwieldy. The rest is in the JSON.
constexpr std::size_t most_drawn = 20;

std::vector<NamedRouting> named(const RankReport& report) {
  std::vector<NamedRouting> routings;
  for (const ListedDesign& design : report.designs) {
    routings.push_back({design.name, design.ranked.design.word});
  }
  return routings;
}

HtmlTable ranking_table(const RankReport& report, const Labels& labels) {
  Table table{
      {number_column("rank"), number_column("front"), text_column("routing"), text_column("word")},
      {}};
  const std::vector<Objective> shown = shown_objectives(report.order, report.score);
  const std::string unit = cost_unit(report.prices);
  for (const Objective objective : shown) {
    table.columns.push_back(number_column(objective_title(row(objective)),
                                          shown_unit(objective_unit(objective, unit))));
  }
  if (report.uncertainty) {
    for (const char* heading : {"first, %", "median rank", "rank, 5 %", "rank, 95 %"}) {
      table.columns.push_back(number_column(heading));
    }
  }
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const ListedDesign& design = report.designs[i];
    std::vector<std::string> cells{std::to_string(design.ranked.rank),
                                   std::to_string(design.ranked.front), labels[i],
                                   design.ranked.design.word};
    for (const Objective objective : shown) {
      cells.push_back(objective_text(objective, value(design.ranked.design.values, objective)));
    }
    if (design.distribution) {
      const RankDistribution& drawn = *design.distribution;
      cells.push_back(fixed(100 * drawn.first, 1));
      for (const double rank : {drawn.median, drawn.low, drawn.high}) {
        cells.push_back(fixed(rank, 0));
      }
    }
    table.add(std::move(cells));
  }
  return {"ranking-table", "Objectives; click a heading to sort", std::move(table), true};
}

std::vector<GlossaryTerm> ranking_glossary(const RankReport& report) {
  std::vector<GlossaryTerm> terms{ranking_terms().front()};
  append(terms, objective_terms(shown_objectives(report.order, report.score)));
  return terms;
}

HtmlTable margin_table(const RankReport& report, const Labels& labels) {
  Table table{{text_column("over"), number_column("lead"), number_column("least lead"),
               number_column("μ tube"), number_column("μ sheath"), number_column("μ bearing"),
               number_column("sheath angle", "rad")},
              {}};
  for (std::size_t i = 0; i < report.margins->size(); ++i) {
    const Margin& margin = (*report.margins)[i];
    table.add({labels[i + 1], fixed(margin.nominal_lead, 4), fixed(margin.least_lead, 4),
               fixed(margin.at.tube.mu), fixed(margin.at.sheath.mu), fixed(margin.at.bearing.mu, 5),
               fixed(margin.at.sheath.angle_rad, 2)});
  }
  return {"margins-table",
          "Lead of the first, in mean uniformity × mean efficiency, and the coefficients at "
          "which it is least; below 0 the order turns there",
          std::move(table), true};
}

// Table of the bands of all shown objectives that friction moves.
HtmlTable bands_table(const RankReport& report) {
  std::vector<Objective> objectives = shown_objectives(report.order, report.score);
  std::erase_if(objectives, [](Objective objective) { return !depends_on_friction(objective); });
  return {
      "bands-table",
      "Median, and in brackets 5 % to 95 % of the draws; designs that are equal in a draw share "
      "their place",
      band_table(report.designs, objectives), true};
}

std::string uncertainty_html(const UncertaintyOptions& options,
                             const std::vector<ListedDesign>& designs) {
  const UncertaintyRanges& ranges = options.ranges;
  const ContactScatter& scatter = options.nominal.hardware.scatter;
  const auto percent = [](double half_width) {
    return fmt::format("± {:.3g} %", 100 * half_width);
  };
  Table table{{text_column("quantity"), text_column("range")}, {}};
  const auto add_mu = [&](ContactKind kind, const char* parts, const MuRange& range) {
    if (!is_drawn(kind, options.nominal.hardware, designs)) return;
    table.add({std::string("friction coefficient of the ") + parts,
               fmt::format("{:g} to {:g}", range.low, range.high)});
  };
  add_mu(ContactKind::tube, "tubes", ranges.tube_mu);
  add_mu(ContactKind::sheath, "sheaths", ranges.sheath_mu);
  table.add({"friction coefficient of the bearings", percent(ranges.bearing_mu_relative)});
  table.add({"wrap angle of the sheaths", percent(ranges.sheath_angle_relative)});
  const auto deviation = [](double relative) { return fmt::format("σ {:.3g} %", 100 * relative); };
  table.add({"each tube's and sheath's own exponent", deviation(scatter.relative)});
  table.add({"each bearing's own exponent", deviation(scatter.bearing_relative)});
  table.add({"draws", std::to_string(options.draws)});
  table.add({"seed", std::to_string(options.seed)});
  return html({"ranges-table", "Ranges from which the coefficients were drawn", std::move(table)});
}

// The page as it grows: text, and the figures that also become files.
class RankingPageBuilder {
 public:
  RankingPageBuilder(const RankReport& report, const std::string& command)
      : report_(report),
        routings_(report.details->routings),
        labels_(labels(named(report))),
        stems_(file_stems(named(report))),
        command_(command) {}

  PageFiles build() {
    const std::string title =
        fmt::format("Ranking of {} routing{}", labels_.size(), labels_.size() == 1 ? "" : "s");
    Json values{{"title", title},
                {"answer", render("ranking_answer.mustache", ranking_answer(report_, labels_))},
                {"ranking", html(ranking_table(report_, labels_))},
                {"tradeoff", tradeoff_html(report_.tradeoff)},
                {"glossary", glossary_html("Front and the objectives: what they mean",
                                           ranking_glossary(report_))},
                {"pareto", add(pareto_figure(report_, labels_))},
                {"distributions", distributions()},
                {"most", routings_.size() > most_drawn ? std::to_string(most_drawn) : ""}};
    values["grasps"] = grasps();
    values["ranks"] =
        report_.uncertainty ? add(rank_figure(report_, labels_)) + html(bands_table(report_)) : "";
    values["sweep"] = sweep();
    values["margins"] =
        report_.margins && !report_.margins->empty() ? html(margin_table(report_, labels_)) : "";
    const std::string more =
        report_.uncertainty ? uncertainty_html(*report_.uncertainty, report_.designs) : "";
    values["settings"] =
        settings_html(report_.model, report_.unconverged, report_.grasps, command_, more);
    page_.html =
        page_html({title, render("ranking.mustache", values), "ranking.js", Json::object()});
    return std::move(page_);
  }

 private:
  std::string add(const Figure& figure) {
    page_.figures.push_back(captioned(figure, report_.model));
    return figure_html(figure);
  }

  // Their coefficients stand in their own captions.
  std::string distributions() {
    std::string html;
    for (const Figure& figure : distribution_figures(report_.details->distributions)) {
      page_.figures.push_back({figure.id, figure.svg, figure.title + " " + figure.caption + "\n"});
      html += figure_html(figure);
    }
    return html + distribution_notes(report_.details->distributions);
  }

  std::string sweep() {
    if (!report_.sweep) return "";
    const std::vector<Figure> figures = sweep_figures(*report_.sweep);
    for (const Figure& figure : figures) page_.figures.push_back({figure.id, figure.svg});
    return sweep_html(*report_.sweep, figures);
  }

  Json grasp(std::size_t index) {
    const Grasp held = routings_.front().grasps[index].grasp;
    std::string schematics;
    for (std::size_t i = 0; i < routings_.size() && i < most_drawn; ++i) {
      const ShownGrasp& shown = routings_[i].grasps[index];
      const std::string id =
          fmt::format("schematic-{}-{}", report_.designs[i].ranked.rank, grasp_id(held));
      const std::string file = schematic_name(stems_[i], held);
      schematics += schematic_html(id, routings_[i], shown, file);
      page_.figures.push_back(schematic_file(file, routings_[i], shown));
    }
    return {{"id", grasp_id(held)},
            {"words", grasp_words(held)},
            {"schematics", schematics},
            {"tensions", add(tensions_figure(routings_, labels_, index, most_drawn))}};
  }

  Json grasps() {
    Json list = Json::array();
    for (std::size_t i = 0; i < routings_.front().grasps.size(); ++i) list.push_back(grasp(i));
    return list;
  }

  const RankReport& report_;
  const std::vector<ShownRouting>& routings_;
  Labels labels_;
  std::vector<std::string> stems_;  // names of the schematics' files
  const std::string& command_;
  PageFiles page_;
};

}  // namespace

PageFiles ranking_page(const RankReport& report, const std::string& command) {
  return RankingPageBuilder(report, command).build();
}

}  // namespace reeve::pages
