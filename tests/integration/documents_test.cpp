// What documents show is what the program does: the Python and Octave lines of docs/tables.md, run
// as they stand there on what `reeve explore` wrote, and the figures of docs/figures, drawn again.
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"

namespace reeve::testing {
namespace {

// One that has the modules, "" if there is none. Debian's own packages are for Debian's own Python,
// and another may stand before it.
std::string python_with(const std::string& modules) {
  for (const char* python : {"python3", "/usr/bin/python3"}) {
    if (run_process({python, "-c", "import " + modules}).exit_code == 0) return python;
  }
  return "";
}

ProcessResult run_python(const std::string& python, const std::string& script,
                         const TemporaryFolder& folder) {
  ProcessOptions options{.directory = folder.path(),
                         .environment = {{"PYTHONWARNINGS", "ignore"}, {"MPLBACKEND", "agg"}}};
  return run_process({python, "-c", script}, options);
}

struct WrittenTables {
  TemporaryFolder folder;
  std::string csv;
  Json summary;

  WrittenTables() {
    ProcessOptions options{.directory = folder.path()};
    EXPECT_EQ(reeve("explore", options).exit_code, 0);
    csv = read_text(folder.path() / "out/explore/designs.csv");
    summary = Json::parse(read_text(folder.path() / "out/explore/summary.json"));
  }

  std::size_t rows() const {
    return static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')) - 1;
  }
};

const std::string answers =
    "\nprint(json.dumps([len(designs), len(front), front['routing'].tolist(), "
    "list(designs.columns), known.loc['TR7', 'uniformity.mean'], summary['evaluated']]))\n";

// The routings of the front, the fewest sheaths first.
std::vector<std::string> sorted_front(const Json& summary) {
  std::vector<Json> front(summary["front"].begin(), summary["front"].end());
  std::stable_sort(front.begin(), front.end(),
                   [](const Json& a, const Json& b) { return a["sheaths"] < b["sheaths"]; });
  std::vector<std::string> routings;
  for (const Json& design : front) routings.push_back(design["routing"]);
  return routings;
}

void expect_what_was_written(const WrittenTables& written, const std::string& python,
                             const std::string& lines) {
  const ProcessResult result = run_python(python, lines + answers, written.folder);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const Json read = Json::parse(result.out);
  EXPECT_EQ(read[0], written.rows());
  EXPECT_EQ(read[1], written.summary["front"].size());
  EXPECT_EQ(read[2].get<std::vector<std::string>>(), sorted_front(written.summary));
  EXPECT_EQ(read[3][2], "routing");
  EXPECT_EQ(read[5], written.summary["evaluated"]);
  for (const Json& known : written.summary["known"]) {
    if (known["name"] == "TR7") {
      EXPECT_EQ(read[4], known["uniformity"]["mean"]);
    }
  }
}

TEST(PythonLines, ReadWhatAnExplorationWrites) {
  const std::string python = python_with("pandas");
  ASSERT_FALSE(python.empty()) << "this needs python3-pandas, which ./run test installs";
  const std::vector<std::string> blocks = blocks_of("tables.md", "python");
  ASSERT_EQ(blocks.size(), 2U);
  WrittenTables written;
  expect_what_was_written(written, python, blocks[0]);
  // As after Ctrl-C.
  written.folder.write("out/explore/designs.csv", "# partial: stopped, \"early\"\n" + written.csv);
  expect_what_was_written(written, python, blocks[0]);
  // matplotlib is four times as large as pandas, so nothing here asks for it.
  const std::string with_drawing = python_with("pandas, matplotlib");
  if (with_drawing.empty()) return;
  const ProcessResult drawing = run_python(with_drawing, blocks[0] + blocks[1], written.folder);
  EXPECT_EQ(drawing.exit_code, 0) << drawing.err;
  EXPECT_TRUE(read_text(written.folder.path() / "front.pdf").starts_with("%PDF"));
}

TEST(OctaveLines, ReadWhatAnExplorationWrites) {
  // Some hundred megabytes for one test: nothing of ours installs it. It runs where people have it.
  if (run_process({"octave-cli", "--version"}).exit_code != 0) {
    GTEST_SKIP() << "no octave-cli: the package octave has it";
  }
  const std::vector<std::string> blocks = blocks_of("tables.md", "matlab");
  ASSERT_EQ(blocks.size(), 2U);
  const WrittenTables written;
  ProcessOptions options{.directory = written.folder.path()};
  const ProcessResult result =
      run_process({"octave-cli", "--quiet", "--no-init-file", "--eval",
                   blocks[0] + "printf('%d %.17g\\n', numel(designs), max(uniformity));"
                               "printf('%s\\n', front.routing);"},
                  options);
  ASSERT_EQ(result.exit_code, 0) << result.err;
  double most = 0;
  for (const Json& design : written.summary["top"]) {
    most = std::max(most, design["uniformity"]["mean"].get<double>());
  }
  std::istringstream out(result.out);
  std::size_t designs = 0;
  double read = 0;
  out >> designs >> read;
  EXPECT_EQ(designs, written.rows());
  EXPECT_EQ(read, most);
  std::vector<std::string> front;
  for (std::string word; out >> word;) front.push_back(word);
  EXPECT_EQ(front, sorted_front(written.summary));
}

std::string in_documents(const std::string& figure) {
  return read_text(std::filesystem::path(REEVE_SOURCE_DIR) / "docs" / "figures" / figure);
}

// The commands stand beside each figure, in README.md, docs/pages.md and docs/uncertainty.md.
TEST(FiguresInDocuments, AreWhatTheirCommandsWrite) {
  const TemporaryFolder folder;
  const auto written = [&](std::vector<std::string> command, const std::string& file) {
    const ProcessResult result = reeve(std::move(command));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const std::string svg = read_text(folder.path() / file);
    return svg.substr(0, svg.rfind("<!-- "));  // its id hangs on the version
  };
  const std::string out = (folder.path() / "out").string();
  EXPECT_TRUE(written({"explore", "--fingers", "5", "--out", out}, "out/figures/pareto.svg") ==
              in_documents("pareto.svg"));
  EXPECT_TRUE(written({"rank", "--catalog", "--grasps", "paper", "--score", "authors", "--sweep",
                       "mu=0.02..0.3", "--uncertainty", "--out", out},
                      "out/figures/sweep-score.svg") == in_documents("sweep.svg"));
  EXPECT_TRUE(written({"rank", "--catalog", "--out", out}, "out/figures/figure-9.svg") ==
              in_documents("figure-9.svg"));
  const std::string readings = std::string(REEVE_SOURCE_DIR) + "/catalog/measured/exo_glove_ii.csv";
  EXPECT_TRUE(written({"diagnose", readings, "--out", out}, "out/figures/figure-9.svg") ==
              in_documents("seven-routings.svg"));
}

}  // namespace
}  // namespace reeve::testing
