#include "pages/distribution_figure.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "pages/routing_parts.hpp"
#include "pages/template.hpp"
#include "pages/tension_charts.hpp"
#include "reports/data_text.hpp"
#include "reports/text_table.hpp"

namespace reeve {
namespace {

constexpr const char* model = "model";
constexpr const char* published = "published";

using Rows = std::vector<const TensionDistribution*>;

std::string measured(const TensionDistributions& all) {
  return all.data && all.data->simulated ? "simulated data" : "measured";
}

bool any(const Rows& rows, bool (*of)(const StrandShare&)) {
  for (const TensionDistribution* row : rows) {
    for (const RoutingShares& routing : row->routings) {
      if (std::any_of(routing.strands.begin(), routing.strands.end(), of)) return true;
    }
  }
  return false;
}

bool is_published(const StrandShare& strand) { return strand.published.has_value(); }
bool is_measured(const StrandShare& strand) { return strand.measured.has_value(); }
bool is_faulty(const StrandShare& strand) {
  return strand.published && !strand.published->fault.empty();
}

std::vector<std::string> headings(const TensionDistribution& row) {
  std::vector<NamedRouting> routings;
  for (const RoutingShares& routing : row.routings)
    routings.push_back({routing.name, routing.word});
  return labels(routings);
}

void add_values(Json& values, const std::string& panel, const RoutingShares& routing,
                const std::string& measured) {
  for (const StrandShare& strand : routing.strands) {
    const Json place{{"panel", panel}, {"strand", strand.strand}};
    const auto add = [&](const std::string& source, double share) -> Json& {
      values.push_back(place);
      values.back()["source"] = source;
      values.back()["share"] = number(share);
      return values.back();
    };
    add(model, strand.model);
    if (strand.published) {
      Json& bar = add(published, strand.published->share);
      bar["printed in"] = routing.published_source;
      bar["at fault"] = is_faulty(strand);
    }
    if (!strand.measured) continue;
    Json& bar = add(measured, strand.measured->mean);
    bar["readings"] = routing.readings;
    if (!strand.measured->deviation) continue;
    bar["low"] = strand.measured->mean - *strand.measured->deviation;
    bar["high"] = strand.measured->mean + *strand.measured->deviation;
  }
}

// What all layers of a panel share. The sources take the categorical colours in a fixed order, and
// bars of theirs differ in opacity too, for readers and printers without colours.
class Layers {
 public:
  Layers(const Rows& rows, const std::string& measured) : measured_(measured) {
    if (any(rows, is_published)) bars_.push_back(published);
    if (any(rows, is_measured)) bars_.push_back(measured);
    domain_ = {model, published, measured};
  }

  Json all() const {
    Json layers = Json::array();
    if (!bars_.empty()) layers.push_back(bars());
    layers.push_back(line());
    if (bars_.size() == 2 || (bars_.size() == 1 && bars_[0] == measured_)) {
      layers.push_back(error_bars());
    }
    return layers;
  }

 private:
  Json x() const {
    return {{"field", "strand"},
            {"type", "nominal"},
            {"sort", nullptr},
            {"title", nullptr},
            {"axis", {{"labelAngle", 0}, {"labelOverlap", true}, {"grid", false}}}};
  }

  Json y(const char* field) const {
    return {{"field", field},
            {"type", "quantitative"},
            {"title", "share of the sum"},
            {"axis", {{"format", "%"}, {"tickCount", 5}}}};
  }

  void put_beside_each_other(Json& encoding) const {
    if (bars_.size() < 2) return;
    encoding["xOffset"] = {{"field", "source"}, {"scale", {{"domain", bars_}}}};
  }

  static Json only(const std::string& condition) { return Json::array({{{"filter", condition}}}); }

  static Json legend(const Json& values) {
    return {
        {"title", nullptr}, {"orient", "bottom"}, {"direction", "vertical"}, {"values", values}};
  }

  Json bars() const {
    Json encoding{{"x", x()}, {"y", y("share")}};
    put_beside_each_other(encoding);
    const std::string light = fmt::format("=== '{}' ? 0.2 : 0.5", published);
    encoding["fill"] = {{"field", "source"}, {"type", "nominal"}, {"scale", {{"domain", domain_}}}};
    encoding["fill"]["legend"] = legend(bars_);
    encoding["fill"]["legend"]["symbolStrokeWidth"] = 1.2;
    encoding["fill"]["legend"]["encode"] = {
        {"symbols", {{"update", {{"fillOpacity", {{"signal", "datum.value " + light}}}}}}}};
    encoding["stroke"] = encoding["fill"];
    encoding["fillOpacity"] = {
        {"condition", {{"test", fmt::format("datum.source === '{}'", published)}, {"value", 0.2}}},
        {"value", 0.5}};
    encoding["strokeDash"] = {{"condition", {{"test", "datum['at fault']"}, {"value", {3, 2}}}},
                              {"value", {1, 0}}};
    return {{"transform", only("datum.source !== 'model'")},
            {"mark", {{"type", "bar"}, {"strokeWidth", 1.2}, {"tooltip", {{"content", "data"}}}}},
            {"encoding", encoding}};
  }

  Json line() const {
    Json encoding{{"x", x()}, {"y", y("share")}};
    encoding["color"] = {{"datum", model}, {"type", "nominal"}, {"scale", {{"domain", domain_}}}};
    encoding["color"]["legend"] = legend(Json::array({model}));
    encoding["color"]["legend"]["symbolType"] = "circle";
    return {{"transform", only("datum.source === 'model'")},
            {"mark",
             {{"type", "line"},
              {"strokeWidth", 2},
              {"point", {{"filled", true}, {"size", 55}}},
              {"tooltip", {{"content", "data"}}}}},
            {"encoding", encoding}};
  }

  Json error_bars() const {
    Json encoding{{"x", x()}, {"y", y("low")}, {"y2", {{"field", "high"}}}};
    put_beside_each_other(encoding);
    return {{"transform", only("isValid(datum.low)")},
            {"mark", {{"type", "rule"}, {"strokeWidth", 1.2}}},
            {"encoding", encoding}};
  }

  std::string measured_;
  Json bars_ = Json::array();
  Json domain_;
};

std::string row_title(std::size_t row, double mu) {
  return fmt::format("({}) μ of tubes and sheaths {:g}", static_cast<char>('a' + row), mu);
}

Json row_spec(const TensionDistribution& row, const std::string& title, const Layers& layers,
              const std::string& measured) {
  Json values = Json::array();
  const std::vector<std::string> panels = headings(row);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    add_values(values, panels[i], row.routings[i], measured);
  }
  const double width = panel_width(row.routings.front().strands.size());
  Json spec{{"title", {{"text", title}, {"anchor", "start"}}}, {"data", {{"values", values}}}};
  spec["facet"] = {{"field", "panel"},
                   {"type", "nominal"},
                   {"sort", panels},
                   {"title", nullptr},
                   {"header", {{"labelLimit", width}, {"labelPadding", 4}}}};
  spec["spec"] = {{"width", width}, {"height", 150}, {"layer", layers.all()}};
  return in_rows(spec, width, panels.size());
}

Json spec(const Rows& rows, const std::string& measured) {
  const Layers layers(rows, measured);
  Json concat = Json::array();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    concat.push_back(row_spec(*rows[i], row_title(i, rows[i]->mu), layers, measured));
  }
  return {{"vconcat", concat}, {"spacing", 10}, {"resolve", {{"scale", {{"y", "shared"}}}}}};
}

std::string alt(const Rows& rows) {
  std::string text = "Strand tensions as shares of their sum.";
  for (std::size_t i = 0; i < rows.size(); ++i) {
    text += " " + row_title(i, rows[i]->mu) + ", model:";
    for (const RoutingShares& routing : rows[i]->routings) {
      text += " " + (routing.name.empty() ? routing.word : routing.name);
      for (const StrandShare& strand : routing.strands) {
        text += " " + fixed(100 * strand.model, 0);
      }
      text += " %;";
    }
  }
  return text;
}

std::string caption(const Rows& rows, const TensionDistributions& all) {
  std::string text = "With " + grasp_words(rows.front()->grasp) +
                     ", pulling; the strands of each routing add up to 100 %. Line and circles: "
                     "the model.";
  if (any(rows, is_published)) {
    text +=
        " Light bars: what is printed of the routing, the same in every row, since it is printed "
        "for one set of coefficients.";
  }
  if (any(rows, is_faulty))
    text +=
        " Dashed: printed values that the check does not find, mostly for a fault of the source.";
  if (any(rows, is_measured)) {
    text += all.data->simulated ? " Dark bars: simulated data, of no rig" : " Dark bars: measured";
    text += ", mean of the readings ± their standard deviation.";
    for (std::size_t i = 0; i < rows.size(); ++i) {
      if (!rows[i]->rms_measured) continue;
      text += fmt::format(" In ({}) model and data differ by {} points of share (rms).",
                          static_cast<char>('a' + i), fixed(100 * *rows[i]->rms_measured, 1));
    }
  }
  return text;
}

std::vector<Rows> by_grasp(const TensionDistributions& all) {
  std::vector<Rows> groups;
  for (const TensionDistribution& distribution : all.list) {
    if (groups.empty() || !(groups.back().front()->grasp == distribution.grasp)) {
      groups.emplace_back();
    }
    groups.back().push_back(&distribution);
  }
  return groups;
}

}  // namespace

std::vector<Figure> distribution_figures(const TensionDistributions& distributions) {
  std::vector<Figure> figures;
  for (const Rows& rows : by_grasp(distributions)) {
    const std::string id =
        figures.empty() ? "figure-9" : "figure-9-" + grasp_id(rows.front()->grasp);
    figures.push_back(
        figure({id, "Tension distributions, " + grasp_words(rows.front()->grasp) + ".",
                caption(rows, distributions), alt(rows), spec(rows, measured(distributions)), ""}));
  }
  return figures;
}

std::string distribution_notes(const TensionDistributions& distributions) {
  Json faults = Json::array();
  Json sources = Json::array();
  std::set<std::string> said;
  for (const TensionDistribution& distribution : distributions.list) {
    for (const RoutingShares& routing : distribution.routings) {
      if (routing.published_source.empty() || !said.insert(routing.word).second) continue;
      sources.push_back({{"text", routing.name + ": " + routing.published_source}});
      for (const StrandShare& strand : routing.strands) {
        if (!is_faulty(strand)) continue;
        faults.push_back(
            {{"where", routing.name + ", " + routing.published_source + ", " + strand.strand},
             {"why", strand.published->fault}});
      }
    }
  }
  Json values{{"sources", sources}, {"faults", faults}, {"file", ""}, {"notes", Json::array()}};
  values["has_sources"] = !sources.empty();
  values["simulated"] = false;
  if (distributions.data) {
    values["file"] = distributions.data->file;
    values["simulated"] = distributions.data->simulated;
    for (const SheetLine& line : notes_section(distributions.data->notes).lines) {
      values["notes"].push_back({{"text", line.text}});
    }
  }
  return render("distribution_notes.mustache", values);
}

}  // namespace reeve
