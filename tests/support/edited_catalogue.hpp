// A copy of the shipped catalogue's folder in which one piece of one file is another.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "tests/support/temporary_folder.hpp"

namespace reeve::testing {

class EditedCatalogue {
 public:
  explicit EditedCatalogue(const std::string& file = "", const std::string& from = "",
                           const std::string& to = "") {
    std::filesystem::copy(REEVE_CATALOG_DIR, path(), std::filesystem::copy_options::recursive);
    if (file.empty()) return;
    std::string text = read_text(path() / file);
    const std::size_t at = text.find(from);
    EXPECT_NE(at, std::string::npos) << from;
    if (at != std::string::npos) text.replace(at, from.size(), to);
    folder_.write(file, text);
  }

  const std::filesystem::path& path() const { return folder_.path(); }
  const TemporaryFolder& folder() const { return folder_; }

 private:
  TemporaryFolder folder_;
};

}  // namespace reeve::testing
