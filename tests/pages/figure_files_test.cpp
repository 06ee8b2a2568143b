#include "pages/shell/figure_files.hpp"

#include <gtest/gtest.h>

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

TEST(FigureFiles, RemoveNothingOutsideTheirFolder) {
  const TemporaryFolder folder;
  const fs::path outside = folder.write("outside.svg", "<svg/>");
  folder.write("figures/.reeve", "../outside.svg\n" + outside.string() + "\n.reeve\n");
  write_figures(folder.path(), {});
  EXPECT_TRUE(fs::exists(outside));
}

}  // namespace
}  // namespace reeve::testing
