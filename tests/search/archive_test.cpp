#include "search/rank/archive.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace reeve {
namespace {

using Objectives = std::vector<Objective>;

struct Stream {
  Objectives objectives;
  int levels;  // of each value: few levels make many ties
  std::size_t size;
};

std::string to_text(const Stream& stream) {
  return std::to_string(stream.objectives.size()) + " objectives, " +
         std::to_string(stream.levels) + " levels, " + std::to_string(stream.size) + " designs";
}

// What is dominated and what breaks ties (mean uniformity and efficiency, parts) vary on their own.
std::vector<Design> random_designs(std::mt19937_64& engine, const Stream& stream) {
  std::vector<Design> designs;
  for (std::size_t i = 0; i < stream.size; ++i) {
    Design design{"w" + std::to_string(i), {}};
    for (double& value : design.values) {
      value = static_cast<double>(engine() % static_cast<std::uint64_t>(stream.levels)) /
              static_cast<double>(stream.levels);
    }
    designs.push_back(design);
  }
  return designs;
}

std::vector<Design> in_order(const std::vector<RankedDesign>& ranked, bool best_first) {
  std::vector<Design> designs;
  for (const RankedDesign& entry : ranked) designs.push_back(entry.design);
  if (!best_first) std::reverse(designs.begin(), designs.end());
  return designs;
}

void expect_same_beginning(const std::vector<RankedDesign>& ranked,
                           const std::vector<RankedDesign>& expected, std::size_t keep) {
  ASSERT_GE(ranked.size(), std::min(keep, expected.size()));
  for (std::size_t i = 0; i < std::min(keep, expected.size()); ++i) {
    ASSERT_EQ(ranked[i].design.word, expected[i].design.word) << "at " << i;
    ASSERT_EQ(ranked[i].front, expected[i].front) << "at " << i;
    ASSERT_EQ(ranked[i].rank, i + 1);
    ASSERT_EQ(ranked[i].design.values, expected[i].design.values);
  }
}

using Words = std::vector<std::string>;

// Words of the front by what they are worth, in the order of the ranking.
std::map<std::vector<double>, Words> front_by_goodness(const std::vector<RankedDesign>& ranked,
                                                       const Objectives& objectives) {
  std::map<std::vector<double>, Words> classes;
  for (const RankedDesign& entry : ranked) {
    if (entry.front != 1) continue;
    const Goodness worth = goodness(entry.design.values, objectives);
    classes[{worth.begin(), worth.end()}].push_back(entry.design.word);
  }
  return classes;
}

// Whole, but for those beyond the first `keep` of equal designs, which are counted.
void expect_whole_front(const Archive::Content& content, const std::vector<RankedDesign>& expected,
                        const Objectives& objectives, std::size_t keep) {
  const auto all = front_by_goodness(expected, objectives);
  const auto held = front_by_goodness(content.ranked, objectives);
  ASSERT_EQ(held.size(), all.size());
  std::uint64_t left_out = 0;
  for (const auto& [worth, words] : all) {
    const auto cut = static_cast<std::ptrdiff_t>(std::min(keep, words.size()));
    left_out += words.size() - static_cast<std::size_t>(cut);
    EXPECT_EQ(held.at(worth), Words(words.begin(), words.begin() + cut));
  }
  EXPECT_EQ(content.front_equals_left_out, left_out);
}

void expect_ranking_of(const std::vector<Design>& arrivals, const Objectives& objectives,
                       std::size_t keep, const std::vector<RankedDesign>& expected) {
  Archive archive(objectives, keep);
  for (const Design& design : arrivals) archive.add(design);
  const Archive::Content content = archive.content();
  expect_same_beginning(content.ranked, expected, keep);
  expect_whole_front(content, expected, objectives, keep);
}

const std::vector<Stream>& streams() {
  static const std::vector<Stream> all{
      {{Objective::sheaths}, 5, 6000},
      {{Objective::uniformity_mean}, 1000000, 5000},
      {{Objective::uniformity_mean, Objective::efficiency_mean}, 1000000, 6000},
      {{Objective::uniformity_mean, Objective::efficiency_mean}, 12, 6000},
      {{Objective::sheaths, Objective::travel}, 6, 5000},
      {{Objective::jams, Objective::knots}, 1, 5000},
      {{Objective::uniformity_worst, Objective::sheaths, Objective::travel}, 8, 6000},
      {{Objective::uniformity_worst, Objective::efficiency_mean, Objective::pulleys}, 100, 5000},
      {{Objective::uniformity_mean, Objective::efficiency_worst, Objective::sheaths,
        Objective::round_trip_efficiency},
       5,
       6000},
      {{Objective::efficiency_mean}, 3, 30}};
  return all;
}

TEST(Archive, BeginsLikeTheRankingOfEverythingInAnyOrderOfArrival) {
  std::mt19937_64 engine(11);
  for (const Stream& stream : streams()) {
    SCOPED_TRACE(to_text(stream));
    const std::vector<Design> designs = random_designs(engine, stream);
    const std::vector<RankedDesign> expected = rank(designs, stream.objectives);
    for (const std::size_t keep : {1U, 2U, 7U, 50U}) {
      SCOPED_TRACE("keep " + std::to_string(keep));
      expect_ranking_of(designs, stream.objectives, keep, expected);
      expect_ranking_of(in_order(expected, true), stream.objectives, keep, expected);
      expect_ranking_of(in_order(expected, false), stream.objectives, keep, expected);
    }
  }
}

TEST(Archive, HoldsForEveryNumberToKeep) {
  std::mt19937_64 engine(12);
  const Stream stream{{Objective::uniformity_mean, Objective::sheaths}, 7, 4500};
  const std::vector<Design> designs = random_designs(engine, stream);
  const std::vector<RankedDesign> expected = rank(designs, stream.objectives);
  for (std::size_t keep = 1; keep <= 50; ++keep) {
    SCOPED_TRACE(keep);
    expect_ranking_of(designs, stream.objectives, keep, expected);
  }
}

TEST(Archive, MayBeReadBetweenAdditions) {
  std::mt19937_64 engine(13);
  for (const Stream& stream : streams()) {
    SCOPED_TRACE(to_text(stream));
    const std::vector<Design> designs =
        random_designs(engine, {stream.objectives, stream.levels, 900});
    Archive archive(stream.objectives, 5);
    for (std::size_t i = 0; i < designs.size(); ++i) {
      archive.add(designs[i]);
      if (i % 97 != 0) continue;
      const std::vector<Design> so_far(designs.begin(),
                                       designs.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      const std::vector<RankedDesign> expected = rank(so_far, stream.objectives);
      const Archive::Content content = archive.content();
      expect_same_beginning(content.ranked, expected, 5);
      expect_whole_front(content, expected, stream.objectives, 5);
    }
  }
}

// Twins that were left out on the front are no longer of it once something dominates them.
TEST(Archive, ForgetsTheTwinsOfWhatHasLeftTheFront) {
  for (const Objectives& objectives :
       {Objectives{Objective::sheaths, Objective::travel},
        Objectives{Objective::sheaths, Objective::travel, Objective::knots}}) {
    for (const std::size_t keep : {1U, 3U, 20U}) {
      SCOPED_TRACE(std::to_string(objectives.size()) + " objectives, keep " + std::to_string(keep));
      Archive archive(objectives, keep);
      Design design{"w", {}};
      const auto add = [&](std::size_t count, double sheaths) {
        value(design.values, Objective::sheaths) = sheaths;
        for (std::size_t i = 0; i < count; ++i) {
          design.word = "w" + std::to_string(sheaths) + std::to_string(i);
          archive.add(design);
        }
        return archive.content().front_equals_left_out;
      };
      EXPECT_EQ(add(keep + 5, 4), 5U);
      EXPECT_EQ(add(2, 4), 7U);
      EXPECT_EQ(add(1, 3), 0U);
      EXPECT_EQ(add(keep + 1, 3), 2U);
    }
  }
}

TEST(Archive, OfNothingIsEmpty) {
  Archive archive({Objective::travel}, 3);
  EXPECT_TRUE(archive.may_rank(ObjectiveValues{}));
  const Archive::Content content = archive.content();
  EXPECT_TRUE(content.ranked.empty());
  EXPECT_EQ(content.front_equals_left_out, 0U);
}

// As exploring asks: a batch at a time, before any of the batch is added.
TEST(Archive, NeverTurnsAwayADesignThatBelongsToTheFirst) {
  std::mt19937_64 engine(14);
  std::size_t turned_away = 0;
  for (const Stream& stream : streams()) {
    SCOPED_TRACE(to_text(stream));
    const std::vector<Design> designs = random_designs(engine, stream);
    const std::vector<RankedDesign> expected = rank(designs, stream.objectives);
    for (const std::size_t keep : {1U, 3U, 20U, 50U}) {
      SCOPED_TRACE("keep " + std::to_string(keep));
      Archive archive(stream.objectives, keep);
      constexpr std::size_t batch = 500;
      for (std::size_t begin = 0; begin < designs.size(); begin += batch) {
        const std::size_t end = std::min(begin + batch, designs.size());
        std::vector<Design> admitted;
        for (std::size_t i = begin; i < end; ++i) {
          if (archive.may_rank(designs[i].values)) admitted.push_back(designs[i]);
        }
        turned_away += end - begin - admitted.size();
        for (const Design& design : admitted) archive.add(design);
        if (begin % (4 * batch) == 0) archive.content();
      }
      const Archive::Content content = archive.content();
      expect_same_beginning(content.ranked, expected, keep);
      expect_whole_front(content, expected, stream.objectives, keep);
    }
  }
  EXPECT_GT(turned_away, 60000U);
}

// So long a list is not looked through for every design that asks.
TEST(Archive, NeverTurnsAwayADesignThatBelongsToAVeryLongList) {
  std::mt19937_64 engine(18);
  for (const Stream& stream : {Stream{{Objective::uniformity_mean}, 1000000, 24000},
                               Stream{{Objective::sheaths, Objective::travel}, 1000000, 24000}}) {
    SCOPED_TRACE(to_text(stream));
    const std::vector<Design> designs = random_designs(engine, stream);
    const std::vector<RankedDesign> expected = rank(designs, stream.objectives);
    constexpr std::size_t keep = 9000;
    for (const bool best_first : {true, false}) {
      Archive archive(stream.objectives, keep);
      std::size_t asked = 0;
      for (const Design& design : in_order(expected, best_first)) {
        if (archive.may_rank(design.values)) archive.add(design);
        if (++asked % 6000 == 0) archive.content();
      }
      const Archive::Content content = archive.content();
      expect_same_beginning(content.ranked, expected, keep);
      expect_whole_front(content, expected, stream.objectives, keep);
    }
  }
}

// Nothing may be lost to the filter later either: what ranks among all is admitted when all are in.
TEST(Archive, AdmitsAgainWhateverRanksAmongEverythingSeen) {
  std::mt19937_64 engine(15);
  for (const Stream& stream : streams()) {
    SCOPED_TRACE(to_text(stream));
    const std::vector<Design> designs = random_designs(engine, stream);
    const std::vector<RankedDesign> expected = rank(designs, stream.objectives);
    for (const std::size_t keep : {1U, 10U, 50U}) {
      Archive archive(stream.objectives, keep);
      for (const Design& design : designs) archive.add(design);
      archive.content();
      for (std::size_t i = 0; i < std::min(keep, expected.size()); ++i) {
        EXPECT_TRUE(archive.may_rank(expected[i].design.values)) << keep << " " << i;
      }
      for (const RankedDesign& entry : expected) {
        if (entry.front > 1) break;
        EXPECT_TRUE(archive.may_rank(entry.design.values));
      }
    }
  }
}

TEST(Archive, HoldsNoneThatEnoughOthersBeat) {
  std::mt19937_64 engine(17);
  for (Stream stream : streams()) {
    SCOPED_TRACE(to_text(stream));
    stream.size = 600;
    const std::vector<Design> designs = random_designs(engine, stream);
    for (const std::size_t keep : {1U, 4U, 15U}) {
      Archive archive(stream.objectives, keep);
      for (const Design& design : designs) archive.add(design);
      for (const RankedDesign& entry : archive.content().ranked) {
        const Goodness own = goodness(entry.design.values, stream.objectives);
        const auto beaters = std::count_if(designs.begin(), designs.end(), [&](const Design& d) {
          const Goodness other = goodness(d.values, stream.objectives);
          return dominates(other, own) ||
                 ((other == own).all() && precedes_within_front(d, entry.design, {}));
        });
        EXPECT_LT(static_cast<std::size_t>(beaters), keep) << entry.design.word;
      }
      EXPECT_EQ(archive.content().ranked.size(), archive.held());
    }
  }
}

std::size_t most_held(const Stream& stream, std::size_t keep) {
  std::mt19937_64 engine(16);
  Archive archive(stream.objectives, keep);
  std::size_t most = 0;
  for (std::size_t turn = 0; turn < 20; ++turn) {
    for (const Design& design :
         random_designs(engine, {stream.objectives, stream.levels, stream.size / 20})) {
      archive.add(design);
      most = std::max(most, archive.held());
    }
  }
  return most;
}

TEST(Archive, HoldsABoundedNumberOfALongStream) {
  constexpr std::size_t backlog = 4097;
  const Objectives one{Objective::uniformity_mean};
  const Objectives two{Objective::uniformity_mean, Objective::efficiency_mean};
  // One objective: the first `keep`. Two with values all different: keep * ln n or so.
  EXPECT_LE(most_held({one, 1000000000, 200000}, 50), backlog + 50);
  EXPECT_LE(most_held({two, 1000000000, 200000}, 50), backlog + 50 * 14);
  // Ties do not pile up: at most `keep` for each value of the front.
  EXPECT_LE(most_held({one, 2, 200000}, 50), backlog + 50);
  EXPECT_LE(most_held({two, 3, 200000}, 50), backlog + 50);
}

}  // namespace
}  // namespace reeve
