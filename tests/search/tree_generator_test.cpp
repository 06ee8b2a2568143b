#include "search/enumerate/tree_generator.hpp"

#include <boost/graph/adjacency_list.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <random>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "search/enumerate/counting.hpp"
#include "search/enumerate/generator.hpp"
#include "tests/search/generated.hpp"
#include "tests/support/input_error.hpp"
#include "tests/support/part_graph.hpp"

namespace reeve::testing {
namespace {

PartSet tied(const PartSet& parts, int blocks) { return with_blocks(anchored(parts), blocks); }

std::vector<GeneratorOptions> small_searches() {
  std::vector<GeneratorOptions> searches;
  for (const bool one_tree : {false, true}) {
    for (int fingers = 1; fingers <= 3; ++fingers) {
      searches.push_back(generating(tied(paper_parts(), 2), fingers, identical, one_tree));
      searches.push_back(generating(tied(full_parts(), 1), fingers, identical, one_tree));
      searches.push_back(generating(with_blocks(full_parts(), 1), fingers, identical, one_tree));
      searches.push_back(generating(tied(paper_parts(), 1), fingers, distinct, one_tree));
    }
    searches.push_back(generating(tied(paper_parts(), 4), 2, identical, one_tree));
    searches.push_back(generating(tied(full_parts(), 2), 2, distinct, one_tree));
    for (const char* joins : {"P", "T,B,P"}) {
      const PartSet beside = with_beside(tied(paper_parts(), 1), joins);
      const PartSet few = with_beside(tied(parts_of("tube", "T", "F"), 2), joins);
      searches.push_back(generating(beside, 1, identical, one_tree));
      searches.push_back(generating(beside, 2, identical, one_tree));
      if (few.beside.size() > 1) continue;
      searches.push_back(generating(few, 2, distinct, one_tree));
      searches.push_back(generating(few, 3, identical, one_tree));
    }
    for (const PartSet& parts : odd_parts()) {
      searches.push_back(generating(tied(parts, 2), 3, identical, one_tree));
      searches.push_back(generating(tied(parts, 2), 2, distinct, one_tree));
      searches.push_back(generating(linked(tied(parts, 2)), 3, identical, one_tree));
      searches.push_back(generating(linked(tied(parts, 3)), 2, distinct, one_tree));
    }
    searches.push_back(generating(linked(tied(paper_parts(), 4)), 2, identical, one_tree));
    searches.push_back(generating(barred(tied(full_parts(), 2)), 2, identical, one_tree));
    for (const char* joins : {"", "P"}) {
      const PartSet few = barred(tied(parts_of("tube", joins, "M"), 3));
      searches.push_back(generating(few, 3, identical, one_tree));
      searches.push_back(generating(linked(in_series(few)), 3, identical, one_tree));
      searches.push_back(generating(with_blocks(few, 2), 3, distinct, one_tree));
      searches.push_back(generating(with_beside(with_blocks(few, 2), "P"), 2, identical, one_tree));
    }
    searches.push_back(generating(in_series(tied(full_parts(), 2)), 2, identical, one_tree));
    for (const char* joins : {"", "P"}) {
      const PartSet few = in_series(tied(parts_of("tube", joins, "M"), 3));
      searches.push_back(generating(linked(few), 3, identical, one_tree));
      searches.push_back(generating(few, 3, distinct, one_tree));
    }
    searches.push_back(
        generating(in_series(tied(parts_of("tube", "", "M"), 4)), 4, identical, one_tree));
    for (const char* joins : {"", "P"}) {
      const PartSet few = becketed(passed_twice(tied(parts_of("tube", joins, "M"), 2)));
      searches.push_back(generating(few, 3, identical, one_tree));
      searches.push_back(generating(few, 3, distinct, one_tree));
      searches.push_back(generating(linked(in_series(barred(few))), 3, identical, one_tree));
      searches.push_back(generating(with_beside(few, "P"), 2, identical, one_tree));
    }
    searches.push_back(generating(becketed(passed_twice(tied(full_parts(), 1))), 3, identical));
    searches.push_back(generating(becketed(passed_twice(tied(paper_parts(), 2))), 3, identical));
  }
  searches.push_back(generating(barred(linked(tied(parts_of("tube", "", "M"), 3))), 4, identical));
  // Has two trees of one shape, reached by different blocks of their roots.
  searches.push_back(generating(in_series(tied(parts_of("tube", "", "M,F"), 4)), 4, identical));
  return searches;
}

void expect_allowed(const Routing& routing, const GeneratorOptions& o) {
  const std::string word = to_word(routing);
  ASSERT_EQ(finger_count(routing), o.fingers) << word;
  ASSERT_LE(block_count(routing).blocks, o.parts.blocks) << word;
  ASSERT_EQ(to_word(canonical(routing, o.identity)), word);
  ASSERT_EQ(canonical(routing, o.identity), routing) << word;
  ASSERT_EQ(parse_routing(word), routing) << word;
}

TEST(TreeGenerator, RoutingsAreCanonicalAndUniqueAndAsManyAsCounted) {
  for (const GeneratorOptions& o : small_searches()) {
    SCOPED_TRACE(label_of(o));
    std::set<std::string> seen;
    std::uint64_t actuated = 0;
    for_each_generated(o, [&](const Routing& routing) {
      expect_allowed(routing, o);
      ASSERT_TRUE(seen.insert(to_word(routing)).second) << to_word(routing);
      if (is_actuated(routing)) ++actuated;
    });
    const auto counts = count_routings(o.parts, o.fingers, o.identity);
    EXPECT_EQ(actuated, o.one_tendon ? counts.one_tendon : counts.actuated);
    EXPECT_EQ(seen.size(), RoutingGenerator(o).total());
    if (o.one_tendon) continue;
    EXPECT_EQ(seen.size(), counts.all);
  }
}

TEST(TreeGenerator, RoutingsOfOneFingerAndOneBlock) {
  EXPECT_EQ(
      generated_words(generating(tied(parts_of("tube", "T", "M,F"), 1), 1, identical)),
      (std::vector<std::string>{"M-1x", "M-1-M", "M-1-F", "F-1x", "F-1-F", "1-T-1", "M-Y1+1-Y1-1",
                                "M-Y1+M-Y1-1x", "M-Y1+F-Y1-1x", "M-Y1+M-1-Y1-M", "M-Y1+M-1-Y1-F",
                                "M-Y1+M-Y1-1-F", "M-Y1+F-1-Y1-F"}));
}

TEST(TreeGenerator, KnownTreesAreAmongTheRoutings) {
  const std::vector<std::string> one =
      generated_words(generating(tied(full_parts(), 1), 2, identical));
  const std::set<std::string> two_fingers(one.begin(), one.end());
  for (const char* word : {"M-Y1+1x-Y1-2x", "M-Y1+F-1b-Y1-2b-F", "M-Y1+F-1-Y1-2-F"}) {
    EXPECT_TRUE(two_fingers.contains(word)) << word;
  }
  const Routing hand = canonical(parse_routing("M-Y1+Y2-Y1-Y3+1x-Y2-2x+3x-Y3-4x"), identical);
  std::uint64_t found = 0;
  for_each_generated(generating(tied(parts_of("tube", "T", "M"), 3), 4, identical),
                     [&](const Routing& routing) { found += routing == hand ? 1 : 0; });
  EXPECT_EQ(found, 1U);
}

TEST(TreeGenerator, JoinsBesideEndsAndTails) {
  EXPECT_EQ(
      generated_words(
          generating(with_beside(tied(parts_of("tube", "", "F"), 1), "P"), 1, identical)),
      (std::vector<std::string>{"F-1x", "F-1-F", "F-1-P-F", "F-P-1x", "F-P-1-P-F", "F-P-Y1+1-Y1-1",
                                "F-P-Y1+F-Y1-1x", "F-P-Y1+F-P-Y1-1x", "F-P-Y1+F-1-Y1-F",
                                "F-P-Y1+F-1-Y1-P-F", "F-P-Y1+F-Y1-1-P-F", "F-P-Y1+F-P-1-Y1-P-F"}));
  const Routing hand = canonical(parse_routing("Y1-P-Y2+1x-Y1-2x+3x-Y2-4x"), identical);
  std::uint64_t found = 0;
  for_each_generated(
      generating(with_beside(tied(parts_of("tube", "T", "M"), 2), "P"), 4, identical),
      [&](const Routing& routing) { found += routing == hand ? 1 : 0; });
  EXPECT_EQ(found, 1U);
}

TEST(TreeGenerator, LinkedBlocks) {
  const PartSet few = with_blocks(parts_of("tube", "", "F"), 2);
  std::vector<std::string> added = generated_words(generating(linked(few), 2, identical));
  for (const std::string& word : generated_words(generating(few, 2, identical))) {
    EXPECT_EQ(std::erase(added, word), 1U) << word;
  }
  EXPECT_EQ(added, (std::vector<std::string>{"Y1-Y2+1-Y1-1+2-Y2-2", "Y1-Y2+F-1-Y1-F+2-Y2-2",
                                             "Y1-Y2+F-1-Y1-F+F-2-Y2-F"}));
  const Routing hand = canonical(parse_routing("M-Y1-1x+Y1-Y2+2x-Y2-3x"), identical);
  std::uint64_t found = 0;
  for_each_generated(generating(linked(tied(parts_of("tube", "T", "M"), 2)), 3, identical),
                     [&](const Routing& routing) { found += routing == hand ? 1 : 0; });
  EXPECT_EQ(found, 1U);
}

TEST(TreeGenerator, BlocksInSeries) {
  const PartSet few = tied(parts_of("tube", "", "M"), 3);
  std::vector<std::string> added = generated_words(generating(in_series(few), 2, identical, true));
  for (const std::string& word : generated_words(generating(few, 2, identical, true))) {
    EXPECT_EQ(std::erase(added, word), 1U) << word;
  }
  EXPECT_EQ(added, (std::vector<std::string>{"1x-Y1+M-Y1-Y2-M+2x-Y2", "M-1-Y1+M-Y1-Y2-M+2x-Y2",
                                             "M-1-Y1+M-Y1-Y2-M+M-2-Y2"}));
  for (const char* word : {"M-Y1-Y2-Y3-M+Y1-1x+Y2-2x+Y3-3x", "M-Y1-B-Y2-F+Y1-1x+Y2-2-T-3-F",
                           "M-Y1-Y2-Y3+Y1-1x+Y2-2x+3x-Y3-4x"}) {
    const Routing routing = canonical(parse_routing(word), identical);
    std::uint64_t found = 0;
    for_each_generated(generating(in_series(tied(parts_of("tube", "T,B", "M,F"), 3)),
                                  finger_count(routing), identical),
                       [&](const Routing& other) { found += other == routing ? 1 : 0; });
    EXPECT_EQ(found, 1U) << word;
  }
}

// Arms are in the ratio of the sides of tendons below that hang on no further block.
TEST(TreeGenerator, Bars) {
  const PartSet few = tied(parts_of("tube", "", "M"), 1);
  std::vector<std::string> added = generated_words(generating(barred(few), 2, identical, true));
  for (const std::string& word : generated_words(generating(few, 2, identical, true))) {
    EXPECT_EQ(std::erase(added, word), 1U) << word;
  }
  EXPECT_EQ(added,
            (std::vector<std::string>{"M-W1+1x-W1-2x", "M-W1+M-1-W1-2x", "M-W1+M-1-W1-2-M",
                                      "1x-W1+2-W1-2", "M-1-W1+2-W1-2", "1x-W1+M-W1-2x",
                                      "M-1-W1+M-W1-2x", "1x-W1+M-2-W1-M", "M-1-W1+M-2-W1-M"}));
  const std::vector<std::string> three =
      generated_words(generating(barred(tied(parts_of("tube", "", "M,F"), 4)), 3, identical));
  for (const char* word : {"M-W1+1x-W1/1:2-Y1+2x-Y1-3x", "M-Y1+Y2-Y1-W1+1x-Y2-2x+M-W1-3x",
                           "M-W1+W2-W1/2:3-W3+1x-W2-F+M-W3/1:2-Y1+2x-Y1-3x"}) {
    const std::string known = to_word(canonical(parse_routing(word), identical));
    EXPECT_EQ(std::count(three.begin(), three.end(), known), 1) << word;
  }
}

TEST(TreeGenerator, BecketsAndDoublePasses) {
  const PartSet few = tied(parts_of("tube", "", "M"), 1);
  const auto added = [&](const PartSet& parts, int fingers) {
    std::vector<std::string> words = generated_words(generating(parts, fingers, identical, true));
    for (const std::string& word : generated_words(generating(few, fingers, identical, true))) {
      EXPECT_EQ(std::erase(words, word), 1U) << word;
    }
    return words;
  };
  EXPECT_EQ(added(becketed(few), 1), (std::vector<std::string>{"M-Y1+M-Y1-1-Y1k"}));
  EXPECT_EQ(added(passed_twice(few), 1), std::vector<std::string>{});
  EXPECT_EQ(
      added(becketed(few), 2),
      (std::vector<std::string>{"M-Y1+1x-Y1-2-Y1k", "M-Y1+M-1-Y1-2-Y1k", "M-Y1+Y1k-1-Y1-2-Y1k",
                                "1x-Y1+M-Y1-2-Y1k", "M-1-Y1+M-Y1-2-Y1k"}));
  EXPECT_EQ(added(passed_twice(few), 2),
            (std::vector<std::string>{"M-Y1+M-Y1-1-Y1-2x", "M-Y1+M-1-Y1-2-Y1-M"}));
}

TEST(TreeGenerator, MoreBlocksComeBehindFewer) {
  const auto fewer = generated_words(generating(tied(paper_parts(), 1), 3, identical));
  auto more = generated_words(generating(tied(paper_parts(), 2), 3, identical));
  ASSERT_GT(more.size(), fewer.size());
  more.resize(fewer.size());
  EXPECT_EQ(more, fewer);
}

// By the definition of a routing: tokens and blocks are vertices, what touches is joined.
Graph graph_of(const Routing& routing) {
  Graph graph;
  std::map<std::size_t, Vertex> blocks;
  for (const Tendon& tendon : routing.tendons) {
    Vertex first{};
    Vertex before{};
    for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
      const Token& token = tendon.walk[i];
      const Vertex here = add_part({static_cast<std::size_t>(token_rank(token)), false}, graph);
      if (i > 0) boost::add_edge(before, here, graph);
      if (i == 0) first = here;
      before = here;
      if (!is_of_block(token.kind)) continue;
      if (!blocks.contains(block_key(token))) {
        blocks[block_key(token)] = add_part({static_cast<std::size_t>(2 * 12), false}, graph);
      }
      boost::add_edge(here, blocks[block_key(token)], graph);
    }
    if (tendon.closed && first != before && !boost::edge(first, before, graph).second) {
      boost::add_edge(before, first, graph);
    }
  }
  return graph;
}

// Four fingers: Y1-1-T-2-Y2 with two different branches has two ways to be walked.
TEST(TreeGenerator, NoTwoRoutingsAreTheSame) {
  const PartSet few = parts_of("tube", "T", "M,F");
  for (const GeneratorOptions& o :
       {generating(tied(paper_parts(), 2), 2, identical), generating(tied(few, 3), 2, identical),
        generating(tied(few, 2), 3, identical), generating(tied(few, 2), 4, identical),
        generating(linked(tied(few, 4)), 2, identical),
        generating(in_series(tied(few, 3)), 3, identical),
        generating(barred(tied(few, 3)), 3, identical),
        generating(becketed(passed_twice(tied(few, 2))), 3, identical),
        generating(linked(in_series(tied(parts_of("tube", "", "M"), 4))), 4, identical)}) {
    GraphClasses classes(25);
    std::uint64_t given = 0;
    for_each_generated(o, [&](const Routing& routing) {
      classes.add(graph_of(routing));
      ++given;
    });
    EXPECT_EQ(classes.counts().all, given) << label_of(o);
  }
}

void expect_good_places(const GeneratorOptions& o, int many) {
  SCOPED_TRACE(label_of(o));
  RoutingGenerator generator(o);
  std::mt19937_64 engine(20260201);
  std::set<std::string> seen;
  Routing routing;
  for (int i = 0; i < many; ++i) {
    generator.seek(engine() % generator.total());
    ASSERT_TRUE(generator.next(routing));
    expect_allowed(routing, o);
    seen.insert(to_word(routing));
  }
  EXPECT_GT(seen.size(), static_cast<std::size_t>(many) * 9 / 10);
}

TEST(TreeGenerator, StartsAnywhereInLargeSearches) {
  expect_good_places(generating(tied(full_parts(), 3), 8, identical), 2000);
  expect_good_places(generating(tied(full_parts(), 8), 4, identical, true), 2000);
  expect_good_places(generating(tied(paper_parts(), 5), 3, identical), 2000);
  expect_good_places(generating(tied(paper_parts(), 3), 4, distinct), 500);
  expect_good_places(generating(in_series(tied(full_parts(), 8)), 6, identical, true), 500);
  expect_good_places(generating(in_series(tied(full_parts(), 5)), 5, distinct), 200);
  const PartSet many = barred(linked(in_series(tied(full_parts(), 8))));
  expect_good_places(generating(many, 6, identical, true), 2000);
  expect_good_places(generating(barred(tied(paper_parts(), 4)), 4, distinct), 500);
  const PartSet sheaves = becketed(passed_twice(tied(full_parts(), 8)));
  expect_good_places(generating(sheaves, 6, identical, true), 2000);
  expect_good_places(generating(barred(linked(in_series(sheaves))), 5, distinct), 200);
}

TEST(TreeGenerator, AsManyBlocksAsCanBeAndNoMore) {
  const auto error_of = [](const PartSet& parts) {
    return input_error([&] { RoutingGenerator generator(generating(parts, 2, identical)); });
  };
  EXPECT_EQ(error_of(with_blocks(full_parts(), 9)), "blocks 9: expected a number from 0 to 8");
  EXPECT_EQ(error_of(with_blocks(full_parts(), -1)), "blocks -1: expected a number from 0 to 8");
  EXPECT_EQ(error_of(in_series(with_beside(full_parts(), "P"))),
            "beside-ends 'P': expected no joins beside ends together with blocks in series");
  EXPECT_GT(RoutingGenerator(generating(tied(full_parts(), 8), 2, identical)).total(), 100000U);
}

TEST(TreeGenerator, MoreThanTwoToThe63RoutingsAreRefused) {
  EXPECT_EQ(input_error([] {
              RoutingGenerator generator(generating(tied(full_parts(), 2), 20, identical));
            }),
            "these parts and fingers make more than 2^63 routings: fewer fingers or parts are "
            "needed");
}

}  // namespace
}  // namespace reeve::testing
