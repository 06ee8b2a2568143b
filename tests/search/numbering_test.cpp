#include "search/enumerate/numbering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>
#include <string>
#include <vector>

#include "core/canonical.hpp"
#include "core/notation.hpp"

namespace reeve {
namespace {

Routing renumbered(Routing routing, const std::vector<int>& numbers) {
  std::size_t next = 0;
  for (Tendon& tendon : routing.tendons) {
    for (Token& token : tendon.walk) {
      if (token.kind == TokenKind::finger) token = finger(numbers[next++], token.tip);
    }
  }
  return routing;
}

// All permutations in order, the first of each routing's.
std::vector<std::string> expected_numberings(const Routing& shapes) {
  std::vector<int> numbers(static_cast<std::size_t>(finger_count(shapes)));
  std::iota(numbers.begin(), numbers.end(), 1);
  std::vector<std::string> words;
  std::set<std::string> seen;
  do {
    const Routing routing = renumbered(shapes, numbers);
    if (seen.insert(to_word(canonical(routing, FingerIdentity::distinct))).second) {
      words.push_back(to_word(routing));
    }
  } while (std::next_permutation(numbers.begin(), numbers.end()));
  return words;
}

std::vector<std::string> numberings(Numbering& numbering, Routing routing) {
  std::vector<std::string> words;
  numbering.start(routing);
  do {
    words.push_back(to_word(routing));
  } while (numbering.next(routing));
  return words;
}

std::vector<std::string> numberings(const std::string& word) {
  Numbering numbering;
  return numberings(numbering, parse_routing(word));
}

// Words in canonical order of shapes.
const std::vector<std::string>& examples() {
  static const std::vector<std::string> words{
      "M-1-F",
      "1-P-1",
      "M-1-T-2-F",
      "M-1-T-2-M",                        // palindrome
      "1-T-2-P-1",                        // loop, one reflection
      "1-P-2-P-1",                        // loop, two reflections and a half turn
      "M-1-P-2-T-3-P-4-M",                // palindrome
      "M-1-P-2-T-3-P-4-F",                // none
      "1-T-2-T-3-T-1",                    // all six symmetries of a triangle
      "1-T-2-T-3-P-4-P-1",                // one
      "1-T-2-P-3-T-4-P-1",                // two reflections and a half turn
      "1-T-2b-T-3-P-4b-P-1",              // none
      "1-P-2-P-3-P-4-P-5-P-1",            // all ten of a pentagon
      "M-1-M+M-2-M+M-3-M+M-4-M",          // four twins
      "M-1-M+M-2-M+M-3-F",                // two twins
      "M-1-T-2-M+M-3-T-4-M",              // twin palindromes
      "M-1-T-2-F+M-3-T-4-F+M-5-F+M-6-F",  // two pairs of twins
      "1-T-2-P-1+3-T-4-P-3+5-P-5",        // twin loops
      "M-1-T-2-M+M-3-M+M-4-F+5-P-5",      // no twins
  };
  return words;
}

TEST(Numbering, GivesTheFirstNumberingOfEachRoutingInOrder) {
  for (const std::string& word : examples()) {
    EXPECT_EQ(numberings(word), expected_numberings(parse_routing(word))) << word;
  }
}

TEST(Numbering, KnownLists) {
  EXPECT_EQ(numberings("M-1-F"), (std::vector<std::string>{"M-1-F"}));
  EXPECT_EQ(numberings("M-1-T-2-M"), (std::vector<std::string>{"M-1-T-2-M"}));
  EXPECT_EQ(numberings("M-1-T-2-F"), (std::vector<std::string>{"M-1-T-2-F", "M-2-T-1-F"}));
  EXPECT_EQ(numberings("M-1-T-2-F+M-3-F"),
            (std::vector<std::string>{"M-1-T-2-F+M-3-F", "M-1-T-3-F+M-2-F", "M-2-T-1-F+M-3-F",
                                      "M-2-T-3-F+M-1-F", "M-3-T-1-F+M-2-F", "M-3-T-2-F+M-1-F"}));
  EXPECT_EQ(numberings("M-1-T-2-M+M-3-T-4-M"),
            (std::vector<std::string>{"M-1-T-2-M+M-3-T-4-M", "M-1-T-3-M+M-2-T-4-M",
                                      "M-1-T-4-M+M-2-T-3-M"}));
}

// 7!/7 turns and 2 directions.
TEST(Numbering, LoopOfSevenFingers) {
  EXPECT_EQ(numberings("1-T-2-T-3-T-4-T-5-T-6-T-7-T-1").size(), 360U);
}

TEST(Numbering, TheNumbersFoundAtStartDoNotMatter) {
  Routing routing = parse_routing("M-1-T-2-F+M-3-F");
  Numbering numbering;
  const Routing other = renumbered(routing, {3, 1, 2});
  EXPECT_EQ(numberings(numbering, other), numberings("M-1-T-2-F+M-3-F"));
}

TEST(Numbering, ANumberingCanBeUsedAgain) {
  Numbering numbering;
  Routing routing = parse_routing("M-1-T-2-F+M-3-F+M-4-F");
  numbering.start(routing);
  ASSERT_TRUE(numbering.next(routing));
  EXPECT_EQ(numberings(numbering, parse_routing("M-1-T-2-F")), numberings("M-1-T-2-F"));
}

}  // namespace
}  // namespace reeve
