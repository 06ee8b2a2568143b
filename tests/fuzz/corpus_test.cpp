// What scripts/fuzz begins from, and what it once found, goes through every reader again.
#include <gtest/gtest.h>

#include <filesystem>

#include "fuzz/fuzzed.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

TEST(Corpus, IsReadOrRefusedByName) {
  const std::filesystem::path corpus = std::filesystem::path(REEVE_SOURCE_DIR) / "fuzz" / "corpus";
  for (const fuzz::NamedReader& reader : fuzz::readers()) {
    int files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(corpus / reader.name)) {
      SCOPED_TRACE(entry.path().string());
      EXPECT_NO_THROW(reader.read(testing::read_text(entry.path())));
      ++files;
    }
    EXPECT_GT(files, 0) << reader.name;
  }
}

}  // namespace
}  // namespace reeve
