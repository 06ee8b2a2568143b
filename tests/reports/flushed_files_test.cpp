// Records the order of writes, for a power failure or a kill at any moment: no file has its name
// before its bytes are there, and no new one appears before the old ones are gone.
// The program's calls of the kernel go through the functions of these names here.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <string>
#include <vector>

#include "reports/output/files.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {
namespace {

struct KernelCall {
  bool is_flush = false;  // or a new name
  ino_t file = 0;
};

// Not of other tests, which write as well.
bool are_noted = false;
std::vector<KernelCall>& noted_calls() {
  static std::vector<KernelCall> calls;
  return calls;
}

std::function<void()> before_each_change;

void tell_of_a_change() {
  if (before_each_change) before_each_change();
}

}  // namespace
}  // namespace reeve::testing

extern "C" int fsync(int descriptor) {
  struct stat status = {};
  if (reeve::testing::are_noted && ::fstat(descriptor, &status) == 0) {
    reeve::testing::noted_calls().push_back({true, status.st_ino});
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int unlink(const char* file) noexcept {
  reeve::testing::tell_of_a_change();
  return static_cast<int>(::syscall(SYS_unlinkat, AT_FDCWD, file, 0));
}

extern "C" int rename(const char* from, const char* to) noexcept {
  reeve::testing::tell_of_a_change();
  struct stat status = {};
  if (reeve::testing::are_noted && ::stat(from, &status) == 0) {
    reeve::testing::noted_calls().push_back({false, status.st_ino});
  }
  return static_cast<int>(::syscall(SYS_rename, from, to));
}

namespace reeve::testing {
namespace {

TEST(FileBatch, IsOnTheDiskBeforeItHasItsNamesAndItsFolderAfterwards) {
  const TemporaryFolder folder;
  folder.write("b", "old");
  are_noted = true;
  FileBatch batch;
  batch.add(folder.path() / "a", "first");
  batch.add(folder.path() / "b", "second");
  batch.commit();
  are_noted = false;
  const std::vector<KernelCall>& calls = noted_calls();
  int named = 0;
  for (auto call = calls.begin(); call != calls.end(); ++call) {
    if (call->is_flush) continue;
    ++named;
    EXPECT_TRUE(std::any_of(calls.begin(), call, [&](const KernelCall& before) {
      return before.is_flush && before.file == call->file;
    }));
  }
  EXPECT_EQ(named, 2);
  struct stat status = {};
  ASSERT_EQ(::stat(folder.path().c_str(), &status), 0);
  ASSERT_FALSE(calls.empty());
  EXPECT_TRUE(calls.back().is_flush);
  EXPECT_EQ(calls.back().file, status.st_ino);
}

// Records the folder before each change, as a kill there would leave it.
TEST(FileBatch, NeverHoldsOldAndNewFilesAndItsLastFileMeansAll) {
  const TemporaryFolder folder;
  for (const char* name : {"a", "b", "stale", "last"}) folder.write(name, "old");
  const auto text = [&](const char* name) { return read_text(folder.path() / name); };
  FileBatch batch;
  batch.add(folder.path() / "a", "new");
  batch.remove(folder.path() / "stale");
  batch.add(folder.path() / "b", "new");
  batch.add(folder.path() / "last", "new");
  int states = 0;
  before_each_change = [&] {
    ++states;
    const std::string all = text("a") + text("b") + text("stale") + text("last");
    EXPECT_TRUE(all.find("old") == std::string::npos || all.find("new") == std::string::npos)
        << all;
    if (text("last") == "old") {
      EXPECT_EQ(all, "oldoldoldold");
    }
    EXPECT_NE(text("last"), "new");
  };
  batch.commit();
  before_each_change = nullptr;
  EXPECT_EQ(states, 7);  // four go, three appear
  EXPECT_EQ(text("a") + text("b") + text("stale") + text("last"), "newnewnew");
}

// A single file is there at any time.
TEST(FileBatch, OfOneReplacesItInOneStep) {
  const TemporaryFolder folder;
  folder.write("a", "old");
  FileBatch batch;
  batch.add(folder.path() / "a", "new");
  int states = 0;
  before_each_change = [&] {
    ++states;
    EXPECT_EQ(read_text(folder.path() / "a"), "old");
  };
  batch.commit();
  before_each_change = nullptr;
  EXPECT_EQ(states, 1);
  EXPECT_EQ(read_text(folder.path() / "a"), "new");
}

}  // namespace
}  // namespace reeve::testing
