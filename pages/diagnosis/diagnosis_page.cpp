#include "pages/diagnosis/diagnosis_page.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pages/diagnosis/diagnosis_figures.hpp"
#include "pages/diagnosis/diagnosis_values.hpp"
#include "pages/distribution_figure.hpp"
#include "pages/shell/html_table.hpp"
#include "pages/shell/template.hpp"
#include "reports/data_text.hpp"
#include "reports/diagnosis/diagnosis_evidence.hpp"
#include "reports/diagnosis/diagnosis_words.hpp"
#include "reports/show_report.hpp"

namespace reeve::pages {
namespace {

// A page of some megabytes opens anywhere: so many marks in the main chart, and in each small one.
constexpr std::size_t most_compared = 1500;
constexpr std::size_t most_residuals = 500;
// Greatest number of rows in the stretches' table; diagnosis.json has all.
constexpr std::size_t most_stretches = 200;
// Greatest number of grasps whose tension distributions are drawn.
constexpr std::size_t most_grasps = 4;

// Keeps what is drawn, for the files beside the page.
class Figures {
 public:
  std::string add(const Figure& figure) {
    files_.push_back({figure.id, figure.svg});
    return figure_html(figure);
  }
  std::string add_schematic(const std::string& id, const std::string& svg) {
    files_.push_back({id, svg});
    return schematic_html(id, svg);
  }
  std::vector<FigureFile> files() && { return std::move(files_); }

 private:
  std::vector<FigureFile> files_;
};

Json residual_figures(const DiagnosisReport& report, const MarkColumns& columns,
                      const std::vector<ReadingMark>& drawn, Figures& figures) {
  return list_json(columns.shown, [&](const MarkColumn& column) {
    return Json{{"html", figures.add(residual_figure(report, drawn, column))}};
  });
}

// Adds one figure for each named term that some reading depends on.
Json partial_figures(const DiagnosisReport& report, Figures& figures) {
  Json list = Json::array();
  const std::vector<NamedCause>& causes = report.result.causes;
  for (std::size_t i = 0; i < causes.size(); ++i) {
    if (!causes[i].partial) continue;
    const std::string id = fmt::format("partial-{}", i + 1);
    list.push_back(
        {{"html", figures.add(partial_figure(report, id, causes[i].name, *causes[i].partial))}});
  }
  return list.empty() ? Json(nullptr) : Json{{"figures", std::move(list)}};
}

Json lead_figures(const DiagnosisReport& report, Figures& figures) {
  Json list = Json::array();
  const std::vector<Lead>& leads = report.result.leads;
  for (std::size_t i = 0; i < leads.size(); ++i) {
    if (!leads[i].partial) continue;
    list.push_back({{"html", figures.add(partial_figure(report, fmt::format("lead-{}", i + 1),
                                                        capitalised(lead_text(leads[i])),
                                                        *leads[i].partial))}});
  }
  if (leads.empty()) return nullptr;
  return {{"sentence", leads_sentence(report)}, {"figures", std::move(list)}};
}

// The tensions are for one newton at the motor, as everywhere in schematics.
std::string schematic_of(const SolvedRouting& next, const DiagnosisReport& report,
                         Figures& figures) {
  const std::string svg = show_svg(next, &next.grasps.front(), "next");
  return figures.add_schematic("next-measurement", svg) +
         render("diagnosis_schematic.mustache", {{"simulated", report.data.simulated}});
}

Json ranking_values(const std::optional<CatalogueRanking>& ranking) {
  if (!ranking) return nullptr;
  return {{"changes", ranking->changes()}, {"table", ranking_table(*ranking)}};
}

void add_evidence_figures(const DiagnosisReport& report, Json& values, Figures& figures) {
  const DiagnosisResult& result = report.result;
  const bool sizes = std::ranges::any_of(
      result.causes, [](const NamedCause& cause) { return !cause.parameters.empty(); });
  values["parameters_figure"] = sizes ? figures.add(parameters_figure(report)) : "";
  values["weighed_figure"] = result.weighed.empty() ? "" : figures.add(weighed_figure(report));
  values["runs_figure"] = result.run_gains.empty() ? "" : figures.add(runs_figure(report));
}

Json sentences(const std::vector<std::string>& list) {
  return list_json(list, [](const std::string& sentence) { return Json{{"text", sentence}}; });
}

// Takes away what is beyond so many grasps, and says how many grasps that were. They come grasp by
// grasp.
std::size_t cut_to_grasps(std::vector<TensionDistribution>& list, std::size_t most) {
  std::size_t grasps = 0;
  std::size_t kept = list.size();
  for (std::size_t i = 0; i < list.size(); ++i) {
    if (i > 0 && list[i].grasp == list[i - 1].grasp) continue;
    if (grasps++ == most) kept = i;
  }
  list.resize(kept);
  return grasps - std::min(grasps, most);
}

// Returns the notes on the data that the page does not have elsewhere.
std::string own_notes(TensionDistributions distributions, const std::vector<DataNote>& said) {
  if (!distributions.data) return distribution_notes(distributions);
  SharedData& data = *distributions.data;
  data.file.clear();
  std::erase_if(data.notes, [&](const DataNote& note) {
    return std::ranges::any_of(said, [&](const DataNote& other) {
      return other.text == note.text && other.lines == note.lines;
    });
  });
  return distribution_notes(distributions);
}

Json distribution_values(const DiagnosisPageInput& input, Figures& figures) {
  const DiagnosisReport& report = input.report;
  Json list = Json::array();
  std::size_t not_drawn = 0;
  std::string notes;
  if (input.distributions) {
    TensionDistributions drawn = *input.distributions;
    not_drawn = cut_to_grasps(drawn.list, most_grasps);
    for (const Figure& figure : distribution_figures(drawn)) {
      list.push_back({{"html", figures.add(figure)}});
    }
    notes = own_notes(std::move(drawn), report.result.notes);
  }
  Table errors = share_error_table(report);
  if (list.empty() && errors.rows.empty()) return nullptr;
  std::string table;
  if (!errors.rows.empty()) {
    table = html({"share-errors",
                  "Root of the summed squared differences of the shares, measured and forecast",
                  std::move(errors)});
  }
  return {{"figures", list},
          {"not_drawn", not_drawn == 0 ? Json(nullptr) : Json(plural(not_drawn, "more grasp"))},
          {"notes", notes},
          {"table", table},
          {"published", sentences(published_sentences(report))}};
}

Json loss_values(const DiagnosisReport& report) {
  Table table = loss_table(report);
  if (table.rows.empty()) return nullptr;
  const std::size_t all = table.rows.size();
  table.rows.resize(std::min(all, most_stretches));
  return {{"table", html({"losses",
                          "Tension ratio from one sensor to the next, where all contacts between "
                          "them slide",
                          std::move(table), true})},
          {"more", all > most_stretches ? Json(all - most_stretches) : Json(nullptr)},
          {"apart", sentences(loss_sentences(report))}};
}

}  // namespace

PageFiles diagnosis_page(const DiagnosisPageInput& input) {
  const DiagnosisReport& report = input.report;
  const MarkColumns columns = mark_columns(report);
  const std::vector<ReadingMark> few = marks(report, most_residuals);
  const std::vector<ReadingMark> many = marks(report, most_compared);
  Figures figures;
  Json values;
  values["answer"] = answer_values(report);
  values["data"] = data_values(input);
  values["distribution"] = distribution_values(input, figures);
  values["losses"] = loss_values(report);
  values["compared"] = figures.add(compared_figure(report, many));
  values["compared_logarithmic"] = figures.add(compared_logarithmic_figure(report, many));
  values["residuals"] = residual_figures(report, columns, few, figures);
  values["partial"] = partial_figures(report, figures);
  values["leads"] = lead_figures(report, figures);
  values["structure"] = structure_values(report, columns);
  values["structure"]["thinned"] = thinned_text(report, few.size());
  values["causes"] = cause_values(report);
  values["causes"]["influence"] = sentences(influence_sentences(report));
  add_evidence_figures(report, values, figures);
  values["separation"] = report.result.separating_measurement.has_value();
  values["next"] = next_values(report);
  values["schematic"] =
      input.next && !input.next->grasps.empty() ? schematic_of(*input.next, report, figures) : "";
  values["ranking"] = ranking_values(report.ranking);
  Page page;
  page.title = fmt::format("Diagnosis of {}{}", report.data.file,
                           report.data.simulated ? " (simulated)" : "");
  page.body = render("diagnosis.mustache", values);
  page.data = Json::object();
  return {page_html(page), std::move(figures).files()};
}

}  // namespace reeve::pages
