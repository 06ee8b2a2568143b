#include "cli/ranked_routings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>
#include <utility>

#include "cli/inputs.hpp"
#include "core/error.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "reports/document/document.hpp"

namespace reeve::cli {
namespace {

constexpr double greatest_mu = 1;
constexpr std::size_t most_cases = 6;

FrictionCase read_case(const std::string& item, const Model& model) {
  if (item == "model") return {FrictionKind::model, model};
  const auto mu = number_in(item);
  if (!mu || *mu < 0 || *mu > greatest_mu) {
    throw InputError(
        {.value = item,
         .expected = "friction coefficients from 0 to 1, or 'model', such as 0.18,0.09,model"});
  }
  FrictionCase result = with_coefficient(model, *mu);
  validate(effective_hardware(result.model));
  return result;
}

[[noreturn]] void fail_without(int fingers, const std::string& expected,
                               const std::set<int>& numbers) {
  throw InputError(
      {.what = "--fingers",
       .value = fmt::format("{}", fingers),
       .expected = fmt::format("as many as {} has: {}", expected, fmt::join(numbers, ", "))});
}

// Mechanisms share words; each is ranked once.
std::vector<Routing> mechanisms_of(const std::string& family, int fingers,
                                   const Catalogue& catalogue) {
  std::vector<Routing> result;
  std::set<std::string> words;
  std::set<int> others;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (mechanism.family != family) continue;
    const int own = finger_count(mechanism.routing);
    others.insert(own);
    if (own == fingers && words.insert(to_word(mechanism.canonical)).second) {
      result.push_back(mechanism.routing);
    }
  }
  if (result.empty()) {
    fail_without(fingers, "a mechanism of the family " + family, others);
  }
  return result;
}

std::vector<Routing> catalogued(const AskedRoutings& asked, int fingers,
                                const Catalogue& catalogue) {
  const std::string family = asked.family.value_or(paper_family);
  if (family != paper_family) return mechanisms_of(family, fingers, catalogue);
  std::vector<Routing> result;
  std::set<int> numbers;
  for (const CatalogueEntry& entry : catalogue.entries) {
    numbers.insert(finger_count(entry.routing));
    if (finger_count(entry.routing) == fingers) result.push_back(entry.routing);
  }
  if (result.empty() && asked.given.empty()) {
    fail_without(fingers, "a routing of the family " + family, numbers);
  }
  return result;
}

}  // namespace

std::vector<FrictionCase> read_friction_cases(const std::string& text, const Model& model) {
  return for_option(fmt::format("--distribution-mu '{}'", text), [&] {
    std::vector<FrictionCase> cases;
    std::set<std::pair<FrictionKind, double>> seen;
    for (const std::string& item : comma_separated(text)) {
      cases.push_back(read_case(item, model));
      const FrictionCase& last = cases.back();
      const double mu =
          last.kind == FrictionKind::coefficient ? last.model.hardware.tube.mu : greatest_mu;
      if (!seen.emplace(last.kind, mu).second) {
        throw InputError(fmt::format("{} is given twice", item));
      }
    }
    if (cases.size() > most_cases) {
      throw InputError({.expected = fmt::format("at most {} of them", most_cases)});
    }
    return cases;
  });
}

std::vector<Routing> ranked_routings(const AskedRoutings& asked, const Catalogue& catalogue) {
  std::vector<Routing> result;
  for (const std::string& text : asked.given) {
    result.push_back(read_actuated_routing(text, catalogue));
  }
  if (asked.catalogued) {
    const int fingers = result.empty() ? asked.fingers : finger_count(result.front());
    append(result, catalogued(asked, fingers, catalogue));
  }
  if (result.empty()) {
    throw InputError({.where = "rank",
                      .what = "nothing to rank",
                      .expected = "routings, --catalogue or --store",
                      .form = InputForm::unknown});
  }
  GivenRoutings given;
  for (const Routing& routing : result) {
    const std::string word = to_word(routing);
    if (finger_count(routing) == 0) {
      throw InputError({.where = fmt::format("routing '{}'", word),
                        .what = "it has no fingers, so there is nothing to rank"});
    }
    if (finger_count(routing) != finger_count(result.front())) {
      throw InputError(
          {.where = fmt::format("routing '{}'", word),
           .what = fmt::format("it has {} finger{} and '{}' has {}; only routings with the same "
                               "number of fingers can be compared",
                               finger_count(routing), finger_count(routing) == 1 ? "" : "s",
                               to_word(result.front()), finger_count(result.front()))});
    }
    given.add(routing);
  }
  return result;
}

void name_by(const std::string& family, Catalogue& catalogue) {
  std::stable_partition(catalogue.mechanisms.begin(), catalogue.mechanisms.end(),
                        [&](const Mechanism& mechanism) { return mechanism.family == family; });
}

}  // namespace reeve::cli
