#include "core/canonical.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <numeric>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/notation.hpp"
#include "tests/support/published_words.hpp"

namespace reeve {
namespace {

using testing::published_words;

std::string identical(const std::string& word) {
  return to_word(canonical(parse_routing(word), FingerIdentity::identical));
}
std::string distinct(const std::string& word) {
  return to_word(canonical(parse_routing(word), FingerIdentity::distinct));
}

TEST(Canonical, ThePublishedWordsAreCanonical) {
  for (const std::string& word : published_words()) {
    EXPECT_EQ(identical(word), word);
    EXPECT_EQ(distinct(word), word);
  }
}

TEST(Canonical, AWalkBackwardsIsTheSameRouting) {
  EXPECT_EQ(identical("F-2-T-1-M"), "M-1-T-2-F");
  EXPECT_EQ(distinct("F-2-T-1-M"), "M-1-T-2-F");
  EXPECT_EQ(distinct("F-1-T-2-M"), "M-2-T-1-F");
  EXPECT_EQ(distinct("2-P-1-T-2"), "1-T-2-P-1");
}

TEST(Canonical, ALoopMayBeEnteredAtAnyFinger) {
  for (const char* word : {"1-T-2-B-3-P-1", "2-B-3-P-1-T-2", "3-P-1-T-2-B-3", "1-P-3-B-2-T-1"}) {
    EXPECT_EQ(distinct(word), "1-T-2-B-3-P-1");
  }
  EXPECT_EQ(identical("1b-T-2-B-1b"), "1-T-2b-B-1");
}

TEST(Canonical, IdenticalFingersMayBeRenamed) {
  EXPECT_EQ(identical("M-2-P-1-F"), "M-1-P-2-F");
  EXPECT_EQ(identical("M-3-F+2b-P-1-T-2b"), "1-T-2b-P-1+M-3-F");
}

TEST(Canonical, DistinctFingersKeepTheirNumbers) {
  EXPECT_EQ(distinct("M-2-P-1-F"), "M-2-P-1-F");
  EXPECT_NE(distinct("M-2-P-1-F"), distinct("M-1-P-2-F"));
  EXPECT_EQ(distinct("2-P-2+M-1b-F"), "M-1b-F+2-P-2");
  EXPECT_EQ(distinct("M-1-F+M-2-F"), distinct("M-2-F+M-1-F"));
}

TEST(Canonical, TendonsAreOrderedByFingersThenOpenOrClosedThenShapeThenNumbers) {
  EXPECT_EQ(distinct("M-F+2-P-2+M-1-F+3-T-4-P-3"), "3-T-4-P-3+M-1-F+2-P-2+M-F");
  EXPECT_EQ(distinct("F-P-3-F+M-2b-F+M-1-F"), "M-1-F+M-2b-F+F-3-P-F");
  EXPECT_EQ(distinct("M-3-F+M-1-F+M-2-F"), "M-1-F+M-2-F+M-3-F");
}

TEST(Canonical, WalksAreOrderedTokenByToken) {
  // Of two walks of a palindromic skeleton the canonical one begins with the earlier token.
  EXPECT_EQ(distinct("F-1-M"), "M-1-F");                      // M before F
  EXPECT_EQ(distinct("F-T-1-F"), "F-1-T-F");                  // a finger before a join
  EXPECT_EQ(distinct("M-1b-T-2-M"), "M-2-T-1b-M");            // a tube tip before a bearing
  EXPECT_EQ(distinct("M-B-1-T-M"), "M-T-1-B-M");              // T before B
  EXPECT_EQ(distinct("M-P-1-B-M"), "M-B-1-P-M");              // B before P
  EXPECT_EQ(distinct("M-2-T-1-M"), "M-1-T-2-M");              // finger numbers last
  EXPECT_EQ(distinct("M-1b-T-2b-T-3-M"), "M-3-T-2b-T-1b-M");  // … behind the whole shape
}

TEST(Canonical, IdenticalMotorsAreNumberedInTheOrderOfTheWord) {
  EXPECT_EQ(identical("M2-1b-M"), "M-1b-M2");
  EXPECT_EQ(identical("1x-M2+2x-M3+3x-M"), "M-1x+M2-2x+M3-3x");
  EXPECT_EQ(identical("M2-1-T-2-M+M2-3-F"), "M-1-T-2-M2+M-3-F");
  EXPECT_EQ(identical("1x-Y1-2x+Y1-M2+3x-M"), "M-Y1+1x-Y1-2x+M2-3x");
  EXPECT_EQ(identical("M-1-F+M-2-F+M2-3-F"), identical("M-1-F+M2-2-F+M2-3-F"));
}

TEST(Canonical, DistinctFingersKeepTheNumbersOfTheMotors) {
  EXPECT_EQ(distinct("M2-1b-M"), "M-1b-M2");
  EXPECT_EQ(distinct("M2-1-F+M-2-F"), "M-2-F+M2-1-F");
  EXPECT_NE(distinct("M-1-F+M2-2-F"), distinct("M2-1-F+M-2-F"));
}

// Words of one walk or two, as lists of tokens; any numbers may stand on their carriages.
using TokenLists = std::vector<std::vector<std::string>>;

std::string joined(const TokenLists& lists) {
  std::string word;
  for (const auto& list : lists) {
    if (!word.empty()) word += '+';
    for (std::size_t i = 0; i < list.size(); ++i) word += (i > 0 ? "-" : "") + list[i];
  }
  return word;
}

// Every way to write the same routing of open walks, by trying all.
std::set<std::string> all_ways_to_write(TokenLists lists, int fingers, int motors) {
  std::set<std::string> ways;
  std::vector<int> finger(static_cast<std::size_t>(fingers));
  std::iota(finger.begin(), finger.end(), 1);
  std::vector<int> motor(static_cast<std::size_t>(motors));
  std::iota(motor.begin(), motor.end(), 1);
  const auto renamed = [&](const std::string& token) {
    if (std::isdigit(static_cast<unsigned char>(token[0])) != 0) {
      return std::to_string(finger[static_cast<std::size_t>(token[0] - '1')]) + token.substr(1);
    }
    if (token[0] != 'M' && token[0] != 'P') return token;
    const int number = motor[token.size() == 1 ? 0U : static_cast<std::size_t>(token[1] - '1')];
    return token.substr(0, 1) + (number == 1 ? "" : std::to_string(number));
  };
  do {
    do {
      for (unsigned backwards = 0; backwards < 1U << lists.size(); ++backwards) {
        TokenLists other = lists;
        for (std::size_t t = 0; t < other.size(); ++t) {
          for (std::string& token : other[t]) token = renamed(token);
          if ((backwards >> t & 1U) != 0) std::reverse(other[t].begin(), other[t].end());
        }
        std::sort(other.begin(), other.end());
        do ways.insert(joined(other));
        while (std::next_permutation(other.begin(), other.end()));
      }
    } while (std::next_permutation(motor.begin(), motor.end()));
  } while (std::next_permutation(finger.begin(), finger.end()));
  return ways;
}

TEST(Canonical, RoutingsOfSeveralMotorsAreOneOnlyIfTryingAllWaysToWriteThemSaysSo) {
  const std::vector<std::pair<TokenLists, int>> skeletons{
      {{{"M", "1", "P", "2b", "M"}}, 2},
      {{{"M", "1", "P", "2", "P", "3", "F"}}, 3},
      {{{"M", "1", "M"}, {"M", "2", "M"}}, 2},
      {{{"M", "1", "F"}, {"M", "2", "P", "3", "M"}}, 3}};
  for (const auto& [skeleton, fingers] : skeletons) {
    std::map<std::string, std::set<std::string>> ways_of_canonical;
    std::vector<std::pair<std::size_t, std::size_t>> places;
    for (std::size_t t = 0; t < skeleton.size(); ++t) {
      for (std::size_t i = 0; i < skeleton[t].size(); ++i) {
        if (skeleton[t][i] == "M" || skeleton[t][i] == "P") places.emplace_back(t, i);
      }
    }
    std::vector<int> number(places.size(), 1);
    bool more = true;
    while (more) {
      TokenLists lists = skeleton;
      const int motors = *std::max_element(number.begin(), number.end());
      bool has_gap = false;
      for (int m = 1; m <= motors; ++m) {
        has_gap |= std::count(number.begin(), number.end(), m) == 0;
      }
      for (std::size_t p = 0; p < places.size(); ++p) {
        if (number[p] > 1) lists[places[p].first][places[p].second] += std::to_string(number[p]);
      }
      if (!has_gap) {
        const std::set<std::string> ways = all_ways_to_write(lists, fingers, motors);
        const std::string least = identical(joined(lists));
        EXPECT_TRUE(ways.contains(least)) << joined(lists) << " " << least;
        const auto known = ways_of_canonical.emplace(least, ways);
        EXPECT_EQ(known.first->second, ways) << joined(lists);
      }
      more = false;
      for (int& n : number) {
        if (++n <= 3) {
          more = true;
          break;
        }
        n = 1;
      }
    }
    std::set<std::string> seen;
    std::size_t all = 0;
    for (const auto& [least, ways] : ways_of_canonical) {
      all += ways.size();
      seen.insert(ways.begin(), ways.end());
    }
    EXPECT_EQ(seen.size(), all);  // no two canonical words are one routing
  }
}

TEST(Canonical, ATreeBeginsWithTheTendonOnWhichItHangs) {
  for (const char* word : {"M-Y1+1x-Y1-2x", "1x-Y1-2x+Y1-M", "2x-Y1-1x+M-Y1"}) {
    EXPECT_EQ(identical(word), "M-Y1+1x-Y1-2x");
    EXPECT_EQ(distinct(word), "M-Y1+1x-Y1-2x");
  }
  EXPECT_EQ(identical("M-B-Y1-B-Y1k+Y1-1x"), "1x-Y1+M-B-Y1-B-Y1k");
  EXPECT_EQ(identical("1x-Y2-2x+3x-Y3-4x+Y2-Y1-Y3+Y1-M"), "M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x");
}

TEST(Canonical, BlocksMayBeRenumberedAndTheirTreesWalkedInAnyOrder) {
  const std::string least = identical("M-Y1+Y2-Y1-Y3+1x-Y2-2x+F-3-Y3-F");
  for (const char* word : {"3x-Y1-1x+M-Y2+Y1-Y2-Y3+F-2-Y3-F", "F-1-Y2-F+Y2-Y3-Y1+Y3-M+3x-Y1-2x"}) {
    EXPECT_EQ(identical(word), least);
  }
  EXPECT_NE(identical("M-Y1+Y2-Y1-Y3+1x-Y2-F+F-3-Y3-2x"), least);
}

TEST(Canonical, ABarWalkedBackwardsHasItsRatioMirrored) {
  EXPECT_EQ(distinct("M-W1+1x-W1/2:1-2x"), "M-W1+2x-W1/1:2-1x");
  EXPECT_EQ(identical("M-W1+1x-W1/2:1-2x"), "M-W1+1x-W1/1:2-2x");
  EXPECT_EQ(distinct("M-W1+M-1-W1/2:1-F"), distinct("M-W1+F-W1/1:2-1-M"));
}

TEST(Canonical, BlocksAndBarsAreNumberedEachForThemselves) {
  EXPECT_EQ(identical("1x-W1-2x+3x-W2-4x+W1-Y1-W2+Y1-M"), "M-Y1+W1-Y1-W2+1x-W1-2x+3x-W2-4x");
  EXPECT_EQ(identical("M-Y2+1x-Y2-2x+M-Y1+3x-Y1-4x"), "M-Y1+1x-Y1-2x+M-Y2+3x-Y2-4x");
}

TEST(Canonical, ShapesIgnoreFingerNumbersAndNothingElse) {
  const auto equivalent = [](const char* a, const char* b) {
    return same_shape(parse_routing(a).tendons[0], parse_routing(b).tendons[0]);
  };
  EXPECT_TRUE(equivalent("M-1-T-2-F", "M-2-T-1-F"));
  EXPECT_TRUE(equivalent("1-P-2b-T-1", "2-P-1b-T-2"));
  EXPECT_FALSE(equivalent("M-1-T-2-F", "M-1-B-2-F"));
  EXPECT_FALSE(equivalent("M-1-T-2-F", "M-1-T-2b-F"));
  EXPECT_FALSE(equivalent("M-1-F", "M-1-T-F"));
  EXPECT_FALSE(equivalent("M-1-F", "M-1-T-2-F"));
}

// ---- symmetries, against all permutations of the fingers ----

Routing renamed(Routing routing, const std::vector<int>& names) {
  for (Token& token : routing.tendons.at(0).walk) {
    if (token.finger > 0) {
      token.finger = static_cast<std::uint8_t>(names[token.finger - std::size_t{1}]);
    }
  }
  return routing;
}

int permutations_that_change_nothing(const std::string& word) {
  const Routing routing = parse_routing(word);
  const Routing itself = canonical(routing, FingerIdentity::distinct);
  std::vector<int> names(static_cast<std::size_t>(finger_count(routing)));
  std::iota(names.begin(), names.end(), 1);
  int count = 0;
  do {
    if (canonical(renamed(routing, names), FingerIdentity::distinct) == itself) ++count;
  } while (std::next_permutation(names.begin(), names.end()));
  return count;
}

TEST(Canonical, SymmetriesAreThePermutationsOfFingersThatChangeNothing) {
  for (const std::string word : {"M-1-F",
                                 "M-1-M",
                                 "M-F",
                                 "M-1-T-2-M",
                                 "M-1-T-2-F",
                                 "M-1-T-2b-M",
                                 "M-1-T-2-B-3-M",
                                 "M-1-T-2-T-3-M",
                                 "F-1-P-2-T-3-P-4-F",
                                 "1x-T-2x",
                                 "1x-T-2-F",
                                 "1x-T-2-B-3-T-4x",
                                 "1-P-1",
                                 "1-T-P-1",
                                 "1-P-2-P-1",
                                 "1-T-2-P-1",
                                 "1-T-2-T-3-T-1",
                                 "1-T-2-T-3-P-1",
                                 "1-T-2-P-3-T-4-P-1",
                                 "1-T-2b-T-3-T-4b-T-1",
                                 "1-T-2-T-3-T-4-T-5-T-1",
                                 "1-T-P-2-T-P-1",
                                 "1-T-P-2-P-T-1"}) {
    EXPECT_EQ(symmetries(parse_routing(word).tendons[0]), permutations_that_change_nothing(word))
        << word;
  }
}

TEST(Canonical, ATendonIsCanonicalIfNoOtherWayToWalkItComesEarlier) {
  const auto tendon = [](const char* word) { return parse_routing(word).tendons.at(0); };
  for (const char* word : {"M-1-T-2-F", "M-1-T-2-M", "1-T-2-P-1", "1-P-2b-P-1", "M-F", "F-1-T-F"}) {
    EXPECT_TRUE(is_canonical(tendon(word))) << word;
  }
  for (const char* word : {"F-1-T-2-M", "M-2-T-1-M", "1-P-2-T-1", "2-T-1-P-2", "1b-P-2-P-1b"}) {
    EXPECT_FALSE(is_canonical(tendon(word))) << word;
  }
}

// ---- every two-finger routing of the paper's parts, in every way to write it ----

std::vector<std::string> walks_over(const std::string& first, const std::string& second) {
  std::vector<std::string> walks;
  for (const std::string join : {"-T-", "-P-"}) {
    for (const std::string begin : {"M-", "F-"}) {
      for (const std::string end : {"-M", "-F"}) {
        walks.push_back(begin + first + join + second + end);
      }
    }
    for (const std::string back : {"-T-", "-P-"}) {
      walks.push_back(first + join + second + back + first);
    }
  }
  return walks;
}

std::vector<std::string> walks_over(const std::string& finger) {
  return {"M-" + finger + "-M", "M-" + finger + "-F",    "F-" + finger + "-M",
          "F-" + finger + "-F", finger + "-T-" + finger, finger + "-P-" + finger};
}

std::vector<std::string> two_finger_words() {
  std::vector<std::string> words = walks_over("1", "2");
  for (const std::string& word : walks_over("2", "1")) words.push_back(word);
  for (const std::string& one : walks_over("1")) {
    for (const std::string& two : walks_over("2")) {
      words.push_back(one + "+" + two);
      words.push_back(two + "+" + one);
    }
  }
  return words;
}

std::set<std::string> canonical_words(bool (*keep)(const Routing&)) {
  std::set<std::string> found;
  for (const std::string& word : two_finger_words()) {
    const Routing routing = canonical(parse_routing(word), FingerIdentity::identical);
    if (keep(routing)) found.insert(to_word(routing));
  }
  return found;
}

TEST(Canonical, TellsApartAllTwentyFourRoutingsOfTwoFingers) {
  EXPECT_EQ(canonical_words([](const Routing&) { return true; }).size(), 24U);
  EXPECT_EQ(canonical_words([](const Routing& r) { return is_actuated(r); }).size(), 13U);
}

TEST(Canonical, TheActuatedOneTendonRoutingsOfTwoFingersAreThePublishedOnes) {
  EXPECT_EQ(
      canonical_words([](const Routing& r) { return is_actuated(r) && r.tendons.size() == 1; }),
      std::set<std::string>(published_words().begin(), published_words().end()));
}

}  // namespace
}  // namespace reeve
