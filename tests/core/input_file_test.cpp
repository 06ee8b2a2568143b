#include "core/input_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <atomic>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::TemporaryFolder;

std::atomic<int> notices{0};
std::string waited_for;

void note(const char* file, core::Awaited awaited) {
  EXPECT_EQ(awaited, core::Awaited::writer);
  waited_for = file;
  ++notices;
}

TEST(ReadingAnInput, GivesEveryByte) {
  const TemporaryFolder folder;
  std::string bytes;
  for (int i = 0; i < 300000; ++i) bytes += static_cast<char>(i * 7);
  const std::filesystem::path file = folder.write("file", bytes);
  EXPECT_EQ(core::read_input(file, 1 << 20, "a file"), bytes);
  EXPECT_EQ(core::read_input(file, 299999, "a file").size(), 300000U);
  EXPECT_EQ(core::read_input(file, 99, "a file"), bytes.substr(0, 100));
}

TEST(ReadingAnInput, NamesWhatCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_EQ(folder.error_of([&] { core::read_input(folder.path() / "none", 1, "a file"); }),
            "none: cannot be read: No such file or directory");
  std::filesystem::create_directory(folder.path() / "folder");
  EXPECT_EQ(folder.error_of([&] { core::read_input(folder.path() / "folder", 1, "a file"); }),
            "folder: is a directory: expected a file");
}

TEST(ReadingAnInput, WaitsForAPipeAndSaysSoAfterASecond) {
  using namespace std::chrono_literals;
  const TemporaryFolder folder;
  const std::filesystem::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  core::set_waiting_notice(note);
  for (const auto pause : {0ms, 1500ms}) {
    notices = 0;
    std::thread writer([&] {
      std::this_thread::sleep_for(pause);
      std::ofstream(pipe) << "text";
    });
    EXPECT_EQ(core::read_input(pipe, 100, "a file"), "text");
    writer.join();
    EXPECT_EQ(notices, pause > 1s ? 1 : 0);
  }
  EXPECT_EQ(waited_for, pipe.string());
  core::set_waiting_notice(nullptr);
}

}  // namespace
}  // namespace reeve
