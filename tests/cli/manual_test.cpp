#include "cli/manual.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/has.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::cli {
namespace {

using testing::has;

const SubcommandText* find(const std::vector<SubcommandText>& texts, const std::string& name) {
  const auto found = std::find_if(texts.begin(), texts.end(),
                                  [&](const SubcommandText& text) { return text.name == name; });
  return found == texts.end() ? nullptr : &*found;
}

// The help is CLI11's own list of them.
TEST(SubcommandTexts, AreAllOfTheHelp) {
  const std::string help = testing::reeve("--help").out;
  const std::vector<SubcommandText> texts = subcommand_texts();
  EXPECT_EQ(texts.size(), 13U);
  for (const SubcommandText& text : texts) {
    EXPECT_TRUE(has(help, "\n  " + text.name + " ")) << text.name;
    EXPECT_FALSE(text.options.empty()) << text.name;
  }
  ASSERT_NE(find(texts, "export"), nullptr);
}

TEST(SubcommandTexts, AreOneLineOfAtMostAHundredCharactersForEachOption) {
  for (const SubcommandText& subcommand : subcommand_texts()) {
    for (const OptionText& option : subcommand.options) {
      SCOPED_TRACE(subcommand.name + " --" + option.name);
      EXPECT_LE(option.meaning.size(), 100U) << option.meaning;
      EXPECT_FALSE(has(option.meaning, "\n"));
    }
  }
}

TEST(SubcommandTexts, KnowTheValuesThatAnOptionTakesAlone) {
  const std::vector<SubcommandText> texts = subcommand_texts();
  for (const OptionText& option : find(texts, "explore")->options) {
    if (option.name != "parts") continue;
    std::vector<std::string> choices = option.choices;
    std::sort(choices.begin(), choices.end());
    EXPECT_EQ(choices, (std::vector<std::string>{"all", "field", "full", "paper"}));
  }
  const auto& options = find(texts, "import")->options;
  const auto output = std::find_if(options.begin(), options.end(),
                                   [](const OptionText& text) { return text.name == "output"; });
  ASSERT_NE(output, options.end());
  EXPECT_EQ(output->short_name, "o");
  EXPECT_TRUE(options.front().positional);
}

TEST(ManPage, TakesNoTextForARequest) {
  const SubcommandText odd{"odd",
                           "First.\n.sh is no request, \\n no newline",
                           {{"a-b", "-1", "'quoted' first", "float"}}};
  const std::string page = man_page({odd}, "1.2.3");
  EXPECT_TRUE(has(page, "\"reeve 1.2.3\""));
  EXPECT_TRUE(has(page, "First.\n\\&.sh is no request, \\en no newline.\n"));
  EXPECT_TRUE(has(page, "\\fB\\-\\-a\\-b\\fR \\fINUMBER\\fR\n\\&'quoted' first. Default: \\-1.\n"));
}

TEST(OptionsDocument, IsWhatTheProgramWrites) {
  EXPECT_EQ(options_document(subcommand_texts()),
            testing::read_text(REEVE_SOURCE_DIR "/docs/options.md"))
      << "write it anew with reeve_write_manual --options";
}

TEST(OptionsDocument, ListsAnOptionOnceForAllThatTakeIt) {
  const OptionText common{"all", "3", "How many", "int"};
  EXPECT_TRUE(
      has(options_document({{"one", "First", {common, {"out", "", "Where", "flag"}}},
                            {"two", "Second", {common, {"word", "", "Which", "text", true}}}}),
          "## one, two\n\n```text\n--all=N                   How many (3)\n```\n\n"
          "## one\n\n```text\n--out                     Where\n```\n\n"
          "## two\n\n```text\nword                      Which\n```\n\n"));
}

// Returns the completions of bash itself; `words` are those of the line, the last one unfinished.
std::string completed(const std::vector<std::string>& words) {
  const testing::TemporaryFolder folder;
  folder.write("completion", bash_completion(subcommand_texts()));
  std::string script = "source completion; COMP_WORDS=(";
  for (const std::string& word : words) script += "'" + word + "' ";
  script +=
      ") COMP_CWORD=" + std::to_string(words.size() - 1) + "; _reeve; echo \"${COMPREPLY[*]}\"";
  const testing::ProcessResult result =
      testing::run_process({"/bin/bash", "-c", script}, {.directory = folder.path()});
  EXPECT_EQ(result.err, "");
  return result.out;
}

TEST(BashCompletion, KnowsSubcommandsOptionsAndValues) {
  EXPECT_EQ(completed({"reeve", "exp"}), "explore export\n");
  EXPECT_EQ(completed({"reeve", "explore", "--par"}), "--parts\n");
  EXPECT_EQ(completed({"reeve", "explore", "--parts", "p"}), "paper\n");
  EXPECT_EQ(completed({"reeve", "count", "--form"}), "--format\n");
  EXPECT_EQ(completed({"reeve", "diagnose", "da"}), "\n") << "files are for bash to name";
}

}  // namespace
}  // namespace reeve::cli
