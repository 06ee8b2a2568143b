#include "pages/chart_engine.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

namespace reeve {
namespace {

Json points(std::size_t count) {
  Json values = Json::array();
  for (std::size_t i = 0; i < count; ++i) values.push_back({{"x", i}, {"y", i * i}});
  return {{"data", {{"values", values}}},
          {"mark", "point"},
          {"width", "container"},
          {"height", 200},
          {"encoding",
           {{"x", {{"field", "x"}, {"type", "quantitative"}}},
            {"y", {{"field", "y"}, {"type", "quantitative"}}}}}};
}

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) {
    ++found;
  }
  return found;
}

// Vega gives the marks of a group one parent of class mark-symbol, with a path for each.
std::size_t marks(const std::string& svg) {
  const std::size_t begin = svg.find("class=\"mark-symbol");
  return begin == std::string::npos
             ? 0
             : count(svg.substr(begin, svg.find("</g>", begin) - begin), "<path ");
}

TEST(ChartEngine, DrawsOneMarkForEachDatum) {
  for (const std::size_t number : {1U, 7U, 500U}) {
    const std::string svg = chart_svg(points(number));
    EXPECT_TRUE(svg.starts_with("<svg ")) << svg.substr(0, 80);
    EXPECT_EQ(marks(svg), number);
  }
}

TEST(ChartEngine, DrawsTheSameBytesWhateverItDrewBefore) {
  Json clipped = points(30);
  clipped["mark"] = {{"type", "point"}, {"clip", true}};
  const std::string first = chart_svg(clipped);
  chart_svg(points(3));
  EXPECT_TRUE(chart_svg(clipped) == first);
  EXPECT_NE(chart_svg(clipped, "other").find("url(#other-clip"), std::string::npos);
}

TEST(ChartEngine, SaysWhatItCannotDraw) {
  EXPECT_THROW(chart_svg({{"mark", 7}}), std::runtime_error);
  EXPECT_EQ(marks(chart_svg(points(4))), 4U);  // and goes on
}

TEST(ChartEngine, TakesAnyText) {
  Json spec = points(2);
  spec["title"] = "\"'`\\ </script> ${x} \u2028 µ <b>";
  const std::string svg = chart_svg(spec);
  EXPECT_NE(svg.find("&lt;/script&gt;"), std::string::npos);
  EXPECT_EQ(svg.find("<b>"), std::string::npos);
}

}  // namespace
}  // namespace reeve
