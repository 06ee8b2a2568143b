#include "pages/page.hpp"

#include <sstream>
#include <utility>

#include "core/version.hpp"
#include "pages/asset_table.hpp"
#include "pages/chart_engine.hpp"
#include "pages/template.hpp"
#include "reports/files.hpp"

namespace reeve {

Figure figure(Figure without_picture, const Json& static_spec) {
  without_picture.svg = chart_svg(static_spec, without_picture.id);
  return without_picture;
}

Figure figure(Figure without_picture) {
  const Json spec = without_picture.spec;
  return figure(std::move(without_picture), spec);
}

std::string figure_html(const Figure& figure) {
  return render("figure.mustache", {{"id", figure.id},
                                    {"title", figure.title},
                                    {"caption", figure.caption},
                                    {"alt", figure.alt},
                                    {"svg", figure.svg},
                                    {"spec", script_json(figure.spec)}});
}

std::string schematic_html(const std::string& id, const std::string& svg) {
  return render("schematic.mustache", {{"id", id}, {"svg", svg}});
}

namespace {

Json scripts(const std::string& names) {
  Json list = Json::array();
  std::istringstream in(names);
  for (std::string name; in >> name;) list.push_back(asset(name));
  return list;
}

}  // namespace

std::string page_html(const Page& page) {
  return render("page.mustache", {{"title", page.title},
                                  {"body", page.body},
                                  {"style", asset("page.css")},
                                  {"theme", script_json(Json::parse(asset("chart_theme.json")))},
                                  {"data", script_json(page.data)},
                                  {"license", asset("vega-license.txt")},
                                  {"vega", asset("vega.js")},
                                  {"vega_lite", asset("vega-lite.js")},
                                  {"common", asset("page.js")},
                                  {"scripts", scripts(page.script)},
                                  {"version", version_json()}});
}

}  // namespace reeve
