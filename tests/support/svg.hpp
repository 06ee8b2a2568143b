// What tests ask of drawings.
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <regex>
#include <set>
#include <string>
#include <vector>

namespace reeve::testing {

inline std::size_t count(const std::string& text, const std::string& piece) {
  std::size_t found = 0;
  for (std::size_t at = text.find(piece); at != std::string::npos; at = text.find(piece, at + 1)) {
    ++found;
  }
  return found;
}

// Tags that nest and attributes in quotes, each once: what an XML parser insists on.
inline void expect_well_formed(const std::string& svg) {
  static const std::regex tag(R"re(<(/?)([a-z]+)((?: [A-Za-z:-]+="[^"<]*")*)(/?)>)re");
  static const std::regex attribute(R"re( ([A-Za-z:-]+)=")re");
  std::vector<std::string> open;
  std::size_t tags = 0;
  for (std::sregex_iterator found(svg.begin(), svg.end(), tag), end; found != end;
       ++found, ++tags) {
    const std::string name = found->str(2);
    const std::string attributes = found->str(3);
    std::set<std::string> names;
    for (std::sregex_iterator a(attributes.begin(), attributes.end(), attribute); a != end; ++a) {
      EXPECT_TRUE(names.insert(a->str(1)).second) << found->str();
    }
    if (!found->str(4).empty()) continue;
    if (found->str(1).empty()) {
      open.push_back(name);
    } else {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), name);
      open.pop_back();
    }
  }
  EXPECT_TRUE(open.empty());
  EXPECT_EQ(tags, count(svg, "<"));
  EXPECT_EQ(count(svg, "nan"), 0U);
  static const std::regex bare("&(?!amp;|lt;|gt;|quot;|#39;)");
  EXPECT_FALSE(std::regex_search(svg, bare));
}

}  // namespace reeve::testing
