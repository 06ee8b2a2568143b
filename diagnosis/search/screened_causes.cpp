#include "diagnosis/search/screened_causes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "diagnosis/search/calibration.hpp"

namespace reeve::diagnosis {
namespace {

bool is_law_of_friction(const Candidate& candidate) {
  const Reach reach = candidate.effect.cause->reach();
  return reach == Reach::hardware || reach == Reach::conditions || reach == Reach::load;
}

std::vector<Candidate> not_in(const Model& model, const std::vector<Candidate>& candidates) {
  std::vector<Candidate> result;
  for (const Candidate& candidate : candidates) {
    const bool taken =
        std::any_of(model.effects.begin(), model.effects.end(),
                    [&](const Effect& effect) { return effect_name(effect) == candidate.name; });
    if (!taken) result.push_back(candidate);
  }
  return result;
}

// What no reading could show stands for something else.
bool shows(const Effect& effect, const Dataset& dataset) {
  if (!effect.subject.channel) return true;
  double least = std::numeric_limits<double>::infinity();
  double greatest = -least;
  for (const Cell& cell : dataset.cells) {
    if (dataset.data->channels[cell.channel].segment != *effect.subject.channel) continue;
    least = std::min(least, cell.measured_N);
    greatest = std::max(greatest, cell.measured_N);
  }
  return effect.cause->shows_between(least, greatest, effect);
}

}  // namespace

ScreenedCauses::ScreenedCauses(const Problem& problem, const Model& model,
                               const std::vector<Candidate>& candidates, Workers& workers)
    : problem_(problem),
      model_(model),
      workers_(workers),
      candidates_(not_in(model, candidates)),
      at_(forecast(*problem.dataset, model)),
      projection_(problem, model, at_),
      residuals_(projection_.taken_out(diagnosis::residuals(problem, at_))),
      screening_(problem, model, at_, projection_, candidates_, workers) {}

std::vector<std::size_t> ScreenedCauses::likeliest_without_size() const {
  constexpr std::size_t few = 3;
  const Model start = with_hardware_coefficients(model_);
  std::vector<std::pair<double, std::size_t>> by_misfit;
  for (std::size_t c = 0; c < candidates_.size(); ++c) {
    if (!candidates_[c].has_size()) by_misfit.emplace_back(0, c);
  }
  workers_.for_each_block(by_misfit.size(), 1, [&](const IndexBlock& block) {
    auto& [misfit_of, c] = by_misfit[block.begin];
    misfit_of = misfit(problem_, extended(start, candidates_[c].effect).model);
  });
  std::sort(by_misfit.begin(), by_misfit.end());
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < std::min(few, by_misfit.size()); ++i) {
    result.push_back(by_misfit[i].second);
  }
  return result;
}

std::vector<std::size_t> ScreenedCauses::contenders(std::size_t most, Laws laws) const {
  const std::vector<double> gains = screening_.gains(residuals_);
  std::vector<std::size_t> order(candidates_.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return gains[a] > gains[b]; });
  const std::vector<std::size_t> there_or_not = likeliest_without_size();
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::size_t c = order[i];
    const bool promising = i < most && gains[c] > 0;
    const bool always =
        (laws == Laws::always && is_law_of_friction(candidates_[c])) ||
        std::find(there_or_not.begin(), there_or_not.end(), c) != there_or_not.end();
    if (promising || always) result.push_back(c);
  }
  return result;
}

std::vector<Fit> ScreenedCauses::fit_each(const std::vector<std::size_t>& which) const {
  std::vector<Fit> fits(which.size());
  workers_.for_each_block(which.size(), 1, [&](const IndexBlock& block) {
    const std::size_t c = which[block.begin];
    const Extended with = extended(model_, candidates_[c].effect);
    Fit& best = fits[block.begin];
    best = fit(problem_, with.model, with.effect, screening_.starts(c, residuals_));
    if (!shows(best.model.effects[with.effect], *problem_.dataset)) {
      best.misfit = std::numeric_limits<double>::infinity();
    }
    if (candidates_[c].has_size() || parameter_count(model_) == 0) return;
    Fit other = fit(problem_, with_hardware_coefficients(with.model));
    if (other.misfit < best.misfit) best = std::move(other);
  });
  return fits;
}

std::size_t likeliest(const Problem& problem, const std::vector<Fit>& fits) {
  const double degrees = problem.dataset->degrees_of_freedom();
  const auto surprise = [&](const Fit& fit) {
    return degrees * std::log(fit.misfit) +
           static_cast<double>(parameter_count(fit.model)) * std::log(degrees);
  };
  const auto best = std::min_element(fits.begin(), fits.end(), [&](const Fit& a, const Fit& b) {
    return surprise(a) < surprise(b);
  });
  return static_cast<std::size_t>(best - fits.begin());
}

}  // namespace reeve::diagnosis
