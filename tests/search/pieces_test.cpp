// Pieces of an exploration, gone through by several and put together in their order, are the whole.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdint>
#include <utility>
#include <vector>

#include "search/batches.hpp"
#include "search/evaluate/evaluation.hpp"
#include "tests/search/kept_exploration.hpp"

namespace reeve::testing {
namespace {

struct BroughtPiece {
  ShardRange places;
  ShardRecord record;
};

// By so many in turn, in pieces of quite different lengths.
std::vector<BroughtPiece> brought_pieces(const ExploreOptions& options, std::size_t searchers) {
  std::vector<PieceSearch> searches;
  for (std::size_t s = 0; s < searchers; ++s) searches.push_back(piece_search(options));
  std::vector<BroughtPiece> pieces;
  const std::uint64_t total = RoutingGenerator(options.generator).total();
  for (std::uint64_t begin = 0; begin < total;) {
    const std::uint64_t length = std::uint64_t{1} << (pieces.size() * 7 % 15);
    const ShardRange places{begin, std::min(total, begin + length)};
    ExplorationPart part = searches[pieces.size() % searchers](places, {});
    pieces.push_back({places, record_of(part)});
    begin = places.end;
  }
  return pieces;
}

ExploreResult concluded(ExplorationPart part, const ExploreOptions& options) {
  part.total = RoutingGenerator(options.generator).total();
  return conclude(std::move(part), options);
}

TEST(Pieces, PutTogetherAreTheWhole) {
  const ExploreOptions options = kept_options(2);
  const ExploreResult whole = explore(options);
  for (const std::size_t searchers : {1U, 3U}) {
    SCOPED_TRACE(searchers);
    ExplorationPart part(options);
    const RecordAbsorbing absorb = record_absorbing(options, false);
    for (const BroughtPiece& piece : brought_pieces(options, searchers)) {
      EXPECT_EQ(piece.record.generated, piece.places.end - piece.places.begin);
      absorb(part, piece.record);
    }
    expect_same(concluded(std::move(part), options), whole);
  }
}

// What is left of a stopped exploration, and where a store goes on.
TEST(Pieces, FromTheFirstToAnyAreWhatOneSearchHasThere) {
  const ExploreOptions options = kept_options(1);
  ExplorationPart part(options);
  const RecordAbsorbing absorb = record_absorbing(options, false);
  const std::vector<BroughtPiece> pieces = brought_pieces(options, 3);
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    absorb(part, pieces[i].record);
    if (i % 9 != 4) continue;
    SCOPED_TRACE(pieces[i].places.end);
    ExplorationPart so_far(options);
    so_far.absorb(part);
    expect_same(concluded(std::move(so_far), options),
                concluded(piece_search(options)({0, pieces[i].places.end}, {}), options));
  }
}

TEST(Pieces, HaveAllValuesWhereTheyAreAskedFor) {
  const ExploreOptions options = kept_options(2);
  ExplorationPart part(options);
  const RecordAbsorbing absorb = record_absorbing(options, true);
  for (const BroughtPiece& piece : brought_pieces(options, 2)) absorb(part, piece.record);
  DesignEvaluator evaluator({}, options.grasps, options.score);
  std::vector<Design> designs = part.tradeoff.candidates();
  for (const ArchivedDesign& kept : part.archive.members()) designs.push_back(kept.design);
  ASSERT_GT(designs.size(), 20U);
  for (const Design& design : designs) {
    EXPECT_EQ(design.values, evaluator.evaluate(parse_routing(design.word)));
  }
}

TEST(Pieces, AreShortBehindOthers) {
  ExploreOptions options = kept_options(1);
  options.constraints.clear();
  options.top = 1;
  const ShardRange first{0, 60000};
  const ShardRange second{60000, 80000};
  ExplorationPart alone = piece_search(options)(second, {});
  const PieceSearch search = piece_search(options);
  search(first, {});
  ExplorationPart behind = search(second, {});
  EXPECT_EQ(behind.evaluated, alone.evaluated);
  EXPECT_EQ(alone.sample.members().size(), 50U);
  EXPECT_LT(behind.sample.members().size(), 25U);
}

TEST(Pieces, CoverWhatTheySawWhenStopped) {
  ExploreOptions options = kept_options(2);
  // Behind one that needs tensions a constraint leaves nothing out: the piece has several batches.
  std::swap(options.constraints[0], options.constraints[1]);
  const PieceSearch search = piece_search(options);
  search({0, 10000}, {});
  std::atomic<bool> stop = false;
  ExplorationPart part = search(
      {10000, 60000}, {[&](const Progress& progress) { stop = progress.done > 20000; }, &stop});
  EXPECT_GT(part.generated, 20000U);
  EXPECT_LT(part.generated, 50000U);
  ExplorationPart before = piece_search(options)({0, 10000}, {});
  before.absorb(part);
  const std::uint64_t end = before.generated;
  expect_same(concluded(std::move(before), options),
              concluded(piece_search(options)({0, end}, {}), options));
}

}  // namespace
}  // namespace reeve::testing
