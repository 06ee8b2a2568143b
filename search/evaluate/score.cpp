#include "search/evaluate/score.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::search {
namespace {

constexpr double greatest_weight = 1e6;

ScoreTerm parse_term(const std::string& text, const std::string& option) {
  const std::size_t equals = std::min(text.find('='), text.size());
  ScoreTerm term{parse_objective(std::string(trimmed(text.substr(0, equals))), option), 1};
  if (term.objective == Objective::score) {
    throw InputError({.where = option,
                      .what = "a score is no part of itself",
                      .expected = "other objectives",
                      .form = InputForm::unknown});
  }
  if (equals == text.size()) return term;
  const auto weight = number_in(trimmed(std::string_view(text).substr(equals + 1)));
  if (!weight || *weight <= 0 || *weight > greatest_weight) {
    throw InputError({.where = option,
                      .value = text,
                      .expected = fmt::format("a weight above 0 and at most {}, such as "
                                              "adaptability=2",
                                              greatest_weight)});
  }
  term.weight = *weight;
  return term;
}

}  // namespace

Score authors_score() {
  return {{{Objective::adaptability, 1},
           {Objective::torsional_balance, 1},
           {Objective::reliability, 1},
           {Objective::authors_efficiency, 1},
           {Objective::transmission, 1}}};
}

void add_score(const Score& score, ObjectiveValues& values) {
  double sum = 0;
  double weights = 0;
  for (const ScoreTerm& term : score.terms) {
    const double given = value(values, term.objective);
    sum += term.weight * (row(term.objective).better == Better::higher ? given : -given);
    weights += term.weight;
  }
  value(values, Objective::score) = on_grid(sum / weights);
}

Score parse_score(const std::string& text) {
  if (text == "authors") return authors_score();
  const std::string option = fmt::format("score '{}'", text);
  Score score;
  for (const std::string& item : comma_separated(text)) {
    const ScoreTerm term = parse_term(item, option);
    for (const ScoreTerm& other : score.terms) {
      if (other.objective == term.objective) {
        throw InputError({.where = option,
                          .what = fmt::format("'{}' is named twice", row(term.objective).name)});
      }
    }
    score.terms.push_back(term);
  }
  return score;
}

std::string to_text(const Score& score) {
  std::string text;
  for (const ScoreTerm& term : score.terms) {
    text += fmt::format("{}{}={}", text.empty() ? "" : ",", row(term.objective).name, term.weight);
  }
  return text;
}

}  // namespace reeve::search
