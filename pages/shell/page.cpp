#include "pages/shell/page.hpp"

#include <sstream>

#include "pages/shell/asset_table.hpp"
#include "pages/shell/template.hpp"

namespace reeve::pages {
namespace {

Json values(const Figure& figure) {
  return {
      {"id", figure.id}, {"title", figure.title}, {"caption", figure.caption}, {"svg", figure.svg}};
}

}  // namespace

std::string figure_html(const Figure& figure) { return render("figure.mustache", values(figure)); }

std::string live_figure_html(const LiveFigure& live) {
  Json all = values(live.figure);
  all["alt"] = live.alt;
  return render("live_figure.mustache", all);
}

std::string schematic_html(const std::string& id, const std::string& svg, const std::string& file) {
  return render("schematic.mustache", {{"id", id}, {"svg", svg}, {"file", file}});
}

namespace {

// False in a program that was built with REEVE_PAGES=OFF.
bool has_chart_library() { return asset_table().contains("vega.js"); }

Json scripts(const std::string& names) {
  Json list = Json::array();
  std::istringstream in(names);
  in.exceptions(std::ios::badbit);  // no memory is no end of the text
  for (std::string name; in >> name;) list.push_back(asset(name));
  return list;
}

}  // namespace

std::string page_html(const Page& page) {
  Json values{{"title", page.title},        {"body", page.body},
              {"style", asset("page.css")}, {"data", script_json(page.data)},
              {"common", asset("page.js")}, {"scripts", Json::array()},
              {"version", version_json()},  {"live", false},
              {"wide", page.live},          {"static_build", page.live && !has_chart_library()}};
  if (!page.live || has_chart_library()) values["scripts"] = scripts(page.script);
  if (page.live && has_chart_library()) {
    values["live"] = {{"theme", script_json(Json::parse(asset("theme.json")))},
                      {"license", asset("vega-license.txt")},
                      {"vega", asset("vega.js")},
                      {"vega_lite", asset("vega-lite.js")},
                      {"charts", asset("live_charts.js")}};
  }
  return render("page.mustache", values);
}

}  // namespace reeve::pages
