#include "diagnosis/search/candidates.hpp"

#include <cmath>

#include "causes/library.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {
namespace {

// Number of starts across the range of a law whose shape no first order determines.
constexpr int shapes_tried = 5;

double nominal_or_middle(const Parameter& parameter) {
  return parameter.nominal.value_or(std::sqrt(parameter.range.low * parameter.range.high));
}

}  // namespace

std::vector<Candidate> candidates(const Survey& survey, const Hardware& hardware,
                                  double force_scale) {
  std::vector<Candidate> result;
  for (const Cause* cause : cause_library()) {
    const ContactLaw* law = cause->law(hardware);
    if (law != nullptr && law->known) continue;
    for (const Subject& subject : cause->subjects(survey)) {
      Candidate candidate{
          {cause, subject, {}}, searched_parameters(*cause, hardware, force_scale), {}};
      for (const Parameter& parameter : candidate.parameters) {
        candidate.effect.values.push_back(nominal_or_middle(parameter));
      }
      candidate.name = effect_name(candidate.effect);
      result.push_back(std::move(candidate));
    }
  }
  return result;
}

std::vector<std::vector<double>> shapes(const Candidate& candidate) {
  std::vector<std::vector<double>> result{candidate.effect.values};
  for (std::size_t p = 1; p < candidate.parameters.size(); ++p) {
    const Range range = candidate.parameters[p].range;
    std::vector<std::vector<double>> finer;
    for (const std::vector<double>& values : result) {
      for (int i = 0; i < shapes_tried; ++i) {
        finer.push_back(values);
        finer.back()[p] = range.low * std::pow(range.high / range.low, (i + 0.5) / shapes_tried);
      }
    }
    result = std::move(finer);
  }
  return result;
}

std::string detail(const Effect& effect) {
  const Subject& subject = effect.subject;
  if (!subject.recorded || !subject.actual) return {};
  return "recorded " + to_text(*subject.recorded) + ", measured " + to_text(*subject.actual);
}

}  // namespace reeve::diagnosis
