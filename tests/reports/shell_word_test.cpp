#include "reports/output/shell_word.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/support/process.hpp"

namespace reeve {
namespace {

TEST(ShellWord, LeavesPlainTextAlone) {
  for (const char* text :
       {"1b-P-2+M-3-F", "TR7", "none:2/1/1,2:0.5", "out/explore", "--top", "7"}) {
    EXPECT_EQ(shell_word(text), text);
  }
  EXPECT_EQ(shell_word("sheaths<=2"), "'sheaths<=2'");
  EXPECT_EQ(shell_word("exponent=0.15"), "exponent=0.15");
  EXPECT_EQ(shell_word("=ls"), "'=ls'");
  EXPECT_EQ(shell_word("it's"), R"('it'\''s')");
}

TEST(ShellWord, ReachesTheProgramAsItIs) {
  for (const char* text : {"",      " ",       "my glove.toml",
                           "it's",  "''",      "a'b\"c",
                           "$HOME", "`id`",    "a;b",
                           "a\nb",  "*",       "~",
                           "!1",    "#",       "\\",
                           "\\'",   "-n",      "a=b",
                           "<b>&",  "Röhre µ", "(x)",
                           "[a]",   "{a,b}",   "a\tb"}) {
    const std::string command = std::string("printf '[%s]' ") + shell_word(text) + " next";
    EXPECT_EQ(testing::run_process({"/bin/sh", "-c", command}).out,
              "[" + std::string(text) + "][next]")
        << command;
  }
}

}  // namespace
}  // namespace reeve
