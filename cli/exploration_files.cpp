#include "cli/exploration_files.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "cli/command_line.hpp"
#include "cli/supervision.hpp"
#include "pages/exploration/exploration_page.hpp"
#include "pages/shell/figure_files.hpp"
#include "reports/decision/ladder_report.hpp"
#include "reports/exploration/exploration_id.hpp"
#include "reports/exploration/shard_file.hpp"
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
  return {report,
          command_line(command, {"--threads", "--format", "--columns", "--text-width", "--store",
                                 "--store-every", "--keep"}),
          given_options(command, {"--hardware", "--model"}),
          [&](const Routing& routing) {
            return shown_routing(routing, options.model, options.grasps, Direction::pull,
                                 catalogue);
          },
          details};
}

}  // namespace

std::vector<std::string> explore_arguments(const CLI::App& command) {
  return given_arguments(
      command, {"--shard", "--out", "--threads", "--format", "--store", "--store-every", "--keep"});
}

std::vector<std::string> exploration_files() {
  return {"designs.csv", "pareto.csv", "sample.csv", "ladder.csv",
          "sweep.csv",   "shard.json", "index.html", "summary.json"};
}

void write_exploration(const ExploreReport& report, const CLI::App& command,
                       const Catalogue& catalogue, std::optional<std::size_t> details,
                       const std::filesystem::path& directory) {
  const std::string reason = partial_note(report);
  const std::string note = reason.empty() ? "" : "partial: " + reason;
  const std::string id = exploration_id(report);
  std::vector<std::pair<std::string, std::string>> tables{
      {"designs.csv", stamped_csv(design_csv(report.top, note), id)},
      {"pareto.csv", stamped_csv(design_csv(report.front, note), id)},
      {"sample.csv", stamped_csv(sample_csv(report.result.sample, note), id)},
      {"ladder.csv", stamped_csv(ladder_csv(report.ladder, note), id)}};
  if (report.sweep) {
    tables.emplace_back("sweep.csv", stamped_csv(sweep_csv(*report.sweep), id));
  }
  StageLine stage;
  if (std::min(details.value_or(0), report.top.size()) >= long_list) stage.show("writing the page");
  PageFiles page = exploration_page(view(report, command, catalogue, details));
  for (FigureFile& figure : page.figures) figure.svg = stamped_markup(figure.svg, id);
  std::vector<std::pair<std::string, std::string>> others;
  others.emplace_back("index.html", stamped_markup(page.html, id));
  if (report.result.record) {
    others.emplace_back("shard.json", shard_json(report, explore_arguments(command)));
  }
  others.emplace_back("summary.json", explore_summary_json(report));
  // All is made by now: what runs out of memory leaves no temporary file.
  FileBatch files;
  // From here to the end a folder without it is half done.
  files.remove(directory / "summary.json");
  for (const char* of_other_options : {"shard.json", "sweep.csv"}) {
    files.remove(directory / of_other_options);
  }
  for (const auto& [name, content] : tables) files.add(directory / name, content);
  add_figures(files, directory, page.figures);
  for (const auto& [name, content] : others) files.add(directory / name, content);
  files.commit();
}

}  // namespace reeve::cli
