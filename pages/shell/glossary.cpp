#include "pages/shell/glossary.hpp"

#include <fmt/format.h>

#include <string_view>

#include "pages/page_words.hpp"
#include "pages/shell/template.hpp"

namespace reeve::pages {

std::vector<GlossaryTerm> ranking_terms() {
  return {{"front",
           "1: the Pareto front, designs that no other beats in all that the ranking counts; 2: "
           "the front of what is then left, and so on"},
          {"alike",
           "further designs of the list that differ in bearings alone, which change nothing of "
           "what the ranking counts"},
          {"known routing", "one that has a name, from print"}};
}

std::vector<GlossaryTerm> tradeoff_terms() {
  return {{"gain", "improvement over the line above"},
          {"kept", "value relative to the first design, in the ranked objective that loses most"},
          {"knee",
           "where the trade-off bends: the line that stands highest above the chord between its "
           "ends; a hint, since it depends on where the trade-off ends"},
          {"within …", "the design with least of the measure that loses no more than this"}};
}

std::vector<GlossaryTerm> routing_terms() {
  return {
      {"strand", "one of the two lengths of tendon along a finger: T1, T2 at finger 1, and so on"},
      {"held", "a finger that an object stops; the others close on"},
      {"jam", "no finger of some tendon can move, and the carriage is blocked"},
      {"slides",
       "a contact where the tendon moves over a tube, sheath or pulley; friction "
       "makes the tension fall in that direction"}};
}

std::vector<GlossaryTerm> objective_terms(const std::vector<Objective>& objectives) {
  std::vector<GlossaryTerm> terms;
  for (const Objective objective : objectives) {
    const ObjectiveRow& about = row(objective);
    const std::string unit =
        about.unit == std::string_view("1") ? "" : fmt::format(", {}", about.unit);
    terms.push_back(
        {objective_title(about), fmt::format("{}{} ({} is better)", about.meaning, unit,
                                             about.better == Better::higher ? "higher" : "lower")});
  }
  return terms;
}

std::string glossary_html(const std::string& about, const std::vector<GlossaryTerm>& terms) {
  const Json list = list_json(terms, [](const GlossaryTerm& term) {
    return Json{{"word", term.word}, {"meaning", term.meaning}};
  });
  return render("glossary.mustache", {{"about", about}, {"terms", list}});
}

}  // namespace reeve::pages
