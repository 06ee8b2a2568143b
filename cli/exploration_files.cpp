#include "cli/exploration_files.hpp"

#include <algorithm>
#include <string>

#include "cli/command_line.hpp"
#include "cli/supervision.hpp"
#include "pages/exploration/exploration_page.hpp"
#include "pages/shell/figure_files.hpp"
#include "reports/decision/ladder_report.hpp"
#include "reports/files.hpp"
#include "reports/results/design_list.hpp"
#include "reports/uncertainty/sweep_report.hpp"
#include "studies/shown_routing.hpp"

namespace reeve::cli {
namespace {

// Designs whose page takes long enough for somebody to wonder.
constexpr std::size_t long_list = 200;

ExplorationView view(const ExploreReport& report, const CLI::App& command,
                     const Catalogue& catalogue, std::optional<std::size_t> details) {
  const ExploreOptions& options = report.options;
  return {report, command_line(command, {"--threads", "--format", "--columns", "--text-width"}),
          given_options(command, {"--hardware", "--model"}),
          [&](const Routing& routing) {
            return shown_routing(routing, options.model, options.grasps, Direction::pull,
                                 catalogue);
          },
          details};
}

}  // namespace

void write_exploration(const ExploreReport& report, const CLI::App& command,
                       const Catalogue& catalogue, std::optional<std::size_t> details,
                       const std::filesystem::path& directory) {
  const std::string reason = partial_note(report);
  const std::string note = reason.empty() ? "" : "partial: " + reason;
  write_file(directory / "designs.csv", design_csv(report.top, note));
  write_file(directory / "pareto.csv", design_csv(report.front, note));
  write_file(directory / "sample.csv", sample_csv(report.result.sample, note));
  write_file(directory / "ladder.csv", ladder_csv(report.ladder, note));
  if (report.sweep) write_file(directory / "sweep.csv", sweep_csv(*report.sweep));
  StageLine stage;
  if (std::min(details.value_or(0), report.top.size()) >= long_list) stage.show("writing the page");
  const PageFiles page = exploration_page(view(report, command, catalogue, details));
  write_figures(directory, page.figures);
  write_file(directory / "index.html", page.html);
  write_file(directory / "summary.json", explore_summary_json(report));
}

}  // namespace reeve::cli
