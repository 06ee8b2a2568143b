#include <fmt/format.h>

#include <algorithm>

#include "pages/diagnosis_charts.hpp"
#include "pages/diagnosis_labels.hpp"
#include "reports/diagnosis_words.hpp"

namespace reeve {
namespace {

constexpr std::size_t most_models = 15;
constexpr std::size_t row_px = 26;

Json quantitative(const char* field, const std::string& title = "") {
  Json encoding{{"field", field}, {"type", "quantitative"}};
  if (!title.empty()) encoding["title"] = title;
  return encoding;
}

// In the order of the data.
Json rows_axis() {
  return {{"field", "name"},
          {"type", "nominal"},
          {"sort", nullptr},
          {"title", nullptr},
          {"axis",
           {{"labelExpr", "split(datum.label, ' + ')"},
            {"labelLimit", {{"expr", "containerSize()[0] < 600 ? 130 : 320"}}},
            {"grid", true}}}};
}

Json weighed_values(const DiagnosisResult& result) {
  Json values = Json::array();
  const std::vector<WeighedCause> models = by_training_gain(result.weighed);
  for (std::size_t i = 0; i < models.size() && i < most_models; ++i) {
    const WeighedCause& weighed = models[i];
    const std::string place = standing(result, weighed.name);
    Json datum{{"name", (place == "named" ? "◆ " : "") + weighed.name},
               {"standing", place},
               {"training", number(weighed.gain)}};
    if (weighed.held_out) {
      datum["gain"] = number(weighed.held_out->log_likelihood_gain);
      datum["low"] = number(weighed.held_out->gain_low);
      datum["high"] = number(weighed.held_out->gain_high);
    }
    values.push_back(std::move(datum));
  }
  return values;
}

// Shapes and colours keep their meaning, whichever of them a diagnosis has.
Json standing_encoding(const Json& values, bool shapes) {
  const Json known{"weighed", "named", "cannot be told from it", "not confirmed"};
  Json present = Json::array();
  for (const Json& one : known) {
    const bool met = std::any_of(values.begin(), values.end(),
                                 [&](const Json& datum) { return datum["standing"] == one; });
    if (met) present.push_back(one);
  }
  Json encoding{{"field", "standing"},
                {"type", "nominal"},
                {"title", nullptr},
                {"scale", {{"domain", known}}},
                {"legend", {{"orient", "bottom"}, {"columns", 2}, {"values", present}}}};
  if (shapes) encoding["scale"]["range"] = {"circle", "diamond", "square", "cross"};
  return encoding;
}

Json upright(const Json& values, const char* dash_of, const std::string& text) {
  Json layer{{"data", {{"values", values}}},
             {"mark", {{"type", "rule"}, {"strokeWidth", 1.5}, {"tooltip", text}}},
             {"encoding", {{"x", quantitative("x")}}}};
  if (std::string(dash_of) == "dashed") layer["mark"]["strokeDash"] = {6, 3};
  return layer;
}

Json at(double x) { return Json::array({{{"x", x}}}); }

// A line for what the noise allows, and the band in which noise puts it.
void add_noise_limit(const NoiseLimit& limit, Json& layers) {
  const Json band = Json::array({{{"x", limit.low}, {"to", limit.high}}});
  layers.push_back({{"data", {{"values", band}}},
                    {"mark", {{"type", "rect"}, {"opacity", 0.2}, {"color", "gray"}}},
                    {"encoding", {{"x", quantitative("x")}, {"x2", {{"field", "to"}}}}}});
  layers.push_back(upright(at(limit.log_likelihood_gain), "dashed", "as good as noise allows"));
  layers.push_back({{"data", {{"values", at(limit.log_likelihood_gain)}}},
                    {"mark",
                     {{"type", "text"},
                      {"text", "as good as noise allows"},
                      {"align", "right"},
                      {"dx", -4},
                      {"y", -8}}},
                    {"encoding", {{"x", quantitative("x")}}}});
}

std::string weighed_caption(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  std::string text = simulated_label(report);
  if (!result.noise_limit) {
    return text +
           "Gain on the runs that the models were fitted to, since none were held out: "
           "more parameters always gain something there.";
  }
  text +=
      "Each model was fitted to the training runs alone. Bars: 95 % intervals over resampled "
      "held-out ";
  text += result.held_out_runs < 5 ? "readings." : "runs.";
  text +=
      " The dashed line is what a model gains on average that leaves nothing but noise, the grey "
      "band where noise puts it in 95 % of data sets.";
  if (result.weighed.size() > most_models) {
    text += fmt::format(" Drawn are the best {} of {} on the training runs; the table has all.",
                        most_models, result.weighed.size());
  }
  return text;
}

}  // namespace

Figure weighed_figure(const DiagnosisReport& report) {
  const DiagnosisResult& result = report.result;
  const Json values = weighed_values(result);
  const bool held_out = result.noise_limit.has_value();
  const std::string title =
      fmt::format("gain in log-likelihood on {} runs", held_out ? "held-out" : "training");
  const char* field = held_out ? "gain" : "training";
  Json layers = Json::array({upright(at(0), "solid", "the model as it stands")});
  if (held_out) {
    add_noise_limit(*result.noise_limit, layers);
    layers.push_back(
        {{"mark", {{"type", "rule"}, {"strokeWidth", 2}}},
         {"encoding",
          {{"y", rows_axis()}, {"x", quantitative("low", title)}, {"x2", {{"field", "high"}}}}}});
  }
  Json tooltips =
      Json::array({{{"field", "name"}, {"title", "model"}},
                   {{"field", "training"}, {"type", "quantitative"}, {"format", ".4~g"}}});
  if (held_out) {
    for (const char* name : {"gain", "low", "high"}) {
      tooltips.push_back({{"field", name}, {"type", "quantitative"}, {"format", ".4~g"}});
    }
  }
  layers.push_back({{"mark", {{"type", "point"}, {"filled", true}, {"size", 130}, {"opacity", 1}}},
                    {"encoding",
                     {{"y", rows_axis()},
                      {"x", quantitative(field, title)},
                      {"color", standing_encoding(values, false)},
                      {"shape", standing_encoding(values, true)},
                      {"tooltip", tooltips}}}});
  Figure figure;
  figure.id = "weighed";
  figure.title = "The causes, weighed.";
  figure.caption = weighed_caption(report);
  figure.alt = fmt::format(
      "Gain in log-likelihood of {} models, best {}; the table below has the "
      "numbers.",
      values.size(), values.empty() ? Json("none") : values[0]["name"]);
  figure.spec = {{"data", {{"values", values}}},
                 {"width", "container"},
                 {"height", row_px * values.size()},
                 {"layer", layers}};
  return reeve::figure(std::move(figure));
}

}  // namespace reeve
