// Bad usage and bad input: exit code 2, one line on stderr that names the culprit and what was
// expected, nothing on stdout, nothing written.
#include <gtest/gtest.h>

#include <map>
#include <string>

#include "tests/cli/bad_line.hpp"

namespace reeve::testing {
namespace {

BadLine show(const std::string& routing, const std::string& message) {
  return {{"show", routing}, message};
}

TEST(BadRouting, IsNamedWithTheColumnAndWhatWasExpected) {
  expect_all_bad({
      show(
          "M-1-Q-2-F",
          "routing 'M-1-Q-2-F', column 5: unknown token 'Q': expected M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1"),
      show("m-1-t-2-f", "routing 'm-1-t-2-f', column 1: unknown token 'm'"),
      show("TR9",
           "routing 'TR9': no such name in the catalogue; expected one of TR1, TR2, TR3, TR4, TR5, "
           "TR6, TR7, a mechanism of benches, gloves, hands, hauls, tackles, or a word such as "
           "M-1-T-2-F"),
      show("M-1-T-1-F", "routing 'M-1-T-1-F', column 7: finger 1 is passed twice"),
      show("M-0-F", "routing 'M-0-F', column 3: '0': expected a finger number from 1 to 64"),
      show("M-1",
           "routing 'M-1', column 3: a walk must begin and end with M, F, a fingertip (1x) or a "
           "block (Y1), or come back to the finger that it began with, and '1' does neither"),
      show("P", "routing 'P', column 1: a walk must begin and end with M, F, a fingertip"),
      show("", "routing '': the word is empty; expected e.g. M-1-T-2-F"),
      show("M-2-F", "finger 1 is missing; fingers are numbered 1 to 2 without a gap"),
      show("F-1-Y1-2-F", "column 5: block Y1 has no tail"),
      show("M-1x-T-2-F", "column 3: '1x' ends a walk and cannot stand inside it"),
      show("F-1-F",
           "routing 'F-1-F': the tendon with T1 is not actuated: it has no M and no P, so the "
           "motor cannot pull it"),
      show("M-1-F+F-2-F", "the tendon with T3 is not actuated"),
      show("M-1-M3", "motor 2 is missing (M2 or P2)"),
      show("M-1-M7", "column 5: 'M7': expected M alone for the first motor, or the number"),
  });
}

TEST(BadCarriages, AreNamedWithTheMotorsThatThereAre) {
  expect_all_bad({
      {"show M-1-M2 --held none@1", "--held 'none@1': '@1': expected 2 travels from -100 to 100"},
      {"show M-1-F --held none@1", "'@1': expected no travels of carriages"},
      {"show 1x-M+2x-M2 --held none@1,-1", "a finger would have to open"},
      {"rank M-1-M2 M-1-M --grasps none@1,1", "'@1,1': expected no travels of carriages"},
      {"explore --fingers 2 --grasps none@1,1", "'@1,1': expected no travels of carriages"},
      {"size M-1-B-2-M2 M-1-T-2-M --grasps none@1,0.5 --vary sheath_angle=3..9",
       "'@1,0.5': expected no travels of carriages"},
      {"simulate --routings M-1-M2",
       "--routings 'M-1-M2': it has 2 motors, and a reading one motor tension: expected a routing "
       "of one motor"},
  });
}

TEST(BadRouting, IsShortenedInTheMessageIfItIsHuge) {
  const std::string huge(120000, '1');
  expect_all_bad({
      show(huge, "…': the word has 120000 characters, at most 4096 are read"),
      show("M-" + huge + "-F", "…': the word has 120004 characters, at most 4096 are read"),
  });
}

TEST(BadShowOption, IsNamedWithItsValueAndWhatWasExpected) {
  expect_all_bad({
      {"show", "routing is required, or --like and --fingers; see reeve show --help"},
      {"show --like TR7", "--like requires --fingers"},
      {"show --fingers 3", "--fingers requires --like"},
      {"show TR1 --like TR7 --fingers 3", "routing excludes --like"},
      {"show --like TR6 --fingers 3",
       "--fingers '3': expected one of 2, 4: the catalogue has TR6 for no other number"},
      {"show --like ZRig --fingers 2",
       "--fingers '2': expected 1: the catalogue has ZRig for no other number"},
      {"show --like SDMHnd --fingers 4",
       "--like 'SDMHnd': expected a name of the catalogue, which reeve catalogue lists; did you "
       "mean SDMHand?"},
      {"show TR5 --svg out/x.PDF",
       "--svg 'out/x.PDF': expected a file of SVG, such as 'out/x.svg'; rsvg-convert -f pdf or "
       "Inkscape converts it"},
      {"check --svg x.png", "--svg 'x.png': expected a file of SVG, such as 'x.svg'"},
      {"import log.csv --plot x.pdf", "--plot 'x.pdf': expected a file of SVG, such as 'x.svg'"},
      {"catalogue --family none",
       "--family 'none': expected one of paper, benches, gloves, hands, hauls, tackles"},
      {"catalogue --fingers 64",
       "--fingers '64': expected a number of fingers that something in the catalogue has"},
      {"show TR1 --held 3",
       "held '3': '3': expected none, or finger numbers from 1 to 2 such as 1,2"},
      {"show TR1 --held 1,1", "held '1,1': finger 1 is named twice"},
      {"show TR1 --held ''", "held '': '': expected none, or finger numbers from 1 to 2"},
      {"show TR1 --held one", "held 'one': 'one': expected none, or finger numbers"},
      {"show TR1 --direction sideways", "--direction: sideways not in {pull,release}"},
      {"show TR1 --format xml", "--format: xml not in {table,json,dot,markdown,latex}"},
      {"show TR1 --format dot --held 1 --held 2",
       "--format dot draws one grasp: expected --held once at most"},
      {"show TR1 --svg a.svg --held 1 --held 2",
       "--svg draws one grasp: expected --held once at most"},
      {"show TR1 --svg ''", "--svg '': expected the name of a file, not a folder"},
      {"show TR1 --svg no_catalog",
       "--svg 'no_catalog': expected the name of a file, not a folder"},
      {"show TR1 --svg missing/a.svg",
       "--svg 'missing/a.svg': expected a file that can be written: No such file or "
       "directory"},
      {"check --svg missing/a.svg",
       "--svg 'missing/a.svg': expected a file that can be written: No such file"},
      {"show TR1 --colour", "--colour"},
      {"show TR1 TR2", "TR2"},
  });
}

// As C reads them, 010 is eight and 0x10 sixteen, an empty text zero and "true" one.
TEST(BadNumber, IsNotWrittenInDecimalDigits) {
  const std::string whole = "': expected a whole number such as 10; see reeve";
  const std::string number = "': expected a number from ";
  expect_all_bad({
      {"explore --out out --fingers 010", "--fingers: Value '010" + whole},
      {"explore --out out --fingers 1.5", "--fingers: Value '1.5" + whole},
      {"explore --out out --fingers true", "--fingers: Value 'true" + whole},
      {"explore --out out --fingers ''", "--fingers: Value '" + whole},
      {{"explore", "--out", "out", "--fingers", " 3"}, "--fingers: Value ' 3" + whole},
      {"explore --out out --top 0x10", "--top: Value '0x10" + whole},
      {"explore --out out --details 00012", "--details: Value '00012" + whole},
      {"explore --out out --seed -010", "--seed: Value '-010" + whole},
      {"explore --out out --uncertainty --seed ''", "--seed: Value '" + whole},
      {"simulate --routings TR1 --seed ''", "--seed: Value '" + whole},
      {"simulate --routings TR1 --seed 1.5", "--seed: Value '1.5" + whole},
      {"diagnose ok.csv --seed=", "--seed: Value '" + whole},
      {"count --fingers 08", "--fingers: Value '08" + whole},
      {"rank TR1 --draws 0100", "--draws: Value '0100" + whole},
      {"size TR1 --vary tip_angle=1..4 --starts 02", "--starts: Value '02" + whole},
      {"size TR1 --vary tip_angle=1..4 --seed ''", "--seed: Value '" + whole},
      {"show TR1 --mu ''", "--mu: Value '" + number},
      {"show TR1 --mu 0x1", "--mu: Value '0x1" + number},
      {"diagnose ok.csv --hold-out 5%", "--hold-out: Value '5%" + number},
      {"import ok.csv --min-duration nan",
       "--min-duration: Value 'nan': expected a number from 0.1 to 3600; see reeve import --help"},
      {"import ok.csv --min-duration 0x10", "--min-duration: Value '0x10" + number},
      {"import ok.csv --tolerance nan", "--tolerance: Value 'nan" + number},
      {"import ok.csv --tolerance ''", "--tolerance: Value '" + number},
  });
  EXPECT_EQ(reeve("rank TR1 --threads 0").exit_code, 0);
}

// expect_bad() looks at the line.
TEST(BadArgument, CannotBreakTheLineOfAnErrorOrChangeATerminal) {
  expect_all_bad({
      {{"show", "TR\n1"}, "'TR?1'"},
      {{"show", "M-1-\x1B[2J"}, "?[2J"},
      {{"show", "M-1-\xFC"}, "M-1-?"},
      {{"show", "TR1", "--out", "empty.toml/a\n\r\tb"}, "--out 'empty.toml/a???b': "},
      {{"show", "TR1", "--format", "x\ny"}, "--format: x?y not in "},
      {{"compare", "no\nfile.csv"}, "no?file.csv: cannot be read"},
      {{"show", "TR1", "more\n"}, "more?"},
      {{"exp\nlore"}, "exp?lore"},
  });
}

// expect_bad() looks at the length of the message.
TEST(BadArgument, OfAnyLengthIsShortened) {
  for (const std::string& piece : {std::string("M-1-"), std::string("a b "), std::string("ä")}) {
    std::string endless;
    while (endless.size() < 100'000) endless += piece;
    expect_all_bad({
        {{"show", endless}, "characters, at most 4096 are read"},
        {{"show", "TR1", "--out", endless}, " bytes … "},
        {{"explore", "--out", "out", "--constraint", endless}, " bytes … "},
        {{"explore", "--out", "out", "--grasps", endless}, " bytes … "},
        {{"explore", "--out", "out", "--fingers", endless}, " bytes … "},
        {{"explore", "--out", "out", "--hardware", endless}, ""},
        {{"explore", "--out", "out", "--" + endless}, " bytes … "},
        {{endless}, " bytes … "},
    });
  }
}

TEST(BadExploreOption, IsNamedWithItsValueAndWhatWasExpected) {
  const std::string shard = "': expected i/N with 1 <= i <= N, such as 2/8";
  const std::string fingers = " not in range 1 to 64";
  const std::string held = "expected none, or finger numbers from 1 to 2 such as 1,2";
  const std::string constraint =
      "expected an objective, one of <= >= < > ==, and a number, such as sheaths<=2";
  expect_all_bad({
      {"explore --out out --shard 3/2", "--shard '3/2" + shard},
      {"explore --out out --shard 0/2", "--shard '0/2" + shard},
      {"explore --out out --shard half", "--shard 'half" + shard},
      {"explore --out out --fingers 0", "--fingers: Value 0" + fingers},
      {"explore --out out --fingers 65", "--fingers: Value 65" + fingers},
      {"explore --out out --parts none", "--parts: none not in {paper,full,all,field}"},
      {"explore --out out --tips glass",
       "--tips 'glass': 'glass': expected a comma-separated list of tube, bearing"},
      {"explore --out out --tips ''", "--tips '': expected at least one of tube, bearing"},
      {"explore --out out --tips tube,tube", "--tips 'tube,tube': 'tube' is named twice"},
      {"explore --out out --joins T,B,T", "--joins 'T,B,T': 'T' is named twice"},
      {"explore --out out --beside-ends P,P", "--beside-ends 'P,P': 'P' is named twice"},
      {"explore --out out --joins T,,P",
       "--joins 'T,,P': '': expected a comma-separated list of T, B"},
      {"explore --out out --joins '' --ends ''",
       "--joins '' without ends: expected at least one join or one end"},
      {"explore --out out --tendons two", "--tendons: two not in {one,any}"},
      {"explore --out out --objectives foo",
       "--objectives 'foo': unknown objective 'foo'; expected one of uniformity_mean, "},
      {"explore --out out --objectives ''",
       "--objectives '': unknown objective ''; expected one of "},
      {"explore --out out --objectives uniformity,uniformity",
       "--objectives 'uniformity,uniformity': 'uniformity' is named twice"},
      {"explore --out out --objectives uniformity,uniformity_mean", "is named twice"},
      {"explore --out out --constraint sheaths<=", "--constraint 'sheaths<=': " + constraint},
      {"explore --out out --constraint sheaths=2", "--constraint 'sheaths=2': " + constraint},
      {"explore --out out --constraint sheaths<=nan", "--constraint 'sheaths<=nan': " + constraint},
      {"explore --out out --constraint foo<=2", "--constraint 'foo<=2': unknown objective 'foo'"},
      {"explore --out out --top 0", "--top: Value 0 not in range 1 to 100000"},
      {"explore --out out --details -1", "--details: Value -1 not in range 0 to 100000"},
      {"explore --out out --threads -1", "--threads: Value -1 not in range 0 to 1024"},
      {"explore --out out --draws 0", "--draws: Value 0 not in range 1 to 100000"},
      {"explore --out out --seed 1.5", "--seed: Value '1.5'"},
      {"explore --out out --grasps 9", "'9': " + held},
      {"explore --out out --grasps some", "'some': expected single, all, paper, or held fingers"},
      {"explore --out out --grasps 1:0",
       "grasps '1:0': '1:0': expected a held list and a weight from 1e-6 to 1e6"},
      {"explore --out out --fingers 20 --grasps all",
       "grasps 'all': 20 fingers have 2^20 grasps; expected at most 16 fingers"},
      {"explore --out out --format csv", "--format: csv not in {table,json,markdown,latex}"},
      {"explore --out out extra", "extra"},
  });
}

TEST(BadOutFolder, IsNamedBeforeAnythingIsComputed) {
  const std::string expected = "': expected a folder that can be written to: ";
  const auto into = [](const std::string& folder) {
    return Arguments{"explore", "--fingers", "9", "--out", folder};
  };
  expect_all_bad({
      {into("empty.toml"), "--out 'empty.toml" + expected + "Not a directory"},
      {into("empty.toml/below"), "--out 'empty.toml/below" + expected + "Not a directory"},
      {into("/dev/null/x"), "--out '/dev/null/x" + expected + "Not a directory"},
      {into("/proc/x"), "--out '/proc/x" + expected},
      {into(""), "--out '" + expected},
  });
  for (const Arguments command : {"show TR1", "rank TR1 TR7"}) {
    for (const char* folder : {"empty.toml", "empty.toml/below", "/proc/x", ""}) {
      Arguments arguments = command;
      arguments.insert(arguments.end(), {"--out", folder});
      expect_bad({arguments, std::string("--out '") + folder + expected});
    }
  }
}

TEST(BadPageOfARanking, IsRefusedBeforeAnythingIsWritten) {
  const auto rank = [](Arguments options) {
    options.insert(options.begin(), {"rank", "TR1", "TR7", "--out", "out"});
    return options;
  };
  const std::string mu =
      "expected friction coefficients from 0 to 1, or 'model', such as 0.18,0.09,model";
  expect_all_bad({
      {rank("--data missing.csv"), "missing.csv: cannot be read"},
      {rank("--data ''"), "--data: Value '': expected a file or folder; see reeve rank --help"},
      {rank("--data cell.csv"), "cell.csv:2"},
      {rank("--data name.csv"), "TR9"},
      {rank("--data ok.csv"), "ok.csv: there is nothing to draw: expected readings"},
      {rank("--distribution-mu 0.18,smooth"), "--distribution-mu '0.18,smooth': 'smooth': " + mu},
      {rank("--distribution-mu ''"), "--distribution-mu '': '': " + mu},
      {rank("--distribution-mu -0.1"), "--distribution-mu '-0.1': '-0.1': " + mu},
      {rank("--distribution-mu 0.1,0.1"), "--distribution-mu '0.1,0.1': 0.1 is given twice"},
      {rank("--distribution-mu model,model"),
       "--distribution-mu 'model,model': model is given twice"},
      {"rank TR1 TR7 --data ok.csv", "--data requires --out"},
      {"rank TR1 TR7 --distribution-mu 0.1", "--distribution-mu requires --out"},
  });
}

TEST(BadRank, IsNamedWithTheRoutings) {
  expect_all_bad({
      {"rank", "rank: nothing to rank; expected routings, --catalogue or --store"},
      {"rank --catalogue --family toys",
       "--family 'toys': expected one of paper, benches, gloves, hands, hauls, tackles"},
      {"rank --catalogue --family hands --fingers 7",
       "--fingers '7': expected as many as a mechanism of the family hands has: 1, 2, 3, 4, 5"},
      {"rank --catalogue --fingers 9",
       "--fingers '9': expected as many as a routing of the family paper has: 2"},
      {"rank TR1 --family hands", "--family requires --catalogue"},
      {"check --family ''", "--family '': expected one of paper, benches"},
      {"rank TR1 TR1", "routing 'M-1-T-2-F' is given twice"},
      {"rank TR1 M-1-T-2-F", "routing 'M-1-T-2-F' is given twice"},
      {"rank --catalogue TR3", "routing 'F-1-P-2-F' is given twice"},
      {"rank M-1-P-2-F F-2-P-1-M", "routing 'F-2-P-1-M' is given twice, as M-1-P-2-F"},
      {"rank TR1 M-1-F",
       "and 'M-1-T-2-F' has 2; only routings with the same number of fingers can be compared"},
      {"rank M-F", "routing 'M-F': it has no fingers, so there is nothing to rank"},
      {"rank TR1 F-1-T-2-F", "routing 'F-1-T-2-F': the tendon with T1 is not actuated"},
      {"rank TR1 --format xml", "--format: xml not in {table,json,csv,markdown,latex}"},
      {"rank TR1 --draws 100001", "--draws: Value 100001 not in range 1 to 100000"},
  });
}

TEST(BadOption, ThatWouldHaveNoEffectIsRefused) {
  const std::string alone =
      " prints the ranking alone; expected one of the two, or --out with them for a page";
  expect_all_bad({
      {"rank TR1 TR3 --seed 3", "--seed requires --uncertainty"},
      {"explore --out out --seed 3", "--seed requires --uncertainty"},
      {"rank TR1 TR3 --fingers 5", "--fingers requires --catalogue"},
      {"rank TR1 --catalogue --fingers 5",
       "--fingers '5': expected --catalogue with it, and no routings: where there are "
       "some, theirs count"},
      {"size TR1 --vary tip_angle=1..4 --nominal --draws 7", "--nominal excludes --draws"},
      {"show TR1 --format dot --cost empty.toml",
       "--cost: --format dot shows no cost; expected another format, or --out with it"},
      {"rank TR1 TR3 --margin --columns routing", "--margin: --columns" + alone},
      {"rank TR1 TR3 --margin --format csv", "--margin: --format csv" + alone},
      {"rank TR1 TR3 --sweep mu=0.1..0.2 --columns routing", "--sweep: --columns" + alone},
  });
}

TEST(BadUsage, PointsToTheHelp) {
  expect_all_bad({
      {{}, "a subcommand is required; see reeve --help"},
      {"frobnicate", "unknown subcommand frobnicate; see reeve --help"},
      {"--frobnicate", "unexpected --frobnicate; see reeve --help"},
      {"count --frobnicate", "count: unexpected --frobnicate; see reeve count --help"},
      {"count --tendons one", "--tendons one; see reeve count --help"},
      {"count --fingers 65", "--fingers: Value 65 not in range 1 to 64"},
      {"count --fingers 64", "more than 2^63 routings"},
      {"count --parts all --fingers 30", "--fingers 30: these parts"},
      {"explore --fingers 1 --motors 3 --out out",
       "--motors '3': expected at most 2: with these parts 1 finger cannot use more"},
      {"explore --fingers 2 --parts paper --motors 6 --out out",
       "--motors '6': expected at most 4: with these parts 2 fingers cannot use more"},
      {"count --blocks 9", "--blocks: Value 9 not in range 0 to 8"},
      {"count --blocks -1", "--blocks: Value -1 not in range 0 to 8"},
      {"count --blocks one", "--blocks: Value 'one'"},
      {"count --linked --blocks 1", "--linked with --blocks 1: expected --blocks 2 at least"},
      {"explore --series --blocks 1", "--series with --blocks 1: expected --blocks 2 at least"},
      {"count --bars --parts paper",
       "--bars with --parts paper, which has no floating blocks: expected --blocks 1 at least"},
      {"count --linked",
       "--linked with --parts field (the default), which has 1 floating block: expected --blocks 2"},
      {"count --linked --parts all",
       "--linked with --parts all, which has 1 floating block: expected --blocks 2 at least"},
      {"explore --beckets --blocks 0", "--beckets with --blocks 0: expected --blocks 1 at least"},
      {"count --double-passes --parts full",
       "--double-passes with --parts full, which has no floating blocks: expected --blocks 1"},
      {"check TR1", "check: unexpected TR1; see reeve check --help"},
      {"check --format csv", "--format: csv not in {table,json,markdown,latex}"},
  });
}

TEST(UnknownWords, StandInTheOrderInWhichTheyWereTyped) {
  expect_all_bad({
      {"explore --aaa 1 --zzz --out out x",
       "explore: unexpected --aaa 1 --zzz x; see reeve explore --help"},
      {"show TR1 TR2 TR3", "show: unexpected TR2 TR3; see reeve show --help"},
  });
}

TEST(UnknownWords, AreHeldAgainstTheKnownOnes) {
  expect_all_bad({
      {"explore --fingerz 3",
       "explore: unexpected --fingerz 3; did you mean --fingers? See reeve explore --help"},
      {"explore --fingerz=3 --jobs 2",
       "explore: unexpected --fingerz=3 --jobs 2; did you mean --fingers for --fingerz, --threads "
       "for --jobs? See reeve explore --help"},
      // The same word means nothing where there is no such option.
      {"check --config a.toml", "check: unexpected --config a.toml; see reeve check --help"},
      {"rank --catalogue --config a.toml", "; did you mean --hardware? See reeve rank --help"},
      {"exlpore --fingers 3", "unknown subcommand exlpore; did you mean explore? See reeve --help"},
      {"optimize", "unknown subcommand optimize; did you mean explore? See reeve --help"},
      {"--fingers 3 explore",
       "--fingers before the subcommand; expected reeve explore --fingers; see reeve explore "
       "--help"},
  });
}

TEST(UnknownNames, AreHeldAgainstTheKnownOnes) {
  expect_all_bad({
      {"explore --objectives unifromity", "; did you mean uniformity?"},
      {"explore --parts fulll",
       "--parts: fulll not in {paper,full,all,field}; did you mean full? "
       "See reeve explore --help"},
      {"explore --tradeoff sheath", "; did you mean sheaths? See reeve explore --help"},
      {"show TR1 --format jsn", "; did you mean json? See reeve show --help"},
      {"show TR1 --direction pul", "; did you mean pull? See reeve show --help"},
      {"check --family papr", "; did you mean paper?"},
      {"rank TR1 TR3 --columns nme", "; did you mean name?"},
      {"size TR1 --vary shaeth_angle=1..2", "; did you mean sheath_angle?"},
      {"explore --sweep muu=0.1..0.2", "; did you mean mu?"},
      {"explore --tips tub",
       "'tub': expected a comma-separated list of tube, bearing; did you "
       "mean tube?"},
      {"explore --grasps al",
       "--grasps 'al': expected single, all, paper, or held fingers such as "
       "none/1/1,2; did you mean all?"},
      {"simulate --routings TR1 --cause tube_fricton", "; did you mean tube_friction?"},
      {"show LuffTacle", "or a word such as M-1-T-2-F; did you mean LuffTackle?"},
  });
}

TEST(BadInput, IsNamedInTheseCasesToo) {
  expect_all_bad({
      {"explore --out out --seed -1", "--seed"},
      {"explore --out out --fingers 40", "--fingers 40: "},
      {"explore --out out --grasps 9", "--grasps '9': "},
      {"show TR1 --held 3", "--held '3': "},
      {"show TR1 --hardware ''", "--hardware"},
      {"frobnicate", "frobnicate"},
      {"--frobnicate", "--frobnicate"},
      {"rank --catalogue --hardware contact.toml", "a-T9"},
      {"explore --out out --hardware contact.toml", "a-T9"},
      {"rank TR1 M-1-F", "it has 1 finger and"},
  });
}

}  // namespace
}  // namespace reeve::testing
