// The commands of README and docs run as they stand there, and print the lines below them. A line
// of "…" stands for lines that the page leaves out. A command with --out leaves a page there.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/integration/explored.hpp"
#include "tests/support/rig_log.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

struct DocumentedCommand {
  std::string command;
  std::vector<std::string> lines;  // of what it prints, in order
};

// True if the words behind "./run" are a subcommand of the program, and not one of the script.
bool is_subcommand(const std::string& words) {
  static const std::set<std::string> of_the_script{"test", "python", "package"};
  return !of_the_script.contains(words.substr(0, words.find(' ')));
}

// Reads blocks of code: "./run …", over several lines with a backslash, then what it prints.
std::vector<DocumentedCommand> documented_commands(const fs::path& page) {
  std::istringstream in(read_text(page));
  std::vector<DocumentedCommand> commands;
  bool goes_on = false;
  bool in_command = false;
  for (std::string line; std::getline(in, line);) {
    if (!line.starts_with("    ")) {
      in_command = in_command && line.empty();
      continue;
    }
    line.erase(0, 4);
    if (goes_on) {
      commands.back().command += " " + line;
    } else if (line.starts_with("./run ")) {
      in_command = is_subcommand(line.substr(6));
      if (!in_command) continue;
      commands.push_back({line.substr(6, line.find("   #") - 6), {}});
    } else {
      if (in_command && line != "…") commands.back().lines.push_back(line);
      continue;
    }
    std::string& command = commands.back().command;
    goes_on = command.ends_with("\\");
    if (goes_on) command.pop_back();
  }
  return commands;
}

// Runs the command by a shell, which reads quotes as the reader's does.
ProcessResult run_documented(const std::string& command, const fs::path& folder) {
  ProcessOptions options{.directory = folder};
  return run_process({"/bin/sh", "-c", reeve_path() + " " + command}, options);
}

void expect_documented(const DocumentedCommand& documented, const fs::path& folder) {
  SCOPED_TRACE(documented.command);
  const ProcessResult result = run_documented(documented.command, folder);
  // Exit status 1 means that the answer is no.
  EXPECT_LE(result.exit_code, documented.lines.empty() ? 0 : 1) << result.err;
  const std::string out = "\n" + result.out;
  std::size_t at = 0;
  for (const std::string& line : documented.lines) {
    const std::size_t found = out.find("\n" + line + "\n", at);
    EXPECT_NE(found, std::string::npos) << line << "\n\n" << result.out;
    if (found != std::string::npos) at = found + line.size() + 1;
  }
}

void expect_page_in_out_folder(const std::string& command, const fs::path& folder) {
  const std::size_t option = command.find("--out ");
  if (option == std::string::npos) return;
  std::string out;
  std::istringstream(command.substr(option + 6)) >> out;
  EXPECT_TRUE(fs::exists(folder / out / "index.html")) << command;
}

// A log for the page that imports the reader's own.
void write_log(const fs::path& file) {
  RigRun run;
  run.strands = {{0.9, 0.9}, {0.7, 0.7}, {0.6, 0.6}, {0.5, 0.5}};
  const std::vector<RigRun> runs{run};
  std::ofstream(file) << rig_csv(rig_log({}, runs), runs);
}

class DocumentedCommands : public ::testing::TestWithParam<const char*> {};

TEST_P(DocumentedCommands, RunAsTheyStandOnThePage) {
  const TemporaryFolder folder;
  const fs::path source = REEVE_SOURCE_DIR;
  fs::create_directory_symlink(source / "catalog", folder.path() / "catalog");
  fs::create_directory(folder.path() / "out");
  write_log(folder.path() / "rig.csv");
  const std::vector<DocumentedCommand> commands = documented_commands(source / GetParam());
  ASSERT_FALSE(commands.empty());
  for (const DocumentedCommand& documented : commands) {
    expect_documented(documented, folder.path());
    expect_page_in_out_folder(documented.command, folder.path());
  }
}

INSTANTIATE_TEST_SUITE_P(Of, DocumentedCommands,
                         ::testing::Values("README.md", "docs/catalogue.md", "docs/constraints.md",
                                           "docs/data.md", "docs/decision.md", "docs/diagnosis.md",
                                           "docs/glove.md", "docs/hand.md", "docs/logger.md",
                                           "docs/mujoco.md", "docs/pages.md", "docs/projects.md",
                                           "docs/simulate.md", "docs/sizing.md", "docs/store.md",
                                           "docs/tables.md", "docs/tr7.md", "docs/uncertainty.md"),
                         [](const auto& page) {
                           const std::string name = fs::path(page.param).stem().string();
                           return name == "README" ? std::string("readme") : name;
                         });

// Returns the first block of code that begins with this line.
std::string block_of_code(const fs::path& page, const std::string& first) {
  std::istringstream in(read_text(page));
  std::string block;
  for (std::string line; std::getline(in, line);) {
    const bool is_code = line.starts_with("    ");
    if (block.empty() ? line == "    " + first : is_code) {
      block += line + "\n";
    } else if (!block.empty()) {
      break;
    }
  }
  return block;
}

TEST(DocumentedScripts, ExploresShardsAndMergesThem) {
  const TemporaryFolder folder;
  const std::string script =
      block_of_code(fs::path(REEVE_SOURCE_DIR) / "docs" / "scale.md", "for i in 1 2 3 4; do");
  const std::string program = fs::path(reeve_path()).parent_path().string();
  ProcessOptions options{.directory = folder.path()};
  const ProcessResult result = run_process(
      {"/bin/sh", "-c", "PATH=" + program + ":$PATH\nmkdir shards out\n" + script}, options);
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_TRUE(fs::exists(folder.path() / "out" / "seven" / "index.html"));
}

}  // namespace
}  // namespace reeve::testing
