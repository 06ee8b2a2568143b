#include "reports/output/files.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <filesystem>
#include <string>
#include <thread>
#include <vector>

#include "core/input_file.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::read_text;
using testing::TemporaryFolder;
using namespace std::chrono_literals;

std::vector<std::string> names_in(const std::filesystem::path& directory) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(directory)) {
    names.push_back(entry.path().filename().string());
  }
  std::sort(names.begin(), names.end());
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

TEST(WritingAFile, FollowsALinkWhichStays) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path() / "elsewhere");
  folder.write("elsewhere/target", "old");
  // Relative to the folder of the link, and over another link.
  std::filesystem::create_symlink("elsewhere/link", folder.path() / "file");
  std::filesystem::create_symlink("target", folder.path() / "elsewhere/link");
  write_file(folder.path() / "file", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "file"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "elsewhere/link"));
  EXPECT_FALSE(std::filesystem::is_symlink(folder.path() / "elsewhere/target"));
  EXPECT_EQ(read_text(folder.path() / "elsewhere/target"), "new");
}

TEST(WritingAFile, MakesWhatALinkLeadsTo) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("target", folder.path() / "file");
  write_file(folder.path() / "file", "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "file"));
  EXPECT_EQ(read_text(folder.path() / "target"), "new");
}

TEST(WritingAFile, RefusesALoopOfLinks) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("b", folder.path() / "a");
  std::filesystem::create_symlink("a", folder.path() / "b");
  EXPECT_EQ(folder.error_of([&] { write_file(folder.path() / "a", "text"); }),
            "file 'a' cannot be written: Too many levels of symbolic links");
}

TEST(WritingAFile, KeepsThePermissionsOfAnOlderOne) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("file", "old");
  for (const mode_t mode : {0600U, 0664U, 0755U}) {
    ::chmod(file.c_str(), mode);
    write_file(file, "new");
    struct stat status = {};
    ASSERT_EQ(::stat(file.c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777U, mode);
  }
}

TEST(WritingAFile, RefusesOneThatMayNotBeWritten) {
  // Who is not root sees it; as root, that a full device is refused (streams_test.cpp) tells alike.
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everything";
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("file", "old");
  ::chmod(file.c_str(), 0444);
  EXPECT_EQ(folder.error_of([&] { write_file(file, "new"); }),
            "file 'file' cannot be written: Permission denied");
  EXPECT_EQ(read_text(file), "old");
}

TEST(WritingAFile, WritesThroughADeviceAndALinkToOne) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("/dev/null", folder.path() / "null");
  std::filesystem::create_symlink("/dev/full", folder.path() / "full");
  write_file(folder.path() / "null", "text");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_EQ(names_in(folder.path()).size(), 2U);
  EXPECT_EQ(folder.error_of([&] { write_file(folder.path() / "full", "text"); }),
            "file 'full' cannot be written: No space left on device");
}

TEST(WritingAFile, WritesThroughAPipe) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::string read;
  std::thread reader([&] { read = read_text(pipe); });
  write_file(pipe, "text");
  reader.join();
  EXPECT_EQ(read, "text");
  EXPECT_TRUE(std::filesystem::is_fifo(pipe));
}

std::atomic<bool> stop{false};

// Where a signal that comes then leaves no trace but that.
void stop_at_the_notice(const char* /*file*/, core::Awaited /*awaited*/) { stop = true; }

TEST(WritingAFile, WaitsForAReaderUntilTheEndIsWanted) {
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  core::set_waiting_notice(stop_at_the_notice);
  end_waits_on(&stop);
  std::atomic<bool> ended{false};
  std::thread late_reader([&] {
    for (int i = 0; i < 500 && !ended; ++i) std::this_thread::sleep_for(10ms);
    if (!ended) read_text(pipe);
  });
  EXPECT_THROW(write_file(pipe, "text"), WaitInterrupted);
  ended = true;
  late_reader.join();
  end_waits_on(nullptr);
  core::set_waiting_notice(nullptr);
}

TEST(WritingAFile, WritesToADescriptorAsItIsOpen) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.write("file", "");
  const int descriptor = ::open(file.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
  ASSERT_GE(descriptor, 0);
  EXPECT_EQ(::write(descriptor, "before ", 7), 7);
  write_file("/proc/self/fd/" + std::to_string(descriptor), "text");
  EXPECT_EQ(::write(descriptor, " after", 6), 6);
  ::close(descriptor);
  EXPECT_EQ(read_text(file), "before text after");
}

TEST(WritingAFile, TakesTheLongestName) {
  const TemporaryFolder folder;
  const std::string name(255, 'a');
  write_file(folder.path() / name, "text");
  EXPECT_EQ(names_in(folder.path()), std::vector<std::string>{name});
  EXPECT_EQ(folder.error_of([&] { write_file(folder.path() / (name + "a"), "text"); }),
            "file '" + name + "a' cannot be written: File name too long");
}

TEST(FileBatch, AppearsAtOnceAndTakesTheOldAway) {
  const TemporaryFolder folder;
  folder.write("stale", "old");
  folder.write("a", "old");
  std::filesystem::create_symlink("elsewhere", folder.path() / "link");
  folder.write("elsewhere", "old");
  FileBatch batch;
  batch.remove(folder.path() / "stale");
  batch.remove(folder.path() / "link");
  batch.remove(folder.path() / "none");
  batch.add(folder.path() / "a", "new");
  batch.add(folder.path() / "b", "new");
  EXPECT_EQ(read_text(folder.path() / "a"), "old");
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "b"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "stale"));
  batch.commit();
  EXPECT_EQ(read_text(folder.path() / "a"), "new");
  EXPECT_EQ(read_text(folder.path() / "b"), "new");
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a", "b", "elsewhere"}));
}

// Unlinking asks for the right to write in the folder, not for that to write the file.
TEST(FileBatch, RemovesWhatMayNotBeWritten) {
  const TemporaryFolder folder;
  folder.write("stale", "old");
  std::filesystem::permissions(folder.path() / "stale", std::filesystem::perms::none);
  FileBatch batch;
  batch.remove(folder.path() / "stale");
  batch.commit();
  EXPECT_TRUE(names_in(folder.path()).empty());
}

TEST(FileBatch, RefusesTwoNamesOfOneFileBeforeItChangesAny) {
  const TemporaryFolder folder;
  folder.write("a", "old");
  std::filesystem::create_symlink("a", folder.path() / "b");
  EXPECT_EQ(folder.error_of([&] {
    FileBatch batch;
    batch.add(folder.path() / "a", "new");
    batch.add(folder.path() / "b", "new");
    batch.commit();
  }),
            "files 'a' and 'b' are the same, by a link: expected two files");
  EXPECT_EQ(read_text(folder.path() / "a"), "old");
  EXPECT_EQ(names_in(folder.path()), (std::vector<std::string>{"a", "b"}));
}

TEST(FileBatch, LeavesNothingWhereItFails) {
  const TemporaryFolder folder;
  folder.write("stale", "old");
  folder.write("a", "old");
  std::filesystem::create_directory(folder.path() / "b");
  EXPECT_EQ(folder.error_of([&] {
    FileBatch batch;
    batch.remove(folder.path() / "stale");
    batch.add(folder.path() / "a", "new");
    batch.add(folder.path() / "b", "new");
    batch.commit();
  }),
            "file 'b' cannot be written: Is a directory");
  EXPECT_EQ(read_text(folder.path() / "a"), "old");
  EXPECT_EQ(names_in(folder.path()).size(), 3U);
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
