#include "pages/shell/template.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <stdexcept>
#include <string>

#include "pages/shell/asset_table.hpp"
#include "pages/shell/page.hpp"
#include "tests/support/temporary_folder.hpp"

namespace reeve {
namespace {

TEST(Assets, AreEmbeddedByteForByte) {
  for (const auto& entry :
       std::filesystem::directory_iterator(std::string(REEVE_SOURCE_DIR) + "/pages/assets")) {
    EXPECT_EQ(asset(entry.path().filename().string()), testing::read_text(entry.path()))
        << entry.path();
  }
  EXPECT_THROW(asset("no such file"), std::out_of_range);
}

TEST(Template, EscapesTextOfUsers) {
  const std::string page = page_html({"<script>alert(1)</script>", "", "", Json::object()});
  EXPECT_EQ(page.find("<script>alert"), std::string::npos);
  EXPECT_NE(page.find("&lt;script&gt;alert"), std::string::npos);
}

TEST(Template, JsonCannotCloseItsScript) {
  const Json json{{"name", "</script><!--<script>"}};
  const std::string text = script_json(json);
  EXPECT_EQ(text.find('<'), std::string::npos);
  EXPECT_EQ(Json::parse(text), json);
}

TEST(Template, NamesAMissingTemplate) {
  EXPECT_THROW(render("nothing.mustache", {}), std::out_of_range);
}

// The preset `plain` builds with REEVE_PAGES=OFF, the others with the chart library.
TEST(Page, HasItsScriptsOrSaysThatThisBuildHasNone) {
  const std::string page = page_html({"", "", "exploration.js", Json::object(), true});
  const auto has = [&](std::string_view text) { return page.find(text) != std::string::npos; };
  const bool interactive = REEVE_PAGES;
  EXPECT_EQ(has(asset("exploration.js")), interactive);
  EXPECT_EQ(has(asset("live_charts.js")), interactive);
  EXPECT_EQ(has("reeve was built with REEVE_PAGES=OFF"), !interactive);
}

}  // namespace
}  // namespace reeve
