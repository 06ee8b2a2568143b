#include "search/limits/part_classes.hpp"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "search/limits/class_counts.hpp"
#include "search/limits/limited_tendons.hpp"
#include "search/limits/numbered_parts.hpp"
#include "tests/search/generated.hpp"

namespace reeve::testing {
namespace {

PartClasses classes_for(const std::vector<std::string>& texts,
                        const GeneratorOptions& options = generating(all_parts(), 4, identical)) {
  std::vector<Constraint> constraints;
  for (const std::string& text : texts) constraints.push_back(parse_constraint(text));
  return {constraints, options};
}

ClassCounts each_of(const PartClasses& classes, const std::vector<PartClass>& things) {
  ClassCounts counts = no_counts(classes);
  for (const PartClass thing : things) ++counts[thing];
  return counts;
}

std::size_t verdict_of(const PartClasses& classes, const std::string& word) {
  return classes.verdict(classes.of(parse_routing(word)));
}

TEST(PartClasses, EvaluateARoutingByTheFirstConstraintThatItFails) {
  const PartClasses classes = classes_for({"sheaths<=2", "pulleys>=1"});
  EXPECT_EQ(verdict_of(classes, "M-1-P-2-F"), failing(0));
  EXPECT_EQ(verdict_of(classes, "M-1-T-2-F"), failing(1));
  EXPECT_EQ(verdict_of(classes, "M-1b-T-2-F"), within_limits);
  EXPECT_EQ(verdict_of(classes, "M-1b-M+F-2-F"), not_actuated);
  // A tree hangs on the motor if one of its tendons does.
  EXPECT_EQ(verdict_of(classes, "M-Y1+F-1b-Y1-2-F"), within_limits);
  EXPECT_EQ(verdict_of(classes, "M-1b-M+2x-Y1-3-F+F-4-Y1"), not_actuated);
}

TEST(PartClasses, TakeBoundsThatAreNoWholeNumbersOrFarAway) {
  const PartClasses classes =
      classes_for({"sheaths<=2.5", "sheaths>=-3", "knots<1e300", "pulleys>-1e300"});
  EXPECT_EQ(verdict_of(classes, "M-1-M"), within_limits);
  EXPECT_EQ(verdict_of(classes, "M-1-P-2-F"), failing(0));
  EXPECT_EQ(verdict_of(classes_for({"sheaths==1.5"}), "M-1-F"), failing(0));
  EXPECT_EQ(verdict_of(classes_for({"sheaths<0"}), "M-1-F"), failing(0));
  EXPECT_EQ(verdict_of(classes_for({"sheaths>=4"}), "1-P-2-P-1"), within_limits);
  EXPECT_EQ(verdict_of(classes_for({"sheaths>4"}), "1-P-2-P-1"), failing(0));
}

TEST(PartClasses, AddUpInAnyOrder) {
  const PartClasses classes = classes_for({"sheaths<=3", "parts<=4"});
  for (std::size_t a = 0; a < classes.count(); ++a) {
    const auto x = static_cast<PartClass>(a);
    EXPECT_EQ(classes.plus(x, PartClasses::none), x);
    for (std::size_t b = 0; b < classes.count(); ++b) {
      const auto y = static_cast<PartClass>(b);
      ASSERT_EQ(classes.plus(x, y), classes.plus(y, x));
      for (std::size_t c = 0; c < classes.count(); ++c) {
        const auto z = static_cast<PartClass>(c);
        ASSERT_EQ(classes.plus(classes.plus(x, y), z), classes.plus(x, classes.plus(y, z)));
      }
    }
  }
}

TEST(ClassCounts, OfMultisetsAreThoseOfAllMultisets) {
  const PartClasses classes = classes_for({"sheaths<=5"});
  const std::vector<PartClass> things{0, 2, 2, 4, 5};
  ClassCounts pairs = no_counts(classes);
  ClassCounts triples = no_counts(classes);
  for (std::size_t i = 0; i < things.size(); ++i) {
    for (std::size_t j = i; j < things.size(); ++j) {
      const PartClass two = classes.plus(things[i], things[j]);
      ++pairs[two];
      for (std::size_t k = j; k < things.size(); ++k) ++triples[classes.plus(two, things[k])];
    }
  }
  EXPECT_EQ(multisets(classes, each_of(classes, things), 2), pairs);
  EXPECT_EQ(multisets(classes, each_of(classes, things), 3), triples);
  EXPECT_EQ(multisets(classes, each_of(classes, things), 0), each_of(classes, {PartClasses::none}));
}

TEST(ShapeCounts, AreThoseOfTheShapes) {
  for (const PartSet& parts : {paper_parts(), full_parts(), anchored(full_parts()),
                               parts_of("bearing", "", "M,F"), parts_of("tube", "B,P", "")}) {
    const PartClasses classes = classes_for({"sheaths<=4", "pulleys<=5", "knots<1"});
    const std::vector<ClassCounts> counts = shape_counts(classes, parts, 6);
    for (int fingers = 1; fingers <= 6; ++fingers) {
      ClassCounts seen = no_counts(classes);
      ShapeCursor cursor;
      for (bool more = cursor.start(parts, fingers); more; more = cursor.next(parts)) {
        ++seen[classes.of(cursor.shape())];
      }
      EXPECT_EQ(counts[static_cast<std::size_t>(fingers)], seen) << fingers;
    }
  }
}

// Where shapes are not kept in a list one steps from one to the next.
TEST(LimitedTendons, AreTheSameHoweverFewShapesAreKept) {
  const PartClasses classes = classes_for({"sheaths<=3", "pulleys>=2"});
  LimitedTendons all_kept(classes, full_parts(), 4, false);
  for (const std::uint64_t longest : {0U, 12U, 150U}) {
    LimitedTendons some_kept(classes, full_parts(), 4, false, longest);
    for (const std::uint64_t from : {0U, 1000U, 4321U, 9900U}) {
      all_kept.seek(4, PartClasses::none, from);
      some_kept.seek(4, PartClasses::none, from);
      Routing routing;
      Routing same;
      std::uint64_t place = 0;
      std::uint64_t same_place = 0;
      while (all_kept.next(routing, place)) {
        ASSERT_TRUE(some_kept.next(same, same_place));
        ASSERT_EQ(place, same_place);
        ASSERT_EQ(routing, same);
        ASSERT_EQ(some_kept.place_of(routing), place);
      }
      EXPECT_FALSE(some_kept.next(same, same_place));
      EXPECT_EQ(all_kept.counts_before(4, from), some_kept.counts_before(4, from));
    }
  }
}

TEST(LimitedTendons, GoOnWhereTheyWereAfterCounting) {
  const PartClasses classes = classes_for({"sheaths<=3"});
  LimitedTendons tendons(classes, full_parts(), 4, false);
  tendons.seek(4, PartClasses::none, 0);
  Routing routing;
  std::uint64_t place = 0;
  std::vector<std::uint64_t> places;
  while (tendons.next(routing, place)) places.push_back(place);
  tendons.seek(4, PartClasses::none, 0);
  for (const std::uint64_t expected : places) {
    ASSERT_TRUE(tendons.next(routing, place));
    ASSERT_EQ(place, expected);
    tendons.counts_before(3, expected % 1000);
  }
}

// Bearings to join by, with a motor's end behind them or without.
Grammar::Kind pulleys(int many, bool on_motor = false) {
  Grammar::Kind kind(static_cast<std::size_t>(many), plain(TokenKind::bearing_join));
  if (on_motor) kind.push_back(motor_end());
  return kind;
}

// All there is, thing by thing. A class is twice the pulleys, and one more on the motor.
TEST(NumberedParts, SayWhatLiesBeforeAnIndexAndWhichIsNext) {
  const PartClasses classes = classes_for({"pulleys<=6"});
  Grammar grammar(identical);
  const auto few = grammar.kinds({pulleys(1), pulleys(2), pulleys(1)});
  const auto hung = grammar.part(Grammar::Form::hung, grammar.kinds({pulleys(0), pulleys(3)}),
                                 plain(TokenKind::bearing_join));
  const auto more =
      grammar.choice({grammar.choice({}), few, hung, grammar.kinds({{pulleys(0, true)}})});
  const auto pairs = grammar.multiset(more, 2);
  const auto product = grammar.both(few, grammar.part(Grammar::Form::tree, pairs));
  const auto all = grammar.choice(
      {product, grammar.multiset(grammar.sides(few, more), 3), grammar.multiset(few, 4)});
  ASSERT_EQ(grammar.size(all), 3U * 21U + 18U * 19U * 20U / 6U + 15U);
  NumberedParts numbered(classes, grammar);
  std::vector<PartClass> things;
  ClassCounts before = no_counts(classes);
  for (std::uint64_t i = 0; i < grammar.size(all); ++i) {
    ASSERT_EQ(numbered.counts_before(all, i), before) << i;
    things.push_back(numbered.parts_of(all, i));
    ++before[things.back()];
  }
  EXPECT_EQ(numbered.counts(all), before);
  for (const ClassSet wanted : {ClassSet().set(5), ClassSet().set(8).set(15), ClassSet().set(14),
                                ClassSet().set(2), ClassSet()}) {
    const auto goal = numbered.goal(wanted);
    std::optional<std::uint64_t> next;
    for (std::uint64_t i = grammar.size(all); i-- > 0;) {
      if (wanted.test(things[i])) next = i;
      const auto found = numbered.first(all, i, goal);
      ASSERT_EQ(found.has_value(), next.has_value()) << i;
      if (!found) continue;
      ASSERT_EQ(found->index, *next) << i;
      ASSERT_EQ(found->parts, things[*next]);
    }
  }
}

// Tokens by themselves: the first multisets as they are counted off.
TEST(NumberedParts, MultisetsHaveTheirGreatestFirst) {
  const PartClasses classes = classes_for({"pulleys<=12"});
  Grammar grammar(identical);
  const auto pairs = grammar.multiset(grammar.kinds({pulleys(1), pulleys(2), pulleys(4)}), 2);
  const NumberedParts numbered(classes, grammar);
  std::vector<int> many;
  for (std::uint64_t i = 0; i < grammar.size(pairs); ++i) {
    many.push_back(numbered.parts_of(pairs, i) / 2);
  }
  EXPECT_EQ(many, (std::vector<int>{2, 3, 4, 5, 6, 8}));
}

}  // namespace
}  // namespace reeve::testing
