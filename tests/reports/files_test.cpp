#include "reports/files.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::read_text;
using testing::TemporaryFolder;

std::vector<std::string> names_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

TEST(WritingAFile, PutsTheBytesThereAndLeavesNothingElse) {
  const TemporaryFolder folder;
  const std::string bytes("a\r\nb\0c", 6);
  write_file(folder.path() / "file", bytes);
  EXPECT_EQ(read_text(folder.path() / "file"), bytes);
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"file"});
}

TEST(WritingAFile, ReplacesAnOlderOne) {
  const TemporaryFolder folder;
  folder.write("file", "a much longer text than the new one");
  write_file(folder.path() / "file", "new");
  EXPECT_EQ(read_text(folder.path() / "file"), "new");
}

// Whoever reads meanwhile sees the old text or the new one, never a piece.
TEST(WritingAFile, IsAtomic) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "file";
  const std::string a(1 << 20, 'a');
  const std::string b(1 << 20, 'b');
  write_file(file, a);
  std::atomic<bool> finished{false};
  std::thread writer([&] {
    for (int i = 0; i < 50; ++i) write_file(file, i % 2 == 0 ? b : a);
    finished = true;
  });
  int torn = 0;
  while (!finished) {
    const std::string text = read_text(file);
    torn += text == a || text == b ? 0 : 1;
  }
  writer.join();
  EXPECT_EQ(torn, 0);
}

TEST(WritingAFile, NamesTheFileThatCannotBeWrittenAndLeavesNothing) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "file");
  EXPECT_EQ(folder.error_of([&] { write_file(folder.path() / "file", "text"); }),
            "file 'file' cannot be written: Is a directory");
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{"file"});
  EXPECT_EQ(folder.error_of([&] { write_file(folder.path() / "no" / "file", "text"); }),
            "file 'no/file' cannot be written: No such file or directory");
}

TEST(PreparingAFolder, MakesItWithAllAboveIt) {
  const TemporaryFolder folder;
  prepare_directory(folder.path() / "a" / "b", "--out");
  EXPECT_TRUE(std::filesystem::is_directory(folder.path() / "a" / "b"));
  EXPECT_NO_THROW(prepare_directory(folder.path() / "a" / "b", "--out"));
}

TEST(PreparingAFolder, RefusesAFile) {
  const TemporaryFolder folder;
  folder.write("file", "text");
  EXPECT_EQ(folder.error_of([&] { prepare_directory(folder.path() / "file", "--out"); }),
            "--out 'file': expected a folder that can be written to: Not a directory");
  EXPECT_EQ(folder.error_of([&] { prepare_directory(folder.path() / "file" / "a", "--out"); }),
            "--out 'file/a': expected a folder that can be written to: Not a directory");
}

}  // namespace
}  // namespace reeve
