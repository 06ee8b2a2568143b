#include <fmt/format.h>

#include "core/network.hpp"
#include "drawing/schematic/schematic_svg.hpp"
#include "pages/figures.hpp"
#include "pages/pages.hpp"
#include "pages/shell/page.hpp"
#include "pages/shell/template.hpp"
#include "reports/catalogue_report.hpp"

namespace reeve::pages {
namespace {

std::string numbers_text(const ListedMechanism& mechanism) {
  if (mechanism.printed == 0) return "none of its numbers is in print";
  const char* others = mechanism.agree < mechanism.printed ? "; reeve check says why not all" : "";
  return fmt::format("{} of {} printed numbers agree{}", mechanism.agree, mechanism.printed,
                     others);
}

Json mechanism_json(const ListedMechanism& mechanism, const std::string& svg) {
  const std::string sizes = mechanism.sizes.size() > 1 ? sizes_text(mechanism) : "";
  return {{"id", "mechanism-" + mechanism.name},
          {"name", mechanism.name},
          {"word", mechanism.word},
          {"title", mechanism.title},
          {"source", mechanism.source},
          {"numbers", numbers_text(mechanism)},
          {"sizes", sizes},
          {"svg", svg}};
}

}  // namespace

PageFiles catalogue_page(const std::vector<ListedMechanism>& list, const std::string& command) {
  PageFiles page;
  Json families = Json::array();
  std::vector<NamedRouting> named;
  for (const ListedMechanism& mechanism : list) named.push_back({mechanism.name, mechanism.word});
  const std::vector<std::string> stems = file_stems(named);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const ListedMechanism& mechanism = list[i];
    if (families.empty() || families.back()["family"] != mechanism.family) {
      families.push_back({{"family", mechanism.family}, {"mechanisms", Json::array()}});
    }
    const std::string svg = schematic_svg(schematic(expand(mechanism.routing), mechanism.name),
                                          "drawing-" + mechanism.name);
    families.back()["mechanisms"].push_back(mechanism_json(mechanism, svg));
    page.figures.push_back(
        {stems[i], svg,
         fmt::format("{}: {} {}\n", mechanism.name, mechanism.word, mechanism.title)});
  }
  const std::string body =
      render("catalogue.mustache",
             {{"count", list.size()}, {"families", std::move(families)}, {"command", command}});
  page.html = page_html({"Catalogue of routings", body, "", Json::object()});
  return page;
}

}  // namespace reeve::pages
