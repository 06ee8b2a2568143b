// Hardware, model and catalogue files that are bad: named with file, line and column.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/cli/bad_commands.hpp"

namespace reeve::testing {
namespace {

TEST(BadHardware, IsNamedWithFileLineAndColumn) {
  expect_all_bad({
      show_tr1({"--hardware", "missing.toml"},
               "missing.toml: cannot be read: No such file or directory"),
      show_tr1({"--hardware", "."}, ".: is a directory: expected a TOML file"),
      show_tr1({"--hardware", "negative.toml"},
               "negative.toml:2:6: tube.mu = -0.1: expected a finite number, not negative"),
      show_tr1({"--hardware", "nan.toml"},
               "nan.toml:2:6: tube.mu = nan: expected a finite number, not negative"),
      show_tr1({"--hardware", "unknown.toml"},
               "unknown.toml:2:1: unknown key 'tube.nu': expected one of mu, angle_rad"),
      show_tr1({"--hardware", "type.toml"},
               "type.toml:2:6: tube.mu = \"smooth\": expected a finite number, not negative"),
      show_tr1({"--hardware", "syntax.toml"}, "syntax.toml:1:6: not valid TOML: "),
      show_tr1(
          {"--hardware", "contact.toml"},
          "contact.toml: hardware: contact 'a-T9': expected two segments with a contact between them "
          "in M-1-T-2-F"),
      explore({"--hardware", "negative.toml"}, "negative.toml:2:6: tube.mu = -0.1"),
      {{"rank", "TR1", "--hardware", "nan.toml"}, "nan.toml:2:6: tube.mu = nan", {}},
      {{"rank", "TR1", "--hardware", "contact.toml"}, "contact.toml: hardware: contact 'a-T9'", {}},
      {{"export", "TR1", "--hardware", "contact.toml"},
       "contact.toml: hardware: contact 'a-T9'",
       {}},
  });
}

TEST(BadModel, IsNamedWithFileLineAndColumn) {
  const std::string cause = "cause.toml:2:9: effect[1].cause = \"rust\": expected one of tube_";
  expect_all_bad({
      show_tr1({"--model", "missing.toml"}, "missing.toml: cannot be read: No such file"),
      show_tr1({"--model", ""}, "--model '': expected a TOML file"),
      show_tr1({"--model", "negative.toml"}, "negative.toml:2:6: tube.mu = -0.1"),
      show_tr1({"--model", "cause.toml"}, cause),
      show_tr1({"--hardware", "cause.toml"}, "cause.toml:1:3: unknown key 'effect'"),
      show_tr1({"--model", "empty.toml", "--hardware", "empty.toml"}, "excludes"),
      show_tr1({"--model", "contact.toml"}, "contact.toml: hardware: contact 'a-T9'"),
      explore(
          {"--fingers", "6", "--hardware", "contact.toml"},
          "contact.toml: hardware: contact 'a-T9': expected two segments with a contact between "
          "them in one of the routings that are explored"),
      explore({"--model", "cause.toml"}, cause),
      {{"rank", "TR1", "--model", "cause.toml"}, cause, {}},
  });
}

TEST(EmptyHardwareFile, IsThePapersHardware) {
  const TemporaryFolder folder;
  fill(folder);
  ProcessOptions options;
  options.directory = folder.path();
  const ProcessResult result = reeve({"show", "TR1", "--hardware", "empty.toml"}, options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, reeve({"show", "TR1"}).out);
}

TEST(BadCatalogue, IsNamedByEverySubcommandThatReadsIt) {
  const auto with = [](const std::string& catalogue) {
    return std::map<std::string, std::string>{{"REEVE_CATALOG", catalogue}};
  };
  for (const Arguments& arguments : {Arguments{"show", "M-1-F"}, Arguments{"rank", "--catalog"},
                                     Arguments{"explore", "--out", "out"}, Arguments{"check"}}) {
    expect_all_bad({
        {arguments, "catalogue missing: cannot be read: No such file or directory",
         with("missing")},
        {arguments, "catalogue empty.toml: cannot be read: Not a directory", with("empty.toml")},
        {arguments, "catalogue no_catalogue: has no file *.toml: expected one for each routing",
         with("no_catalogue")},
        {arguments, "broken_catalogue/tr1.toml:1:8: not valid TOML: ", with("broken_catalogue")},
    });
  }
}

}  // namespace
}  // namespace reeve::testing
