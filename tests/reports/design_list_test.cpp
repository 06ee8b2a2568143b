#include "reports/exploration/design_list.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "reports/document/document.hpp"
#include "reports/exploration/band_report.hpp"
#include "search/evaluate/shown_objectives.hpp"
#include "tests/support/has.hpp"

namespace reeve {
namespace {

// Values 0.5, 1.5, 2.5, …: each column is recognisable.
ListedDesign design(const std::string& name) {
  ListedDesign listed;
  listed.name = name;
  listed.ranked.design.word = "M-1-F";
  listed.ranked.front = 2;
  listed.ranked.rank = 3;
  for (std::size_t i = 0; i < objective_count; ++i) {
    listed.ranked.design.values[i] = 0.5 + static_cast<double>(i);
  }
  return listed;
}

ListedDesign without_hand(ListedDesign listed) {
  for (const ObjectiveRow& row : objective_table()) {
    if (row.of_hand) listed.ranked.design.values[static_cast<std::size_t>(row.objective)] = 0;
  }
  return listed;
}

std::string row_of(const std::string& name) {
  const std::string csv = design_csv({design(name)});
  return csv.substr(csv.find('\n') + 1);
}

TEST(DesignCsv, HasOneHeaderAndOneLineForEachDesign) {
  EXPECT_EQ(design_csv({without_hand(design("TR0"))}),
            "rank,front,routing,name,uniformity_mean,uniformity_worst,efficiency_mean,"
            "efficiency_worst,force_transmission,jams,jams_all,sheaths,pulleys,knots,travel,"
            "round_trip_efficiency,adaptability,torsional_balance,reliability,authors_efficiency,"
            "transmission,score,blocks,finger_uniformity_mean,finger_uniformity_worst,"
            "parts,cost,uniformity_p5,efficiency_p5,smallest_jams,same_as,place\n"
            "3,2,M-1-F,TR0,0.5,1.5,2.5,3.5,4.5,5.5,6.5,7.5,8.5,9.5,10.5,11.5,12.5,13.5,14.5,15.5,"
            "16.5,17.5,18.5,19.5,20.5,21.5,22.5,23.5,24.5,,,0\n");
}

TEST(ListNotes, SayThatSomeStrokesLeaveOutSpringsInSeries) {
  const TendonParts sprung{1000, {}, {{1, 5.0, {}}}};
  const auto says_so = [](const ListedDesign& listed, const TendonParts& tendons) {
    Document document;
    document.add({"", std::nullopt, list_notes({listed}, tendons)});
    return testing::has(text(document),
                        "Strokes leave out the stretch of springs in series where "
                        "reeve show says so");
  };
  EXPECT_TRUE(says_so(design("TR0"), sprung));
  EXPECT_FALSE(says_so(without_hand(design("TR0")), sprung));
  EXPECT_FALSE(says_so(design("TR0"), {}));
}

TEST(DesignCsv, AddsSixColumnsWithAHand) {
  const std::string csv = design_csv({design("TR0")});
  EXPECT_TRUE(testing::has(
      csv,
      ",parts,cost,uniformity_p5,efficiency_p5,motor_force,fingertip_force_mean,"
      "fingertip_force_worst,stroke,closure,motor_power,smallest_jams,same_as,place\n"));
  EXPECT_TRUE(csv.ends_with(",24.5,25.5,26.5,27.5,28.5,29.5,30.5,,,0\n"));
}

TEST(SampleCsv, HasTheColumnsOfAHandWhereThereIsOne) {
  const Design with = design("").ranked.design;
  const Design without = without_hand(design("")).ranked.design;
  EXPECT_TRUE(sample_csv({with}).ends_with(",29.5,30.5\n"));
  EXPECT_FALSE(testing::has(sample_csv({without}), "stroke"));
  EXPECT_TRUE(sample_csv({without}).ends_with(",23.5,24.5\n"));
}

TEST(DesignCsv, QuotesNamesWithCommasQuotesOrLineEnds) {
  EXPECT_TRUE(row_of("plain name").starts_with("3,2,M-1-F,plain name,0.5,"));
  EXPECT_TRUE(row_of("a,b").starts_with("3,2,M-1-F,\"a,b\",0.5,"));
  EXPECT_TRUE(row_of("a \"b\"").starts_with("3,2,M-1-F,\"a \"\"b\"\"\",0.5,"));
  EXPECT_TRUE(row_of("a\nb").starts_with("3,2,M-1-F,\"a\nb\",0.5,"));
  EXPECT_TRUE(row_of("a\rb").starts_with("3,2,M-1-F,\"a\rb\",0.5,"));
}

TEST(DesignCsv, LeavesTheNameOfANamelessDesignEmpty) {
  EXPECT_TRUE(row_of("").starts_with("3,2,M-1-F,,0.5,"));
}

TEST(DesignCsv, PutsANoteIntoACommentLineAtTheTop) {
  EXPECT_TRUE(design_csv({}, "partial: half").starts_with("# partial: half\nrank,front,"));
  EXPECT_TRUE(design_csv({}).starts_with("rank,front,"));
}

TEST(DesignCsv, AddsColumnsWithRankDistributions) {
  ListedDesign uncertain = without_hand(design(""));
  uncertain.distribution = RankDistribution{0.25, 4, 1, 9};
  const std::string csv = design_csv({uncertain});
  EXPECT_TRUE(testing::has(
      csv,
      ",efficiency_p5,first_share,rank_median,rank_p5,rank_p95,smallest_jams,same_as,place,"
      "first_shared\n"));
  EXPECT_TRUE(csv.ends_with(",24.5,0.25,4,1,9,,,0,0\n"));
}

TEST(DesignCsv, LeavesTheDistributionEmptyOfADesignThatHasNone) {
  ListedDesign uncertain = without_hand(design(""));
  uncertain.distribution = RankDistribution{0.25, 4, 1, 9};
  EXPECT_TRUE(design_csv({uncertain, without_hand(design(""))}).ends_with(",24.5,,,,,,,0,\n"));
}

TEST(DesignJson, GivesNullForAMissingNameAndADistributionOnlyIfThereIsOne) {
  ListedDesign listed = design("");
  EXPECT_TRUE(to_json(listed)["name"].is_null());
  EXPECT_FALSE(to_json(listed).contains("rank_distribution"));
  listed.distribution = RankDistribution{0.25, 4, 1, 9};
  listed.name = "TR0";
  EXPECT_EQ(to_json(listed)["name"], "TR0");
  EXPECT_EQ(to_json(listed)["rank_distribution"].dump(),
            R"({"first_share":0.25,"median":4.0,"p5":1.0,"p95":9.0,"first_shared":0.0})");
}

TEST(DesignTable, TellsOfBlocksWhereThereAreAny) {
  ListedDesign without = design("");
  without.ranked.design.values[static_cast<std::size_t>(Objective::blocks)] = 0;
  const auto told = [&](const std::vector<ListedDesign>& designs) {
    return text(design_table(designs, shown_objectives({}, authors_score()))).find("blocks") !=
           std::string::npos;
  };
  EXPECT_FALSE(told({without}));
  EXPECT_TRUE(told({without, design("")}));
}

ListedDesign costing(double cost) {
  ListedDesign listed = without_hand(design(""));
  listed.ranked.design.values[static_cast<std::size_t>(Objective::cost)] = cost;
  return listed;
}

TEST(DesignTable, HasTheDecimalsThatTellItsCosts) {
  const auto table = [](const std::vector<ListedDesign>& designs) {
    return text(design_table(designs, shown_objectives({}, authors_score())));
  };
  const std::string of_grams = table({costing(0.0021), costing(0.0115)});
  EXPECT_TRUE(testing::has(of_grams, " 0.0021\n"));
  EXPECT_TRUE(testing::has(of_grams, " 0.0115\n"));
  const std::string of_euros = table({costing(17.05), costing(0.3)});
  EXPECT_TRUE(testing::has(of_euros, " 17.05\n"));
  EXPECT_TRUE(testing::has(of_euros, "  0.30\n"));
}

TEST(BandTable, KeepsItsColumnsAlignedWithTheDashOfARange) {
  ListedDesign narrow = design("");
  narrow.distribution = RankDistribution{0.25, 4, 1, 9};
  ListedDesign wide = design("TR0");
  wide.distribution = RankDistribution{1, 100, 100, 1000};
  const std::string table = text(band_table({narrow, wide}, {Objective::uniformity_mean}));
  // The range is the last column, to the right: all lines end at one place, in code points.
  std::vector<std::size_t> widths(1, 0);
  for (const char c : table) {
    if (c == '\n') {
      widths.push_back(0);
    } else if ((c & '\xC0') != '\x80') {
      ++widths.back();
    }
  }
  ASSERT_EQ(widths.size(), 4U);
  EXPECT_EQ(widths[0], widths[1]);
  EXPECT_EQ(widths[0], widths[2]);
}

}  // namespace
}  // namespace reeve
