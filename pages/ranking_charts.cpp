#include "pages/ranking_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "pages/objective_title.hpp"
#include "pages/routing_parts.hpp"
#include "pages/tension_charts.hpp"
#include "reports/text_table.hpp"

namespace reeve {
namespace {

// Beyond this only the front's points have their names beside them.
constexpr std::size_t most_labels = 12;
constexpr std::size_t most_names = 3;

using Axes = std::pair<Objective, Objective>;

Axes axes(const std::vector<Objective>& objectives) {
  if (objectives.size() > 1) return {objectives[0], objectives[1]};
  const Objective first = objectives.front();
  return {first, first == Objective::uniformity_mean ? Objective::efficiency_mean
                                                     : Objective::uniformity_mean};
}

// Designs that lie on one point.
struct Point {
  double x = 0;
  double y = 0;
  bool on_front = false;
  std::vector<std::string> names;
};

std::vector<Point> points(const RankReport& report, const Labels& labels, const Axes& axes) {
  std::vector<Point> result;
  for (std::size_t i = 0; i < report.designs.size(); ++i) {
    const RankedDesign& ranked = report.designs[i].ranked;
    const double x = value(ranked.design.values, axes.first);
    const double y = value(ranked.design.values, axes.second);
    auto found = std::find_if(result.begin(), result.end(), [&](const Point& point) {
      return fixed(point.x) == fixed(x) && fixed(point.y) == fixed(y);
    });
    if (found == result.end()) found = result.insert(found, {x, y, false, {}});
    found->on_front = found->on_front || ranked.front == 1;
    found->names.push_back(labels[i]);
  }
  return result;
}

std::string shortened(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < most_names; ++i) {
    text += (i == 0 ? "" : ", ") + names[i];
  }
  if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
  return text;
}

Json axis(const char* field, Objective objective) {
  const ObjectiveRow& about = row(objective);
  return {{"field", field},
          {"type", "quantitative"},
          {"title", fmt::format("{} ({} is better)", objective_title(about),
                                about.better == Better::higher ? "higher" : "lower")},
          {"scale", {{"zero", false}, {"padding", 18}}}};
}

Json point_layer() {
  const Json front{{"field", "front"}, {"type", "nominal"}, {"title", nullptr}};
  const Json domain{{"domain", {"on the Pareto front", "dominated"}}};
  Json encoding{{"color", front}, {"shape", front}};
  encoding["color"]["scale"] = domain;
  encoding["shape"]["scale"] = domain;
  encoding["color"]["legend"] = {{"orient", "top"}};
  encoding["shape"]["legend"] = {{"orient", "top"}};
  return {{"mark",
           {{"type", "point"},
            {"filled", true},
            {"size", 80},
            {"opacity", 1},
            {"tooltip", {{"content", "data"}}}}},
          {"encoding", encoding}};
}

Json label_layer() {
  return {
      {"mark",
       {{"type", "text"}, {"align", "left"}, {"baseline", "middle"}, {"dx", 9}, {"fontSize", 12}}},
      {"encoding", {{"text", {{"field", "label"}}}}}};
}

std::string rank_alt(const RankReport& report, const Labels& labels) {
  std::string text = "Range of each routing's rank over the draws.";
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const RankDistribution& drawn = *report.designs[i].distribution;
    text += fmt::format(" {}: median {}, {} to {}.", labels[i], fixed(drawn.median, 0),
                        fixed(drawn.low, 0), fixed(drawn.high, 0));
  }
  return text;
}

}  // namespace

Figure pareto_figure(const RankReport& report, const Labels& labels) {
  const Axes on = axes(report.order.objectives);
  const bool all_named = labels.size() <= most_labels;
  Json values = Json::array();
  std::string alt = fmt::format("{} against {}.", objective_title(row(on.second)),
                                objective_title(row(on.first)));
  for (const Point& point : points(report, labels, on)) {
    const std::string names = shortened(point.names);
    values.push_back({{"routings", names},
                      {"label", all_named || point.on_front ? names : ""},
                      {"front", point.on_front ? "on the Pareto front" : "dominated"},
                      {"x", number(point.x)},
                      {"y", number(point.y)}});
    alt += fmt::format(" {}: {}, {}.", names, fixed(point.x), fixed(point.y));
  }
  std::string caption = "Routings on one point share its label.";
  if (!all_named) caption += " Only those on the Pareto front are labelled.";
  if (report.order.objectives.size() > 2) {
    caption += " The front is over " + objective_titles(report.order.objectives) +
               "; the first two of them are drawn.";
  }
  const Json spec{{"width", "container"},
                  {"height", 340},
                  {"data", {{"values", values}}},
                  {"encoding", {{"x", axis("x", on.first)}, {"y", axis("y", on.second)}}},
                  {"layer", {point_layer(), label_layer()}}};
  return figure({"pareto", "The routings over two objectives.", caption, alt, spec, ""});
}

Figure rank_figure(const RankReport& report, const Labels& labels) {
  Json values = Json::array();
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const RankDistribution& drawn = *report.designs[i].distribution;
    values.push_back({{"routing", labels[i]},
                      {"first share", drawn.first},
                      {"median", drawn.median},
                      {"p5", drawn.low},
                      {"p95", drawn.high}});
  }
  const Json last = labels.size();
  const Json x{{"field", "p5"},
               {"type", "quantitative"},
               {"title", "rank"},
               {"axis", {{"tickMinStep", 1}, {"format", "d"}}},
               {"scale", {{"domain", {1, last}}, {"padding", 10}}}};
  Json median = x;
  median["field"] = "median";
  const Json y{{"field", "routing"},
               {"type", "nominal"},
               {"sort", labels},
               {"title", nullptr},
               {"axis", {{"labelLimit", 120}}}};
  const Json mark_tooltip{{"content", "data"}};
  const Json range{{"mark", {{"type", "rule"}, {"strokeWidth", 4}, {"tooltip", mark_tooltip}}},
                   {"encoding", {{"x", x}, {"x2", {{"field", "p95"}}}, {"y", y}}}};
  const Json point{{"mark",
                    {{"type", "point"},
                     {"filled", true},
                     {"size", 90},
                     {"opacity", 1},
                     {"tooltip", mark_tooltip}}},
                   {"encoding", {{"x", median}, {"y", y}}}};
  const Json spec{{"width", "container"},
                  {"height", 24 * labels.size()},
                  {"data", {{"values", values}}},
                  {"layer", {range, point}}};
  return figure({"ranks", "Rank where the coefficients are drawn from their ranges.",
                 "Point: median; line: 5 % to 95 % of the draws.", rank_alt(report, labels), spec,
                 ""});
}

Figure tensions_figure(const std::vector<ShowReport>& routings, const Labels& labels,
                       std::size_t grasp, std::size_t most) {
  std::vector<TensionPanel> panels;
  const Grasp held = routings.front().grasps[grasp].grasp;
  std::string alt = "Bars of strand tensions, " + grasp_words(held) + ".";
  for (std::size_t i = 0; i < routings.size() && i < most; ++i) {
    const TensionState& state = routings[i].grasps[grasp].state;
    panels.push_back({labels[i], &routings[i].network, &state});
    alt += " " + labels[i] + ":";
    for (const auto& [segment, tension] : strands(routings[i].network, state)) {
      alt += " " + name(segment) + " " + fixed(tension);
    }
    alt += ".";
  }
  return figure({"tensions-" + grasp_id(held), "Strand tensions, " + grasp_words(held) + ".",
                 "At a motor tension of 1; colours tell the fingers apart.", alt,
                 tension_spec(panels), ""});
}

}  // namespace reeve
