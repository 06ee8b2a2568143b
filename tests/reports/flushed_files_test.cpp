// What is on the disk when, should the power fail: no file has its name before its bytes are there.
// The program's calls of the kernel go through the functions of these names here.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <vector>

#include "reports/files.hpp"
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

}  // namespace
}  // namespace reeve::testing

extern "C" int fsync(int descriptor) {
  struct stat status = {};
  if (reeve::testing::are_noted && ::fstat(descriptor, &status) == 0) {
    reeve::testing::noted_calls().push_back({true, status.st_ino});
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

extern "C" int rename(const char* from, const char* to) noexcept {
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

}  // namespace
}  // namespace reeve::testing
