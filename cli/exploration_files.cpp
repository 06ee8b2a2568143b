#include "cli/exploration_files.hpp"

#include <algorithm>
#include <utility>

#include "cli/command_line.hpp"
#include "cli/supervision.hpp"
#include "pages/exploration/exploration_page.hpp"
#include "pages/shell/result_files.hpp"
#include "reports/exploration/design_list.hpp"
#include "reports/exploration/shard_file.hpp"
#include "reports/exploration/sweep_report.hpp"
#include "reports/exploration/tradeoff_report.hpp"
#include "reports/output/stamp.hpp"
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
            return solved_routing(routing, options.model, options.grasps, Direction::pull,
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
  return {"designs.csv", "pareto.csv", "sample.csv", "tradeoff.csv",
          "sweep.csv",   "shard.json", "index.html", "summary.json"};
}

void write_exploration(const ExploreReport& report, const CLI::App& command,
                       const Catalogue& catalogue, std::optional<std::size_t> details,
                       const std::filesystem::path& directory) {
  const std::string reason = partial_note(report);
  const std::string note = reason.empty() ? "" : "partial: " + reason;
  StatusLine stage;
  if (std::min(details.value_or(0), report.top.size()) >= long_list) stage.show("writing the page");
  PageFiles page = exploration_page(view(report, command, catalogue, details));
  ResultFiles result;
  result.tables = {{"designs.csv", design_csv(report.top, note)},
                   {"pareto.csv", design_csv(report.front, note)},
                   {"sample.csv", sample_csv(report.result.sample, note)},
                   {"tradeoff.csv", tradeoff_csv(report.tradeoff, note)}};
  if (report.sweep) result.tables.push_back({"sweep.csv", sweep_csv(*report.sweep)});
  result.figures = std::move(page.figures);
  result.texts.push_back({"index.html", std::move(page.html)});
  if (report.result.record) {
    result.texts.push_back({"shard.json", shard_json(report, explore_arguments(command))});
  }
  result.texts.push_back({"summary.json", explore_summary_json(report)});
  write_result(directory, std::move(result), {exploration_kind, exploration_id(report)});
}

}  // namespace reeve::cli
