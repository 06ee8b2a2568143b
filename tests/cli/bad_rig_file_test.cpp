// Hardware, model and catalogue files that are bad: named with file, line and column.
#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

TEST(BadHardware, IsNamedWithFileLineAndColumn) {
  expect_all_bad({
      {"show TR1 --hardware missing.toml",
       "missing.toml: cannot be read: No such file or directory"},
      {"show TR1 --hardware .", ".: is a directory: expected a TOML file"},
      {"show TR1 --hardware negative.toml",
       "negative.toml:2:6: tube.mu = -0.1: expected a finite number, not negative"},
      {"show TR1 --hardware nan.toml",
       "nan.toml:2:6: tube.mu = nan: expected a finite number, not negative"},
      {"show TR1 --hardware unknown.toml",
       "unknown.toml:2:1: unknown key 'tube.nu': expected one of mu, angle_rad"},
      {"show TR1 --hardware type.toml",
       "type.toml:2:6: tube.mu = \"smooth\": expected a finite number, not negative"},
      {"show TR1 --hardware syntax.toml", "syntax.toml:1:6: not valid TOML: "},
      {"rank TR1 --hardware contact.toml",
       "contact.toml:1:10: hardware: contact 'a-T9': expected two segments with a contact "
       "between them, each contact once, in M-1-T-2-F"},
      {"rank TR1 --hardware twice.toml",
       "twice.toml:3:10: hardware: contact 'T2-T1': expected two segments with a contact between "
       "them, each contact once, in M-1-T-2-F"},
      {"show TR4 --hardware spool.toml",
       "spool.toml:2:1: hardware: spools 'b': expected a motor-side segment that ends at an M (a P "
       "has no spool) in M-1-P-2-F"},
      {"rank TR1 TR4 --hardware spool.toml", "has no spool) in one of the routings"},
      {"explore --out out --hardware spool.toml",
       "spool.toml:1:2: hardware: spools 'b': expected none: a spool belongs to an end of one "
       "routing"},
      {"export TR2 --hardware slack.toml",
       "slack.toml:4:1: hardware: tendon.1.slack_mm = 5: expected none in an export to MuJoCo, "
       "whose tendons are always taut"},
      {"show TR1 --hardware tendon.toml",
       "tendon.toml:3:9: hardware: tendon '7': expected 1 of M-1-T-2-F: a spring needs a "
       "tendon with one end at an M"},
      {"show M-1b-M --hardware tendon.toml",
       "tendon.toml:3:9: hardware: tendon '7': expected none in M-1b-M: a spring needs a tendon "
       "with one end at an M"},
      {"rank M-1x+M-2x --hardware tendon.toml",
       "tendon.toml:3:9: hardware: tendon '7': expected 1 or 2 of M-1x+M-2x: "},
      {"explore --out out --hardware negative.toml", "negative.toml:2:6: tube.mu = -0.1"},
      {"rank TR1 --hardware nan.toml", "nan.toml:2:6: tube.mu = nan"},
  });
}

// Found when it is known for which routings the hardware is, and how its coefficients vary.
TEST(BadHardware, IsNamedWithItsFileWhereverItIsFound) {
  const std::string infinite =
      "infinite.toml:4:1: hardware: block.mu = inf: expected a number from 0 to 10";
  const auto with = [](Arguments arguments, const std::string& file, const std::string& message) {
    arguments.insert(arguments.end(), {"--hardware", file});
    return BadLine{arguments, message};
  };
  std::vector<BadLine> lines{
      with("rank M-Y1+1x-Y1-2x --uncertainty --draws 5", "infinite.toml", infinite),
      with("explore --out out --uncertainty --draws 5", "infinite.toml", infinite),
      with("size M-Y1+1x-Y1-2x --vary hand_mm=50..100", "infinite.toml", infinite),
      with("size TR1 --vary sheath_angle=1..90", "steep.toml",
           "steep.toml: hardware: finger.1 sheath: mu * angle = "),
      with("explore --out out --fingers 4", "contact.toml",
           "contact.toml:1:10: hardware: contact 'a-T9': expected strands of fingers 1 to 4"),
  };
  for (const Arguments command :
       {"show TR1", "rank TR1", "export TR1", "size TR1 --vary sheath_angle=1..2",
        "compare alone.csv", "diagnose ok.csv", "simulate --routings TR1 -o x.csv"}) {
    lines.push_back(with(command, "strong.toml",
                         "routing 'M-1-T-2-F': strong.toml:1:10: hardware: T1-T2: mu * angle = "
                         "18.84955592153876: expected at most 10"));
  }
  expect_all_bad(lines);
}

TEST(BadModel, IsNamedWithFileLineAndColumn) {
  const std::string cause = "cause.toml:2:9: effect[1].cause = \"rust\": expected one of tube_";
  expect_all_bad({
      {"show TR1 --model missing.toml", "missing.toml: cannot be read: No such file"},
      {"show TR1 --model ''", "--model '': expected a TOML file"},
      {"show TR1 --model negative.toml", "negative.toml:2:6: tube.mu = -0.1"},
      {"show TR1 --model cause.toml", cause},
      {"show TR1 --hardware cause.toml", "cause.toml:1:3: unknown key 'effect'"},
      {"show TR1 --model empty.toml --hardware empty.toml", "excludes"},
      {"rank TR1 --model contact.toml", "contact.toml:1:10: hardware: contact 'a-T9'"},
      {"explore --out out --fingers 6 --hardware contact.toml",
       "contact.toml:1:10: hardware: contact 'a-T9': expected two segments with a contact between "
       "them, each contact once, in one of the routings that are explored"},
      {"explore --out out --model cause.toml", cause},
      {"rank TR1 --model cause.toml", cause},
  });
}

TEST(EmptyHardwareFile, IsThePapersHardware) {
  const TemporaryFolder folder;
  fill(folder);
  ProcessOptions options{.directory = folder.path()};
  const ProcessResult result = reeve("show TR1 --format json --hardware empty.toml", options);
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(result.out, reeve("show TR1 --format json").out);
}

TEST(BadCatalogue, IsNamedByEverySubcommandThatReadsIt) {
  const auto with = [](const std::string& catalogue) {
    return std::map<std::string, std::string>{{"REEVE_CATALOG", catalogue}};
  };
  for (const Arguments arguments :
       {"show M-1-F", "rank --catalogue", "explore --out out", "check"}) {
    expect_all_bad({
        {arguments, "catalogue missing: cannot be read: No such file or directory",
         with("missing")},
        {arguments, "catalogue empty.toml: cannot be read: Not a directory", with("empty.toml")},
        {arguments, "catalogue no_catalog: has no file *.toml: expected one for each routing",
         with("no_catalog")},
        {arguments, "broken_catalog/tr1.toml:1:8: not valid TOML: ", with("broken_catalog")},
    });
  }
}

}  // namespace
}  // namespace reeve::testing
