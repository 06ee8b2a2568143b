#include "studies/catalogue_check.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/studies/shipped_catalogue.hpp"
#include "tests/support/edited_catalogue.hpp"

namespace reeve {
namespace {

CheckReport checked(const std::optional<std::string>& family = std::nullopt) {
  return check_all(testing::shipped_catalogue(), CatalogueFiles::in(testing::shipped_folder),
                   family);
}

TEST(CheckAll, GoesFromTheRoutingsAndPublicationsToTheFamilies) {
  const CheckReport report = checked();
  EXPECT_EQ(report.families(),
            (std::vector<std::string>{"paper", "benches", "gloves", "hands", "hauls", "tackles"}));
  EXPECT_EQ(report.count(CheckStatus::differs), 0U);
  std::size_t items = 0;
  for (const std::string& family : report.families()) {
    const CheckReport alone = checked(family);
    EXPECT_EQ(alone.families(), std::vector<std::string>{family});
    for (const CheckStatus status : check_statuses) {
      EXPECT_EQ(alone.count(status), report.count(status, family)) << family;
    }
    items += alone.items.size();
  }
  EXPECT_EQ(items, report.items.size());
}

TEST(CheckAll, LeavesThePaperAsItIsWithoutFamilies) {
  const CheckReport paper = checked("paper");
  EXPECT_EQ(paper.count(CheckStatus::agrees), 140U);
  EXPECT_EQ(paper.count(CheckStatus::explained), 39U);
  EXPECT_EQ(paper.items.size(), 179U);
  EXPECT_EQ(paper.misprints.size(), 4U);
  EXPECT_EQ(checked("gloves").misprints.size(), 1U);
}

TEST(CheckAll, NoticesAWrongNumberOfAMechanism) {
  const testing::EditedCatalogue edited("families/tackles/luff_tackle.toml", "\"2.75\"",
                                        "\"2.76\"");
  const CheckReport report =
      check_all(read_catalogue(edited.path()), CatalogueFiles::in(edited.path()), "tackles");
  EXPECT_EQ(report.count(CheckStatus::differs), 1U);
}

}  // namespace
}  // namespace reeve
