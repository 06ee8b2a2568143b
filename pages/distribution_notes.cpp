#include <set>

#include "pages/distribution_figure.hpp"
#include "pages/shell/template.hpp"
#include "reports/data_text.hpp"
#include "reports/output/json.hpp"

namespace reeve::pages {

std::string distribution_notes(const TensionDistributions& distributions) {
  Json faults = Json::array();
  Json sources = Json::array();
  std::set<std::string> said;
  for (const TensionDistribution& distribution : distributions.list) {
    for (const RoutingShares& routing : distribution.routings) {
      if (routing.published_source.empty() ||
          !said.insert(routing.word + " " + routing.published_source).second) {
        continue;
      }
      sources.push_back({{"text", routing.name + ": " + routing.published_source}});
      for (const StrandShare& strand : routing.strands) {
        if (!strand.published || strand.published->fault.empty()) continue;
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
    for (const DocumentLine& line : notes_section(distributions.data->notes).lines) {
      values["notes"].push_back({{"text", line.text}});
    }
  }
  return render("distribution_notes.mustache", values);
}

}  // namespace reeve::pages
