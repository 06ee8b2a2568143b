// The colours of charts stand in three places: in the chart writer, in the style sheet for the
// dark, and in the theme of those that come alive. They have to agree.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "drawing/chart/chart.hpp"
#include "pages/exploration/exploration_designs.hpp"
#include "pages/shell/asset_table.hpp"
#include "reports/output/json.hpp"

namespace reeve {
namespace {

constexpr std::size_t hues = 6;  // before ink and grey

TEST(ChartColours, AreTheSameInFiguresAndLiveCharts) {
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

// Of relative luminance, WCAG 2.2.
double luminance(const std::string& colour) {
  const double weights[] = {0.2126, 0.7152, 0.0722};
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double share = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    sum += weights[i] * (share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4));
  }
  return sum;
}

double contrast(const std::string& a, const std::string& b) {
  const double of_a = luminance(a) + 0.05;
  const double of_b = luminance(b) + 0.05;
  return std::max(of_a, of_b) / std::min(of_a, of_b);
}

// "--front: #d55e00;" in the light, and its value in the dark.
std::pair<std::string, std::string> variable(const std::string& style, const std::string& name) {
  std::vector<std::string> found;
  const std::string start = "  --" + name + ": ";
  for (std::size_t at = style.find(start); at != std::string::npos;
       at = style.find(start, at + 1)) {
    found.push_back(style.substr(at + start.size(), 7));
  }
  if (found.size() < 2) return {"", ""};
  return {found[0], found[1]};
}

std::string on_white(const chart::Style& style) {
  return chart::colours[static_cast<std::size_t>(style.colour)].on_white;
}

// What a mark means has one colour: in charts of the program, in live charts and in tables.
TEST(ChartColours, OfAMeaningAreTheSameEverywhere) {
  const Json theme = Json::parse(asset("theme.json"));
  const std::string style(asset("page.css"));
  const auto live = [&](const char* scheme, DesignKind kind) {
    return theme[scheme]["range"]["category"][static_cast<std::size_t>(kind)].get<std::string>();
  };
  for (const DesignKind kind : {DesignKind::listed, DesignKind::front, DesignKind::known,
                                DesignKind::sample, DesignKind::named}) {
    EXPECT_EQ(live("light", kind), on_white(design_style(kind))) << design_kind_name(kind);
  }
  for (const auto& [name, kind] :
       {std::pair("front", DesignKind::front), {"known", DesignKind::known}}) {
    EXPECT_EQ(variable(style, name), std::pair(live("light", kind), live("dark", kind))) << name;
  }
  const std::pair<std::string, std::string> advised = variable(style, "advised");
  EXPECT_EQ(advised.first, on_white(advised_style()));
  for (const auto& [scheme, colour] :
       {std::pair("light", advised.first), {"dark", advised.second}}) {
    EXPECT_EQ(theme[scheme]["style"]["advised"]["color"], colour) << scheme;
  }
  EXPECT_NE(style.find(".reeve-chart .reeve-violet { color: " + advised.second + "; }"),
            std::string::npos);
}

// Graphical objects need 3 : 1 (WCAG 2.2, 1.4.11). The random sample is meant to recede.
TEST(ChartColours, StandOutFromThePaper) {
  const Json theme = Json::parse(asset("theme.json"));
  const std::string dark = variable(std::string(asset("page.css")), "paper").second;
  EXPECT_EQ(dark, "#16181a");
  for (const DesignKind kind : {DesignKind::listed, DesignKind::front, DesignKind::known}) {
    const auto place = static_cast<std::size_t>(kind);
    EXPECT_GE(contrast(theme["light"]["range"]["category"][place], "#ffffff"), 3)
        << design_kind_name(kind);
    EXPECT_GE(contrast(theme["dark"]["range"]["category"][place], dark), 3)
        << design_kind_name(kind);
  }
  EXPECT_GE(contrast(theme["light"]["style"]["advised"]["color"], "#ffffff"), 3);
  EXPECT_GE(contrast(theme["dark"]["style"]["advised"]["color"], dark), 3);
}

}  // namespace
}  // namespace reeve
