#include "pages/shell/figure_files.hpp"

#include <gtest/gtest.h>

#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

TEST(FigureFiles, ReplaceThoseOfAnEarlierRunAndNoOthers) {
  const TemporaryFolder folder;
  const fs::path figures = folder.path() / "figures";
  write_figures(folder.path(), {{"old", "<svg/>"}, {"both", "<svg/>"}});
  folder.write("figures/mine.svg", "<svg/>");
  write_figures(folder.path(), {{"both", "<svg/>"}, {"new", "<svg/>"}});
  EXPECT_FALSE(fs::exists(figures / "old.svg"));
  EXPECT_TRUE(fs::exists(figures / "both.svg"));
  EXPECT_TRUE(fs::exists(figures / "new.svg"));
  EXPECT_TRUE(fs::exists(figures / "mine.svg"));
}

TEST(FigureFiles, HaveCaptionsBesideThemThatGoWithThem) {
  const TemporaryFolder folder;
  const fs::path figures = folder.path() / "figures";
  write_figures(folder.path(), {{"a", "<svg/>", "About a.\n"}, {"b", "<svg/>"}});
  EXPECT_EQ(read_text(figures / "a.txt"), "About a.\n");
  EXPECT_FALSE(fs::exists(figures / "b.txt"));
  EXPECT_EQ(read_text(figures / ".reeve"), "a.svg\na.txt\nb.svg\n");
  folder.write("figures/mine.txt", "");
  write_figures(folder.path(), {{"b", "<svg/>"}});
  EXPECT_FALSE(fs::exists(figures / "a.txt"));
  EXPECT_TRUE(fs::exists(figures / "mine.txt"));
}

TEST(FigureFiles, RemoveNothingOutsideTheirFolder) {
  const TemporaryFolder folder;
  const fs::path outside = folder.write("outside.svg", "<svg/>");
  folder.write("figures/.reeve", "../outside.svg\n" + outside.string() + "\n.reeve\n");
  write_figures(folder.path(), {});
  EXPECT_TRUE(fs::exists(outside));
}

}  // namespace
}  // namespace reeve::testing
