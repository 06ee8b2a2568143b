#include "studies/catalogue_list.hpp"

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "studies/catalogue_check.hpp"
#include "tests/support/all_floors.hpp"

namespace reeve {
namespace {

std::vector<ListedMechanism> mechanisms(const std::optional<std::string>& family = std::nullopt,
                                        const std::optional<int>& fingers = std::nullopt) {
  const CatalogueFiles files = CatalogueFiles::in(REEVE_CATALOG_DIR);
  return catalogue_list(read_catalogue(files), files, family, fingers);
}

TEST(CatalogueList, HasEveryNameOnce) {
  const Catalogue catalogue = read_catalogue(REEVE_CATALOG_DIR);
  std::set<std::string> names;
  for (const ListedMechanism& mechanism : mechanisms()) names.insert(mechanism.name);
  EXPECT_EQ(names.size(), catalogue.entries.size() + catalogue.mechanisms.size());
  EXPECT_EQ(names.size(), mechanisms().size());
  EXPECT_TRUE(names.contains("TR7") && names.contains("OpenHandModelT"));
}

// The numbers of a publication of several routings are of none of them: they are paper's alone.
TEST(CatalogueList, CountsTheNumbersThatTheCheckRecomputes) {
  const CatalogueFiles files = CatalogueFiles::in(REEVE_CATALOG_DIR);
  const CheckReport report = check_all(read_catalogue(files), files);
  std::map<std::string, std::size_t> checked;
  std::map<std::string, std::size_t> counted;
  for (const CheckItem& item : report.items) ++checked[item.family];
  for (const ListedMechanism& mechanism : mechanisms()) {
    counted[mechanism.family] += mechanism.printed;
    EXPECT_LE(mechanism.agree, mechanism.printed);
  }
  EXPECT_LE(counted["paper"], checked["paper"]);
  counted.erase("paper");
  checked.erase("paper");
  EXPECT_EQ(counted, checked);
}

TEST(CatalogueList, IsNarrowedByFamilyAndByFingers) {
  for (const ListedMechanism& mechanism : mechanisms("hands", 4)) {
    EXPECT_EQ(mechanism.family, "hands");
    EXPECT_EQ(finger_count(mechanism.routing), 4);
  }
  EXPECT_EQ(mechanisms("hands", 4).size(), 6U);
  EXPECT_TRUE(mechanisms("hands", 9).empty());
}

}  // namespace
}  // namespace reeve
