#include "reports/catalogue_report.hpp"

#include "core/notation.hpp"
#include "core/routing.hpp"
#include "reports/output/json.hpp"

namespace reeve::reports {

std::string sizes_text(const ListedMechanism& mechanism) {
  return joined(mechanism.sizes, ", ",
                [](const Routing& size) { return std::to_string(finger_count(size)); });
}

Document catalogue_sheet(const std::vector<ListedMechanism>& list) {
  Table table{
      {text_column("family"), text_column("name"), text_column("routing"), number_column("fingers"),
       text_column("like"), number_column("printed"), number_column("agree")},
      {}};
  for (const ListedMechanism& mechanism : list) {
    table.add({mechanism.family, mechanism.name, mechanism.word,
               std::to_string(finger_count(mechanism.routing)),
               mechanism.sizes.size() > 1 ? sizes_text(mechanism) : "",
               std::to_string(mechanism.printed), std::to_string(mechanism.agree)});
  }
  return {{{"",
            table,
            {{"like: numbers of fingers that reeve show --like NAME --fingers N accepts; printed: "
              "numbers that reeve check recomputes"}}}}};
}

std::string catalogue_json(const std::vector<ListedMechanism>& list) {
  Json json;
  json["mechanisms"] = list_json(list, [](const ListedMechanism& mechanism) {
    return Json{
        {"family", mechanism.family},
        {"name", mechanism.name},
        {"routing", mechanism.word},
        {"fingers", finger_count(mechanism.routing)},
        {"like",
         list_json(mechanism.sizes,
                   [](const Routing& size) {
                     return Json{{"fingers", finger_count(size)}, {"routing", to_word(size)}};
                   })},
        {"title", mechanism.title},
        {"source", mechanism.source},
        {"printed", mechanism.printed},
        {"agree", mechanism.agree}};
  });
  json["version"] = version_json();
  return print(json);
}

}  // namespace reeve::reports
