// Names of figures, and what stands beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "core/notation.hpp"
#include "pages/figures.hpp"
#include "pages/routing_parts.hpp"
#include "tests/studies/shipped_catalogue.hpp"

namespace reeve::testing {
namespace {

using Stems = std::vector<std::string>;

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

TEST(FigureNames, AreTheNameOrTheWordAndTheGrasp) {
  EXPECT_EQ(file_stems({{"TR6", "1-T-2-P-1"}, {"", "M-1-F+M-2-F"}, {"", "M-W1/2:1+W1-1"}}),
            (Stems{"TR6", "M-1-F_M-2-F", "M-W1_2_1_W1-1"}));
  EXPECT_EQ(schematic_name("TR6", hold({1, 3})), "TR6-held-1-3");
  EXPECT_EQ(schematic_name("TR6", Grasp{}), "TR6-held-none");
}

TEST(FigureNames, AreUniqueWhateverTheCaseAndTheCharactersReplaced) {
  const Stems stems = file_stems({{"glove", "M-1-F"},
                                  {"Glove", "M-2-F"},
                                  {"gl/ve", "a"},
                                  {"gl:ve", "b"},
                                  {"gl_ve-2", "c"},
                                  {"", "M-1-F+M-2-F"},
                                  {"", "M-1-F M-2-F"},
                                  {"tensions", "d"},
                                  {"Figure-9", "e"},
                                  {"", ""},
                                  {"μ", "f"},
                                  {"../../etc/passwd", "g"},
                                  {"-rf", "h"},
                                  {std::string(400, 'x'), "i"},
                                  {std::string(401, 'x'), "j"}});
  std::set<std::string> folded{"tensions", "figure-9"};
  for (const std::string& stem : stems) {
    EXPECT_TRUE(folded.insert(lower(stem)).second) << stem;
    EXPECT_FALSE(stem.empty());
    EXPECT_NE(stem.front(), '-');
    EXPECT_LT(stem.size(), 150U);
    for (const char c : stem) {
      EXPECT_TRUE((std::isalnum(static_cast<unsigned char>(c)) != 0 && (c & 0x80) == 0) ||
                  c == '-' || c == '_')
          << stem;
    }
  }
  EXPECT_EQ(stems[1], "Glove-2");
  EXPECT_EQ(stems[3], "gl_ve-2");
  EXPECT_EQ(stems[4], "gl_ve-2-2");
}

TEST(FigureNames, OfMechanismsThatShareANameHaveTheirWordsBeside) {
  EXPECT_EQ(file_stems({{"Hand", "M-1-F"}, {"Hand", "M-1-M"}}),
            (Stems{"Hand_M-1-F", "Hand_M-1-M"}));
}

TEST(GraspWords, NameTheHeldFingers) {
  EXPECT_EQ(grasp_words(Grasp{}), "no finger held");
  EXPECT_EQ(grasp_words(hold({2})), "finger 2 held");
  EXPECT_EQ(grasp_words(hold({1, 3})), "fingers 1, 3 held");
}

ShownRouting solved(const std::string& word, const Hardware& hardware) {
  return shown_routing(parse_routing(word), {hardware}, {{hold({1}), 1}}, Direction::pull,
                       shipped_catalogue());
}

TEST(FigureCaptions, SayWhatOfWhichPartsAndThatItWasComputed) {
  Hardware hardware;
  hardware.tube.mu = 0.0625;
  hardware.fingers.push_back({2, {}, {}, {}, 4.5, {}, 1});
  const ShownRouting shown = solved("1-T-2-P-1", hardware);
  const FigureFile file = schematic_file("TR6-held-1", shown, shown.grasps.front());
  EXPECT_EQ(file.id, "TR6-held-1");
  for (const char* part :
       {"Routing TR6 (1-T-2-P-1) with finger 1 held, the carriage pulling: simulated tensions",
        "0.0625 (tubes), 0.18 (sheaths) and 0.001 (bearings)", "; finger 2: sheaths 4.5 rad",
        "computed with reeve ", "not measured.\n"}) {
    EXPECT_NE(file.caption.find(part), std::string::npos) << part << "\n" << file.caption;
  }
  EXPECT_EQ(std::count(file.caption.begin(), file.caption.end(), '\n'), 1);
}

TEST(FigureCaptions, SayWhereARoutingJamsAndThatAModelHasEffects) {
  ShownRouting shown = solved("M-1-F+M-2-F", {});
  EXPECT_NE(schematic_caption(shown, shown.grasps.front()).find("(it jams)"), std::string::npos);
  Hardware& hardware = shown.model.hardware;
  hardware.contacts.resize(1);
  EXPECT_NE(coefficients_text(shown.model).find(", others at 1 contact"), std::string::npos);
  EXPECT_EQ(coefficients_text(shown.model).find("contacts"), std::string::npos);
  shown.model.effects.resize(2);
  EXPECT_NE(coefficients_text(shown.model).find("and 2 effects of a model"), std::string::npos);
}

}  // namespace
}  // namespace reeve::testing
