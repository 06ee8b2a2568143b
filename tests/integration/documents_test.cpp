// Documents say what the program does: the Python and Octave lines of docs/tables.md, run as they
// stand there on what `reeve explore` wrote; the figures of docs/figures, drawn again; and links.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <iterator>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

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
  EXPECT_TRUE(written({"explore", "--fingers", "5", "--parts", "full", "--out", out},
                      "out/figures/pareto.svg") == in_documents("pareto.svg"));
  EXPECT_TRUE(written({"rank", "--catalogue", "--grasps", "paper", "--score", "authors", "--sweep",
                       "mu=0.02..0.3", "--uncertainty", "--out", out},
                      "out/figures/sweep-score.svg") == in_documents("sweep.svg"));
  EXPECT_TRUE(written({"rank", "--catalogue", "--out", out}, "out/figures/figure-9.svg") ==
              in_documents("figure-9.svg"));
  const std::string readings = std::string(REEVE_SOURCE_DIR) + "/catalog/measured/exo_glove_ii.csv";
  EXPECT_TRUE(written({"diagnose", readings, "--out", out}, "out/figures/figure-9.svg") ==
              in_documents("seven-routings.svg"));
}

namespace fs = std::filesystem;

// True for a byte that GitHub keeps of a heading in its anchor.
bool is_kept_in_anchor(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return std::isalnum(byte) != 0 || c == '-' || c == '_' || c == ' ' || byte >= 0x80;
}

// GitHub's anchor of a heading: lower case, punctuation left out, blanks as hyphens.
std::string anchor_of(const std::string& heading) {
  std::string anchor;
  for (const char c : heading) {
    if (!is_kept_in_anchor(c)) continue;
    anchor += c == ' ' ? '-' : static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::set<std::string> anchors_of(const fs::path& page) {
  std::set<std::string> anchors;
  std::istringstream in(read_text(page));
  for (std::string line; std::getline(in, line);) {
    const std::size_t level = line.find_first_not_of('#');
    if (level == 0 || level == std::string::npos || line[level] != ' ') continue;
    anchors.insert(anchor_of(line.substr(level + 1)));
  }
  return anchors;
}

std::vector<std::string> relative_links_of(const fs::path& page) {
  static const std::regex link(R"(\]\(([^)\s]+)\))");
  const std::string text = read_text(page);
  std::vector<std::string> links;
  for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at) {
    const std::string target = (*at)[1];
    if (target.find("://") == std::string::npos) links.push_back(target);
  }
  return links;
}

std::vector<fs::path> documents() {
  const fs::path root = REEVE_SOURCE_DIR;
  std::vector<fs::path> pages{root / "README.md", root / "CHANGELOG.md", root / "tests/README.md"};
  for (const auto& file : fs::directory_iterator(root / "docs")) {
    if (file.path().extension() == ".md") pages.push_back(file.path());
  }
  std::sort(pages.begin(), pages.end());
  return pages;
}

TEST(DocumentLinks, LeadToFilesAndHeadings) {
  int links = 0;
  for (const fs::path& page : documents()) {
    for (const std::string& link : relative_links_of(page)) {
      const std::size_t hash = link.find('#');
      const std::string file = link.substr(0, hash);
      const fs::path target = file.empty() ? page : page.parent_path() / file;
      ASSERT_TRUE(fs::exists(target)) << page << ": " << link;
      if (hash != std::string::npos) {
        EXPECT_TRUE(anchors_of(target).contains(link.substr(hash + 1))) << page << ": " << link;
      }
      ++links;
    }
  }
  EXPECT_GT(links, 100);
}

TEST(DocumentLinks, LeadFromTheIndexToEveryPage) {
  const fs::path index = fs::path(REEVE_SOURCE_DIR) / "docs" / "README.md";
  const std::vector<std::string> links = relative_links_of(index);
  for (const fs::path& page : documents()) {
    if (page.parent_path() != index.parent_path() || page == index) continue;
    EXPECT_NE(std::find(links.begin(), links.end(), page.filename().string()), links.end()) << page;
  }
}

std::size_t words_in(const fs::path& page) {
  std::istringstream in(read_text(page));
  return static_cast<std::size_t>(
      std::distance(std::istream_iterator<std::string>(in), std::istream_iterator<std::string>()));
}

TEST(DocumentLengths, StayWithinWhatAReaderReads) {
  const fs::path root = REEVE_SOURCE_DIR;
  EXPECT_LE(words_in(root / "README.md"), 1200U);
  EXPECT_LE(words_in(root / "CHANGELOG.md"), 300U);
  EXPECT_LE(words_in(root / "docs" / "performance.md"), 800U);
  EXPECT_LE(words_in(root / "docs" / "diagnosis.md"), 2500U);
  std::size_t all = 0;
  for (const fs::directory_entry& entry : fs::directory_iterator(root / "docs")) {
    if (entry.path().extension() == ".md") all += words_in(entry.path());
  }
  EXPECT_LE(all, 25000U);
}

TEST(TheCitation, AndTheChangelogAreOfThisVersion) {
  std::smatch version;
  const std::string told = reeve({"--version"}).out;
  ASSERT_TRUE(std::regex_search(told, version, std::regex(R"(\d+\.\d+\.\d+)")));
  const fs::path root = REEVE_SOURCE_DIR;
  EXPECT_TRUE(has(read_text(root / "CITATION.cff"), "\nversion: " + version.str() + "\n"));
  EXPECT_TRUE(std::regex_search(read_text(root / "CHANGELOG.md"),
                                std::regex("\n## " + version.str() + R"( \(\d{4}-\d\d-\d\d\))")));
}

}  // namespace
}  // namespace reeve::testing
