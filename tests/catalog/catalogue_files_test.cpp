#include "catalog/catalogue_files.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "catalog/catalogue.hpp"
#include "catalog/publication.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

using testing::read_text;
using testing::TemporaryFolder;

const std::filesystem::path shipped_folder = REEVE_CATALOG_DIR;

// Or a file would be in one of the two alone.
TEST(BuiltInCatalogue, IsTheFolderOfTheSources) {
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped_folder)) {
    const std::string path = entry.path().lexically_relative(shipped_folder).string();
    if (path.starts_with("hardware") || path.starts_with("model") || path.starts_with("prices")) {
      continue;
    }
    if (entry.path().extension() != ".toml" && entry.path().extension() != ".csv") continue;
    ASSERT_TRUE(embedded_catalogue().contains(path)) << path;
    EXPECT_EQ(embedded_catalogue().at(path), read_text(entry.path())) << path;
    ++files;
  }
  EXPECT_EQ(files, embedded_catalogue().size());
  EXPECT_EQ(read_publications(CatalogueFiles::built_in()).size(),
            read_publications(CatalogueFiles::in(shipped_folder)).size());
}

TEST(BuiltInCatalogue, NamesItsFilesAsTheSourcesDo) {
  EXPECT_EQ(read_catalogue(CatalogueFiles::built_in()).find_name("TR1")->file, "catalog/tr1.toml");
}

TEST(ShippedCatalogue, ComesFromTheEnvironmentOrIsBuiltIn) {
  const TemporaryFolder folder;
  folder.write("x.toml", "name = \"X\"\nword = \"M-1-T-2-M\"\n");
  ASSERT_EQ(setenv("REEVE_CATALOG", folder.path().c_str(), 1), 0);
  const Catalogue own = read_catalogue(CatalogueFiles::shipped());
  ASSERT_EQ(setenv("REEVE_CATALOG", "", 1), 0);
  const Catalogue empty = read_catalogue(CatalogueFiles::shipped());
  ASSERT_EQ(unsetenv("REEVE_CATALOG"), 0);
  const Catalogue none = read_catalogue(CatalogueFiles::shipped());
  ASSERT_EQ(own.entries.size(), 1U);
  EXPECT_EQ(own.entries[0].name, "X");
  EXPECT_EQ(empty.entries.size(), 7U);
  EXPECT_EQ(none.entries.size(), 7U);
}

TEST(BuiltInCatalogue, HasTheFoldersOfTheSources) {
  const std::vector<std::string> families = CatalogueFiles::built_in().folders("families");
  EXPECT_EQ(families, (std::vector<std::string>{"benches", "gloves", "hands", "hauls", "tackles"}));
  EXPECT_EQ(CatalogueFiles::in(shipped_folder).folders("families"), families);
  EXPECT_EQ(read_catalogue(CatalogueFiles::built_in()).mechanisms.size(),
            read_catalogue(shipped_folder).mechanisms.size());
}

TEST(CatalogueInAFolder, NeedsNoFamilies) {
  const TemporaryFolder folder;
  folder.write("x.toml", "name = \"X\"\nword = \"M-1-T-2-M\"\n");
  EXPECT_TRUE(CatalogueFiles::in(folder.path()).folders("families").empty());
  EXPECT_TRUE(read_catalogue(folder.path()).mechanisms.empty());
}

// What lies beside the folders, such as notes, is no family.
TEST(CatalogueInAFolder, HasAFamilyForEachFolder) {
  const TemporaryFolder folder;
  for (const char* family : {"winches", "cranes"}) {
    std::filesystem::create_directories(folder.path() / "families" / family);
  }
  folder.write("families/notes.txt", "");
  EXPECT_EQ(CatalogueFiles::in(folder.path()).folders("families"),
            (std::vector<std::string>{"cranes", "winches"}));
}

// The text with a key more in one of its tables, once for each table; `let` takes any name.
std::vector<std::string> with_a_key_more(const std::string& text) {
  std::vector<std::string> result;
  const std::regex table("^\\[.*\\]$|\\{ ", std::regex::multiline);
  for (std::sregex_iterator at(text.begin(), text.end(), table), end; at != end; ++at) {
    const std::string before = at->prefix().str();
    if (before.ends_with("let = ")) continue;
    const std::size_t line = before.rfind('\n') + 1;
    if (before.find('#', line) != std::string::npos) continue;
    const auto place = static_cast<std::size_t>(at->position() + at->length());
    const std::string key = at->str() == "{ " ? "magnet = 1, " : "\nmagnet = 1";
    result.push_back(text.substr(0, place) + key + text.substr(place));
  }
  return result;
}

TEST(ShippedCatalogue, TakesNoUnknownKeyInAnyTable) {
  std::size_t tables = 0;
  for (const auto& file : std::filesystem::recursive_directory_iterator(shipped_folder)) {
    const auto path = file.path().lexically_relative(shipped_folder);
    const std::string top = path.begin()->string();
    if (file.path().extension() != ".toml" || top == "hardware" || top == "model" ||
        top == "prices") {
      continue;
    }
    const TemporaryFolder folder;
    std::filesystem::create_directories((folder.path() / path).parent_path());
    folder.write("x.toml", "name = \"X\"\nword = \"M-1-T-2-M\"\n");
    for (const std::string& text : with_a_key_more(read_text(file.path()))) {
      folder.write(path.string(), text);
      const std::string error = folder.error_of([&] {
        read_catalogue(folder.path());
        read_publications(CatalogueFiles::in(folder.path()));
      });
      EXPECT_NE(error.find("unknown key"), std::string::npos) << path << error;
      ++tables;
    }
  }
  EXPECT_GT(tables, 300U);
}

TEST(CatalogueInAFolder, NeedsNoPublications) {
  const TemporaryFolder folder;
  folder.write("x.toml", "name = \"X\"\nword = \"M-1-T-2-M\"\n");
  EXPECT_TRUE(read_publications(CatalogueFiles::in(folder.path())).empty());
}

}  // namespace
}  // namespace reeve
