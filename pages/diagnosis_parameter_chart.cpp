#include <fmt/format.h>

#include "pages/diagnosis_charts.hpp"
#include "pages/diagnosis_labels.hpp"

namespace reeve {
namespace {

Json position(const char* field, const std::string& title) {
  return {
      {"field", field}, {"type", "quantitative"}, {"title", title}, {"scale", {{"zero", false}}}};
}

Json row(const char* name) { return {{"datum", name}, {"type", "nominal"}}; }

Json one(const Json& datum, const Json& mark, const Json& encoding) {
  return {{"data", {{"values", Json::array({datum})}}}, {"mark", mark}, {"encoding", encoding}};
}

Json y(const char* name) {
  Json encoding = row(name);
  encoding["title"] = nullptr;
  encoding["sort"] = {"estimate", "nominal", "literature"};
  return encoding;
}

Json panel(const NamedCause& cause, const EstimatedParameter& parameter) {
  const std::string title = parameter.unit == "1"
                                ? parameter.name
                                : fmt::format("{}, {}", parameter.name, parameter.unit);
  Json layers = Json::array();
  layers.push_back(
      one({{"x", number(parameter.low)}, {"to", number(parameter.high)}},
          {{"type", "rule"}, {"strokeWidth", 3}},
          {{"x", position("x", title)}, {"x2", {{"field", "to"}}}, {"y", y("estimate")}}));
  layers.push_back(one(
      {{"x", number(parameter.value)}},
      {{"type", "point"}, {"shape", "diamond"}, {"filled", true}, {"size", 110}, {"opacity", 1}},
      {{"x", position("x", title)}, {"y", y("estimate")}}));
  if (parameter.nominal) {
    layers.push_back(one({{"x", number(*parameter.nominal)}},
                         {{"type", "point"}, {"shape", "circle"}, {"size", 90}, {"strokeWidth", 2}},
                         {{"x", position("x", title)}, {"y", y("nominal")}}));
  }
  if (parameter.literature) {
    layers.push_back(
        one({{"x", parameter.literature->low}, {"to", parameter.literature->high}},
            {{"type", "bar"}, {"height", 10}, {"opacity", 0.45}, {"color", "gray"}},
            {{"x", position("x", title)}, {"x2", {{"field", "to"}}}, {"y", y("literature")}}));
  }
  return {{"title", cause.name}, {"width", 250}, {"height", {{"step", 24}}}, {"layer", layers}};
}

}  // namespace

Figure parameters_figure(const DiagnosisReport& report) {
  Json panels = Json::array();
  std::string alt = "Estimates with 95 % intervals:";
  for (const NamedCause& cause : report.result.causes) {
    for (const EstimatedParameter& parameter : cause.parameters) {
      panels.push_back(panel(cause, parameter));
      alt += fmt::format(" {} of {} {:.4g} ({:.4g} to {:.4g});", parameter.name, cause.name,
                         parameter.value, parameter.low, parameter.high);
    }
  }
  Figure figure;
  figure.id = "parameters";
  figure.title = "Sizes of the causes.";
  figure.caption =
      simulated_label(report) +
      "Diamond with bar: estimate and its 95 % interval. Circle: the nominal value, at "
      "which nothing would be wrong. Grey: the literature's range.";
  figure.alt = alt;
  figure.spec = {{"usermeta", {{"columns", 2}, {"greatest_px", 400}}},
                 {"columns", 2},
                 {"spacing", 24},
                 {"concat", panels}};
  return reeve::figure(std::move(figure));
}

}  // namespace reeve
