// The colours of charts stand in three places: in the chart writer, in the style sheet for the
// dark, and in the theme of those that come alive. They have to agree.
#include "reports/chart/chart_colours.hpp"

#include <gtest/gtest.h>

#include <string>

#include "pages/shell/asset_table.hpp"
#include "reports/json.hpp"

namespace reeve {
namespace {

constexpr std::size_t hues = 6;  // before ink and grey

TEST(ChartColours, AreTheSameInPicturesAndLiveCharts) {
  const Json theme = Json::parse(asset("theme.json"));
  const std::string style(asset("page.css"));
  for (std::size_t i = 0; i < hues; ++i) {
    const chart::NamedColour& colour = chart::colours[i];
    EXPECT_EQ(static_cast<std::size_t>(colour.colour), i);
    EXPECT_EQ(theme["light"]["range"]["category"][i], colour.on_white) << colour.name;
    const std::string dark = theme["dark"]["range"]["category"][i];
    const std::string rule =
        std::string(".reeve-chart .reeve-") + colour.name + " { color: " + dark + "; }";
    EXPECT_NE(style.find(rule), std::string::npos) << rule;
  }
}

}  // namespace
}  // namespace reeve
