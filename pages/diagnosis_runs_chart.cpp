#include <fmt/format.h>

#include <algorithm>

#include "pages/diagnosis_charts.hpp"
#include "pages/diagnosis_labels.hpp"

namespace reeve {
namespace {

constexpr std::size_t most_runs = 40;

Json runs_axis() {
  return {{"field", "run"},
          {"type", "nominal"},
          {"sort", nullptr},
          {"title", "run"},
          {"axis", {{"labelLimit", 120}, {"grid", true}}}};
}

Json rms(const char* field) {
  return {{"field", field},
          {"type", "quantitative"},
          {"title", "root mean square residual, N"},
          {"scale", {{"zero", true}}}};
}

Json model_encoding(bool extended, bool shapes) {
  Json domain = Json::array({"before"});
  if (extended) domain.push_back("after");
  Json encoding{{"field", "model"},
                {"type", "nominal"},
                {"title", nullptr},
                {"scale", {{"domain", domain}}},
                {"legend", {{"orient", "bottom"}}}};
  if (shapes) encoding["scale"]["range"] = {"circle", "diamond"};
  return encoding;
}

Json tooltip() {
  return Json::array(
      {{{"field", "run"}, {"type", "nominal"}},
       {{"field", "model"}, {"type", "nominal"}},
       {{"field", "rms"}, {"title", "rms, N"}, {"type", "quantitative"}, {"format", ".3~g"}},
       {{"field", "noise"},
        {"title", "noise alone, N"},
        {"type", "quantitative"},
        {"format", ".3~g"}},
       {{"field", "values"}, {"title", "measured values"}, {"type", "quantitative"}}});
}

// One datum for each run and model, and all of the run beside it.
Json run_values(const DiagnosisReport& report, bool extended) {
  Json values = Json::array();
  const std::vector<RunGain>& gains = report.result.run_gains;
  for (std::size_t i = 0; i < gains.size() && i < most_runs; ++i) {
    Json datum{{"run", report.data.runs[gains[i].run]}, {"values", gains[i].cells},
               {"from", number(gains[i].rms_before_N)}, {"to", number(gains[i].rms_after_N)},
               {"noise", number(gains[i].rms_noise_N)}, {"model", "before"},
               {"rms", number(gains[i].rms_before_N)}};
    values.push_back(datum);
    if (!extended) continue;
    datum["model"] = "after";
    datum["rms"] = datum["to"];
    values.push_back(std::move(datum));
  }
  return values;
}

Json layers(bool extended) {
  const Json span{
      {"mark", {{"type", "rule"}, {"strokeWidth", 1.5}}},
      {"encoding", {{"y", runs_axis()}, {"x", rms("from")}, {"x2", {{"field", "to"}}}}}};
  const Json noise{{"mark",
                    {{"type", "tick"},
                     {"orient", "vertical"},
                     {"thickness", 3},
                     {"size", 20},
                     {"color", "gray"}}},
                   {"encoding", {{"y", runs_axis()}, {"x", rms("noise")}}}};
  const Json points{{"mark", {{"type", "point"}, {"filled", true}, {"size", 100}, {"opacity", 1}}},
                    {"encoding",
                     {{"y", runs_axis()},
                      {"x", rms("rms")},
                      {"color", model_encoding(extended, false)},
                      {"shape", model_encoding(extended, true)},
                      {"tooltip", tooltip()}}}};
  return Json::array({span, noise, points});
}

}  // namespace

Figure runs_figure(const DiagnosisReport& report) {
  const std::size_t runs = report.result.run_gains.size();
  const bool extended = !report.result.causes.empty();
  Figure figure;
  figure.id = "held-out-runs";
  figure.title = "Each held-out run by itself.";
  figure.caption = simulated_label(report) +
                   (extended ? "From the model as it stands to the extended one. " : "") +
                   "Grey ticks: what noise alone leaves on average.";
  if (runs > most_runs) {
    figure.caption +=
        fmt::format(" Drawn are the first {} of {} runs; diagnosis.json has all.", most_runs, runs);
  }
  figure.alt = fmt::format("Root mean square residuals of {} held-out runs{}, and of noise alone.",
                           runs, extended ? ", before and after" : "");
  figure.spec = {{"data", {{"values", run_values(report, extended)}}},
                 {"width", "container"},
                 {"height", 26 * std::min(runs, most_runs)},
                 {"layer", layers(extended)}};
  return reeve::figure(std::move(figure));
}

}  // namespace reeve
