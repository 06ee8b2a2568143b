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

std::vector<Effect> candidates(const Survey& survey, const Hardware& hardware, double force_scale) {
  std::vector<Effect> result;
  for (const Cause* cause : cause_library()) {
    const ContactLaw* law = cause->law(hardware);
    if (law != nullptr && law->known) continue;
    std::vector<double> values;
    for (const Parameter& parameter : searched_parameters(*cause, hardware, force_scale)) {
      values.push_back(nominal_or_middle(parameter));
    }
    for (const Subject& subject : cause->subjects(survey)) {
      result.push_back({cause, subject, values});
    }
  }
  return result;
}

std::vector<std::vector<double>> shapes(const Effect& candidate,
                                        const std::vector<Parameter>& parameters) {
  std::vector<std::vector<double>> result{candidate.values};
  for (std::size_t p = 1; p < parameters.size(); ++p) {
    const Range range = parameters[p].range;
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

}  // namespace reeve::diagnosis
