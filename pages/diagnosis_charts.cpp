#include "pages/diagnosis_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "pages/diagnosis_labels.hpp"

namespace reeve {
namespace {

// In units of the noise: scales are linear up to here, and 95 % of noise lies within.
constexpr double linear_to = 2;
// Of the palette, readable on white and on black.
constexpr const char* mean_colour = "#d55e00";

Json axis(const char* field, const char* title, double greatest) {
  return {{"field", field},
          {"type", "quantitative"},
          {"title", title},
          {"scale", {{"domain", {0, greatest}}, {"nice", true}}}};
}

// Seven colours and seven shapes are seven pairs, seven and six are 42.
Json by_routing(const Json& marks, bool shapes) {
  std::set<std::string> routings;
  for (const Json& mark : marks) routings.insert(mark["routing"]);
  Json encoding{{"field", "routing"},
                {"type", "nominal"},
                {"legend",
                 {{"orient", "bottom"},
                  {"columns", {{"expr", "containerSize()[0] < 600 ? 2 : 4"}}},
                  {"symbolOpacity", 1}}},
                {"title", "routing"}};
  if (shapes && routings.size() > 7) {
    encoding["scale"] = {
        {"range", {"circle", "square", "triangle-up", "diamond", "cross", "triangle-down"}}};
  }
  return encoding;
}

Json tooltip() {
  Json list = Json::array();
  for (const char* name : {"line", "run", "routing", "grasp", "direction", "strand", "held_out"}) {
    const std::string field = name;
    list.push_back({{"field", field},
                    {"type", "nominal"},
                    {"title", field == "held_out" ? "run is"
                              : field == "grasp"  ? "held fingers"
                                                  : field}});
  }
  const std::pair<const char*, const char*> numbers[] = {{"load", "motor tension, N"},
                                                         {"measured", "measured, N"},
                                                         {"before", "before, N"},
                                                         {"after", "after, N"},
                                                         {"sd", "noise, N"}};
  for (const auto& [field, title] : numbers) {
    list.push_back(
        {{"field", field}, {"type", "quantitative"}, {"title", title}, {"format", ".4~g"}});
  }
  return list;
}

double greatest_tension(const Json& marks) {
  double greatest = 0;
  for (const Json& mark : marks) {
    for (const char* field : {"measured", "before", "after"}) {
      if (mark[field].is_number()) greatest = std::max(greatest, mark[field].get<double>());
    }
  }
  return greatest > 0 ? greatest : 1;
}

Json diagonal(double greatest) {
  Json ends = Json::array();
  for (const double t : {0.0, 2 * greatest}) ends.push_back({{"x", t}, {"y", t}});
  return {{"data", {{"values", ends}}},
          {"mark",
           {{"type", "line"},
            {"strokeDash", {6, 4}},
            {"strokeWidth", 1.5},
            {"color", "gray"},
            {"clip", true}}},
          {"encoding",
           {{"x", {{"field", "x"}, {"type", "quantitative"}}},
            {"y", {{"field", "y"}, {"type", "quantitative"}}}}}};
}

Json compared_panel(const Json& marks, const char* field, const char* title) {
  const double greatest = greatest_tension(marks);
  const Json colour = by_routing(marks, false);
  const Json filled{{"field", "held_out"},
                    {"type", "ordinal"},
                    {"title", "runs"},
                    {"scale", {{"domain", {"training", "held out"}}, {"range", {0, 0.9}}}},
                    {"legend",
                     {{"orient", "bottom"},
                      {"symbolType", "circle"},
                      {"symbolFillColor", "gray"},
                      {"symbolStrokeColor", "gray"}}}};
  const Json points{{"mark", {{"type", "point"}, {"size", 34}, {"strokeWidth", 1.2}}},
                    {"encoding",
                     {{"x", axis(field, "predicted, N", greatest)},
                      {"y", axis("measured", "measured, N", greatest)},
                      {"stroke", colour},
                      {"fill", colour},
                      {"shape", by_routing(marks, true)},
                      {"fillOpacity", filled},
                      {"tooltip", tooltip()}}}};
  return {{"title", title},
          {"width", 270},
          {"height", 270},
          {"layer", Json::array({diagonal(greatest), points})}};
}

Json residual_axis() {
  return {{"field", "residual"},
          {"type", "quantitative"},
          {"title", "residual, sd of noise"},
          {"scale", {{"type", "symlog"}, {"constant", linear_to}}},
          {"axis",
           {{"values", {-1000, -100, -30, -10, -3, 0, 3, 10, 30, 100, 1000}},
            {"format", "d"},
            {"labelOverlap", "greedy"},
            {"labelExpr", "(datum.value > 0 ? '+' : '') + datum.label"}}}};
}

Json noise_band() {
  Json ends = Json::array();
  ends.push_back({{"low", -linear_to}, {"high", linear_to}});
  return {{"data", {{"values", ends}}},
          {"mark", {{"type", "rect"}, {"opacity", 0.15}, {"color", "gray"}}},
          {"encoding",
           {{"y", {{"field", "low"}, {"type", "quantitative"}}}, {"y2", {{"field", "high"}}}}}};
}

Json along(const MarkColumn& column) {
  Json encoding{{"field", column.field},
                {"type", column.categories ? "nominal" : "quantitative"},
                {"title", nullptr}};
  if (column.categories) {
    encoding["axis"] = {{"labelAngle", -90}, {"labelLimit", 90}, {"labelFontSize", 10}};
  } else {
    encoding["scale"] = {{"zero", false}};
    encoding["axis"] = {{"tickCount", 3}};
  }
  return encoding;
}

// Mean, and as far as a standard deviation to both sides, of each category or bin.
Json means(const MarkColumn& column) {
  Json transform = Json::array();
  std::string field = column.field;
  if (!column.categories) {
    field = "bin";
    transform.push_back(
        {{"bin", {{"maxbins", 8}}}, {"field", column.field}, {"as", {"bin_low", "bin_high"}}});
    transform.push_back({{"calculate", "(datum.bin_low + datum.bin_high) / 2"}, {"as", field}});
  }
  transform.push_back(
      {{"aggregate", Json::array({{{"op", "mean"}, {"field", "residual"}, {"as", "mean"}},
                                  {{"op", "stdev"}, {"field", "residual"}, {"as", "spread"}}})},
       {"groupby", {"model", field}}});
  transform.push_back({{"calculate", "datum.mean - (datum.spread || 0)"}, {"as", "low"}});
  transform.push_back({{"calculate", "datum.mean + (datum.spread || 0)"}, {"as", "high"}});
  Json x = along(column);
  x["field"] = field;
  Json mean = residual_axis();
  mean["field"] = "mean";
  Json low = mean;
  low["field"] = "low";
  const Json spread{{"mark", {{"type", "rule"}, {"strokeWidth", 2}, {"color", mean_colour}}},
                    {"encoding", {{"x", x}, {"y", low}, {"y2", {{"field", "high"}}}}}};
  const Json point{{"mark",
                    {{"type", "point"},
                     {"shape", "diamond"},
                     {"filled", true},
                     {"size", 60},
                     {"color", mean_colour},
                     {"opacity", 1}}},
                   {"encoding", {{"x", x}, {"y", mean}}}};
  return {{"transform", transform}, {"layer", Json::array({spread, point})}};
}

}  // namespace

Figure compared_figure(const DiagnosisReport& report, const Json& marks) {
  const bool extended = !report.result.causes.empty();
  Json panels = Json::array({compared_panel(
      marks, "before", extended ? "before: the model as it stands" : "the model as it stands")});
  if (extended) panels.push_back(compared_panel(marks, "after", "after: the extended model"));
  Figure figure;
  figure.id = "compared";
  figure.title = "Measured against predicted tension.";
  figure.caption = simulated_label(report) +
                   "Each point is one sensor in one reading; on the dashed line both agree." +
                   (report.result.held_out_runs == 0
                        ? ""
                        : " Hollow points were fitted to, filled ones are of runs that no fit has "
                          "seen.") +
                   thinned_text(report, marks);
  figure.alt = compared_alt(report);
  figure.spec = {{"data", {{"values", marks}}},
                 {"usermeta", {{"columns", panels.size()}, {"greatest_px", 420}}},
                 {"columns", panels.size()},
                 {"spacing", 24},
                 {"concat", panels}};
  return reeve::figure(std::move(figure));
}

Figure residual_figure(const DiagnosisReport& report, const Json& marks, const MarkColumn& column) {
  const bool extended = !report.result.causes.empty();
  std::vector<std::string> fields{"residual_before", "residual_after", "line", "run",
                                  "strand",          "routing",        "grasp"};
  if (std::find(fields.begin(), fields.end(), column.field) == fields.end()) {
    fields.push_back(column.field);
  }
  const Json points{
      {"mark", {{"type", "point"}, {"filled", true}, {"size", 12}, {"opacity", 0.45}}},
      {"encoding",
       {{"x", along(column)},
        {"y", residual_axis()},
        {"tooltip",
         Json::array({{{"field", "line"}},
                      {{"field", "run"}},
                      {{"field", "routing"}},
                      {{"field", "strand"}},
                      {{"field", "residual"}, {"type", "quantitative"}, {"format", ".3~g"}}})}}}};
  const Json layers = Json::array({noise_band(), points, means(column)});
  Figure figure;
  figure.id = column.id;
  figure.title = fmt::format("By {}.", column.title);
  figure.caption = simulated_label(report);
  figure.alt = fmt::format(
      "Residuals in standard deviations of the noise over {}{}; in grey what 95 % of noise "
      "does.",
      column.title, extended ? ", before and after the model is extended" : "");
  Json before_after = Json::array({"residual_before"});
  if (extended) before_after.push_back("residual_after");
  figure.spec = {
      {"title", {{"text", fmt::format("by {}", column.title)}, {"limit", 330}}},
      {"data", {{"values", fields_of(marks, fields)}}},
      {"transform", Json::array({{{"fold", before_after}, {"as", {"model", "residual"}}}})},
      {"facet",
       {{"column",
         {{"field", "model"},
          {"sort", before_after},
          {"title", nullptr},
          {"header",
           {{"labelExpr",
             extended ? "datum.value == 'residual_before' ? 'before' : 'after'" : "''"}}}}}}},
      {"spacing", 10},
      {"spec", {{"width", extended ? 126 : 260}, {"height", 150}, {"layer", layers}}}};
  return reeve::figure(std::move(figure));
}

std::string thinned_text(const DiagnosisReport& report, const Json& marks) {
  const std::size_t all = report.result.cells.size();
  if (marks.size() == all) return "";
  return fmt::format(
      " Drawn are {} of {} values, chosen evenly by a fixed rule; residuals.csv has "
      "all.",
      marks.size(), all);
}

}  // namespace reeve
