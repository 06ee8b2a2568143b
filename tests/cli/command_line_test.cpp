#include "cli/command_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/process.hpp"

namespace reeve::cli {
namespace {

struct Taken {
  std::vector<std::string> routings;
  std::vector<std::string> constraints;
  std::string hardware = "paper";
  int seed = 1;
  bool all = false;
};

void add_to(CLI::App& app, Taken& taken) {
  app.name("rank");
  app.add_option("--constraint", taken.constraints)->allow_extra_args(false);
  app.add_option("-w,--hardware", taken.hardware)->capture_default_str();
  app.add_option("--seed", taken.seed)->capture_default_str();
  app.add_flag("--all", taken.all);
  app.add_option("routings", taken.routings);
}

std::string line(std::vector<std::string> reversed, const std::vector<std::string>& left_out = {}) {
  CLI::App app;
  Taken taken;
  add_to(app, taken);
  app.parse(reversed);
  return command_line(app, left_out);
}

// What a program gets of it, last argument first.
std::vector<std::string> split_by_shell(const std::string& command) {
  const std::string script = "printf '%s\\n' " + command;
  std::istringstream lines(testing::run_process({"/bin/sh", "-c", script}).out);
  std::vector<std::string> words;
  for (std::string word; std::getline(lines, word);) words.push_back(word);
  std::reverse(words.begin(), words.end());
  return words;
}

TEST(CommandLine, NamesWhatWasGivenAndNothingElse) {
  EXPECT_EQ(line({}), "reeve rank");
  EXPECT_EQ(line({"TR7", "--all", "TR1"}), "reeve rank TR1 TR7 --all");
  EXPECT_EQ(line({"my glove.toml", "-w"}), "reeve rank --hardware 'my glove.toml'");
}

TEST(CommandLine, RepeatsAnOptionForEachOfItsValues) {
  EXPECT_EQ(line({"jams==0", "--constraint", "sheaths<=2", "--constraint"}),
            "reeve rank --constraint 'sheaths<=2' --constraint jams==0");
}

TEST(CommandLine, LeavesOutWhatTheResultsDoNotDependOn) {
  EXPECT_EQ(line({"5", "--seed", "--all"}, {"--seed"}), "reeve rank --all");
  EXPECT_EQ(line({"5", "--seed", "--all"}, {"--all"}), "reeve rank --seed 5");
}

// What reading it anew takes is what was taken the first time, whatever the values hold.
TEST(CommandLine, ReadsBackAsWhatItWasMadeFrom) {
  for (const std::string& value : std::vector<std::string>{"a b", "-1", "it's", "--all", "a=b"}) {
    CLI::App app;
    Taken taken;
    add_to(app, taken);
    app.parse(std::vector<std::string>{"--constraint=" + value, "--hardware=" + value, "TR1"});
    ASSERT_EQ(taken.hardware, value);
    CLI::App again;
    Taken taken_again;
    add_to(again, taken_again);
    std::vector<std::string> words = split_by_shell(command_line(app));
    words.resize(words.size() - 2);  // reeve rank
    again.parse(words);
    EXPECT_EQ(taken_again.constraints, taken.constraints) << command_line(app);
    EXPECT_EQ(taken_again.hardware, taken.hardware) << command_line(app);
    EXPECT_EQ(taken_again.routings, taken.routings) << command_line(app);
  }
}

// "--hardware=$file" with a name that is not set.
TEST(CommandLine, WithAnEmptyValueKeepsTheOptionBehindIt) {
  CLI::App app;
  Taken taken;
  add_to(app, taken);
  parse(app, {"--hardware=", "--all", "TR1", "--", "--seed="});
  EXPECT_EQ(taken.hardware, "");
  EXPECT_TRUE(taken.all);
  EXPECT_EQ(taken.routings, (std::vector<std::string>{"TR1", "--seed="}));
  EXPECT_EQ(taken.seed, 1);
}

TEST(GivenArguments, AreTakenAgainThoughAValueIsEmpty) {
  CLI::App app;
  Taken taken;
  add_to(app, taken);
  parse(app, {"--constraint", "a=b", "--hardware", "", "--all", "--seed", "7"});
  CLI::App again;
  Taken taken_again;
  add_to(again, taken_again);
  parse(again, given_arguments(app, {}));
  EXPECT_EQ(taken_again.constraints, taken.constraints);
  EXPECT_EQ(taken_again.hardware, "");
  EXPECT_TRUE(taken_again.all);
  EXPECT_EQ(taken_again.seed, 7);
}

TEST(GivenOptions, AreThoseThatAnotherCommandTakesToo) {
  CLI::App app;
  Taken taken;
  add_to(app, taken);
  app.parse(std::vector<std::string>{"7", "--seed", "x y", "-w"});
  EXPECT_EQ(given_options(app, {"--hardware", "--model"}), " --hardware 'x y'");
  EXPECT_EQ(given_options(app, {"--model"}), "");
}

}  // namespace
}  // namespace reeve::cli
