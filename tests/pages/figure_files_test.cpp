#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/file.h>
#include <unistd.h>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

#include "pages/shell/result_files.hpp"
#include "tests/support/process.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

namespace fs = std::filesystem;

const Stamp stamp{"result_id", "0123456789abcdef"};

void write_figures(const fs::path& folder, std::vector<FigureFile> figures) {
  write_result(folder, {{}, std::move(figures), {}}, stamp);
}

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

TEST(ResultFiles, HaveOneStamp) {
  const TemporaryFolder folder;
  const fs::path& out = folder.path();
  write_result(out,
               {{{"a.csv", "# note\nx\n1\n"}},
                {{"f", "<svg/>\n", "A caption.\n"}},
                {{"index.html", "<p>\n"}, {"a.json", "{}\n"}}},
               stamp);
  EXPECT_EQ(read_text(out / "a.csv"), "# note\nx,result_id\n1,0123456789abcdef\n");
  EXPECT_EQ(read_text(out / "index.html"), "<p>\n<!-- result_id 0123456789abcdef -->\n");
  EXPECT_EQ(read_text(out / "figures/f.svg"), "<svg/>\n<!-- result_id 0123456789abcdef -->\n");
  EXPECT_EQ(read_text(out / "figures/f.txt"), "A caption.\n");
  EXPECT_EQ(read_text(out / "a.json"), "{}\n");
}

TEST(ResultFiles, ReplaceAllOfAnEarlierResultOfWhicheverCommand) {
  const TemporaryFolder folder;
  const fs::path& out = folder.path();
  write_result(out, {{{"sweep.csv", "x\n1\n"}}, {{"f", "<svg/>\n"}}, {}}, stamp);
  write_result(out, {{{"residuals.csv", "x\n1\n"}}, {}, {}}, {"exploration", stamp.id});
  EXPECT_FALSE(fs::exists(out / "sweep.csv"));
  EXPECT_FALSE(fs::exists(out / "figures/f.svg"));
  write_result(out, {}, stamp);
  EXPECT_FALSE(fs::exists(out / "residuals.csv"));
}

TEST(ResultFiles, WithoutFiguresMakeNoFolderForThem) {
  const TemporaryFolder folder;
  write_result(folder.path(), {{{"a.csv", "x\n1\n"}}, {}, {}}, stamp);
  EXPECT_FALSE(fs::exists(folder.path() / "figures"));
}

TEST(ResultFiles, LeaveFilesOfOthersAlone) {
  const TemporaryFolder folder;
  folder.write("sweep.csv", "mine\n3\n");
  folder.write("mine.csv", "x,result_id\n1,0123456789abcdef\n");
  write_result(folder.path(), {}, stamp);
  EXPECT_EQ(read_text(folder.path() / "sweep.csv"), "mine\n3\n");
  EXPECT_TRUE(fs::exists(folder.path() / "mine.csv"));
}

TEST(ResultFiles, AreNotWrittenWhereTheListOfFiguresIsNoFile) {
  const TemporaryFolder folder;
  fs::create_directories(folder.path() / "figures/.reeve");
  EXPECT_EQ(folder.error_of([&] { write_figures(folder.path(), {}); }),
            "figures/.reeve: expected the list of reeve's figures, a file");
}

TEST(ResultFiles, WaitForARunThatWritesIntoTheFolder) {
  const TemporaryFolder folder;
  const int other = ::open(folder.path().c_str(), O_RDONLY | O_DIRECTORY);
  ASSERT_EQ(::flock(other, LOCK_EX), 0);
  std::jthread writer([&] { write_result(folder.path(), {{{"a.csv", "x\n1\n"}}, {}, {}}, stamp); });
  std::this_thread::sleep_for(std::chrono::milliseconds(100));
  EXPECT_FALSE(fs::exists(folder.path() / "a.csv"));
  ::close(other);
  writer.join();
  EXPECT_TRUE(fs::exists(folder.path() / "a.csv"));
}

}  // namespace
}  // namespace reeve::testing
