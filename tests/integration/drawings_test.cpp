// What the subcommands draw.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "tests/integration/explored.hpp"
#include "tests/support/has.hpp"

namespace reeve::testing {
namespace {

// Graphviz decides where it is installed; braces and quotes are a poor man's judge.
void expect_drawable(const std::string& dot) {
  const TemporaryFolder folder;
  folder.write("drawing.dot", dot);
  ProcessOptions options{.directory = folder.path()};
  const ProcessResult result = run_process({"dot", "-Tsvg", "drawing.dot"}, options);
  if (result.exit_code != 127) {
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_TRUE(has(result.out, "</svg>"));
  }
  EXPECT_TRUE(dot.starts_with("graph"));
  EXPECT_TRUE(dot.ends_with("}\n"));
  EXPECT_EQ(std::count(dot.begin(), dot.end(), '{'), std::count(dot.begin(), dot.end(), '}'));
  EXPECT_EQ(std::count(dot.begin(), dot.end(), '"') % 2, 0);
}

TEST(Drawing, IsAcceptedByGraphviz) {
  for (const Arguments routing : {"TR5", "TR7 --held 1", "M-F", "M-1b-B-2-F+M-3-M --held 3",
                                  "TR4 --direction release --held none"}) {
    Arguments arguments{"show"};
    arguments.insert(arguments.end(), routing.begin(), routing.end());
    arguments.insert(arguments.end(), {"--format", "dot"});
    const ProcessResult result = reeve(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    expect_drawable(result.out);
  }
}

TEST(Schematic, LiesBesideTheUsualResult) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  for (const Arguments command : {"show TR5 --held 1", "show M-F --format json", "check"}) {
    Arguments drawing = command;
    drawing.insert(drawing.end(), {"--svg", file});
    const ProcessResult result = reeve(drawing);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.out, reeve(command).out);
    EXPECT_TRUE(read_text(file).starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\""));
    EXPECT_TRUE(read_text(file).ends_with("</svg>\n"));
  }
}

TEST(Schematic, OfFloatingPartsShowsThem) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  for (const Arguments& options : {Arguments{}, Arguments("--held 2")}) {
    Arguments command{"show", "M-Y1+1x-W1/2:1-2x+W1-Y1-3x", "--svg", file};
    command.insert(command.end(), options.begin(), options.end());
    EXPECT_EQ(reeve(command).exit_code, 0);
    const std::string svg = read_text(file);
    for (const char* name : {">Y1</text>", ">W1 2:1</text>", ">block (Y)</text>"}) {
      EXPECT_TRUE(has(svg, name)) << name;
    }
    EXPECT_EQ(svg.find("reeve-moves") != std::string::npos, !options.empty());
  }
}

TEST(Schematic, WithoutAGraspHasNoTensions) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "drawing.svg").string();
  reeve({"show", "TR5", "--svg", file});
  EXPECT_FALSE(has(read_text(file), "Tensions"));
  reeve({"show", "TR5", "--held", "none", "--svg", file});
  EXPECT_TRUE(has(read_text(file), "Tensions"));
}

// Nor is the link itself replaced by a file.
TEST(Schematic, FollowsALink) {
  const TemporaryFolder folder;
  folder.write("target.svg", "old");
  const std::string link = (folder.path() / "link.svg").string();
  std::filesystem::create_symlink(folder.path() / "target.svg", link);
  EXPECT_EQ(reeve({"show", "TR5", "--svg", link}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::is_symlink(link));
  EXPECT_TRUE(read_text(folder.path() / "target.svg").starts_with("<svg"));
}

}  // namespace
}  // namespace reeve::testing
