#include "diagnosis/verdict/confirmation.hpp"

#include <algorithm>
#include <functional>
#include <utility>

#include "causes/term.hpp"

namespace reeve::diagnosis {
std::vector<std::string> runs_apart(const AcceptedTerm& accepted) {
  const Term* term = term_of(*accepted.effect.cause);
  return term == nullptr ? std::vector<std::string>() : term->site.runs;
}

std::string what_differs(const AcceptedTerm& accepted) {
  std::string text = accepted.effect.cause->meaning();
  for (const Alternative& other : accepted.alternatives) {
    text.append(", or ").append(other.effect.cause->meaning());
  }
  return text;
}

Model fitted_without(const Problem& seen, Model model, const std::string& name) {
  std::erase_if(model.effects, [&](const Effect& effect) { return effect_name(effect) == name; });
  return fit(seen, model).model;
}

Confirmation::Confirmation(const Dataset& training, const Model& nominal,
                           const TermSearchOptions& options, std::vector<Fold> folds,
                           Explanation& found, Workers& workers)
    : training_(training),
      nominal_(nominal),
      options_(options),
      folds_(std::move(folds)),
      found_(found),
      workers_(workers) {}

std::vector<std::string> Confirmation::remove_the_others() {
  constexpr double most = 0.5;
  for (std::size_t c = 0; c < found_.accepted.size() && !folds_.empty(); ++c) {
    found_.accepted[c].folds = share_of_folds(folds_, found_.accepted[c], c);
  }
  for (std::size_t c = found_.accepted.size(); c-- > 0;) {
    const AcceptedTerm& accepted = found_.accepted[c];
    if (accepted.folds.value_or(1) <= most || stands_at_an_end(accepted)) drop(c);
  }
  if (folds_.empty()) return not_confirmed_;
  keep_what_is_named();
  for (std::size_t c = found_.accepted.size(); c-- > 0;) {
    if (!runs_apart(found_.accepted[c]).empty()) continue;
    const Forecast less = without(effect_name(found_.accepted[c].effect));
    if (is_worse_on_unseen_runs(less, less)) drop(c);
  }
  if (!lose_on_unseen_runs()) return not_confirmed_;
  while (!found_.accepted.empty()) drop(found_.accepted.size() - 1);
  return not_confirmed_;
}

bool Confirmation::lose_on_unseen_runs() const {
  const bool forecasts = std::ranges::any_of(
      found_.accepted, [](const AcceptedTerm& of) { return runs_apart(of).empty(); });
  return forecasts && is_worse_on_unseen_runs(joined(folds_, training_, &Fold::base),
                                              joined(folds_, training_, &Fold::nominal));
}

// Terms that a fold alone has are no part of the answer, whose gain they would add to. The fold may
// have found them in the place of named ones, so it gets those that it lacks.
void Confirmation::keep_what_is_named() {
  const auto is_named = [this](const AcceptedTerm& of_fold) {
    return std::ranges::any_of(found_.accepted, [&](const AcceptedTerm& accepted) {
      return stands_for(of_fold.effect, accepted);
    });
  };
  for (Fold& fold : folds_) {
    std::vector<AcceptedTerm>& of_fold = fold.found.accepted;
    if (std::ranges::all_of(of_fold, is_named)) continue;
    Model model = fold.found.model;
    for (const AcceptedTerm& term : of_fold) {
      if (!is_named(term)) model = reeve::diagnosis::without(model, place(model, term.effect));
    }
    std::erase_if(of_fold, std::not_fn(is_named));
    for (const AcceptedTerm& accepted : found_.accepted) {
      if (its_name_in(model, effect_name(accepted.effect)).empty()) {
        add_effect(model, accepted.effect);
        of_fold.push_back(accepted);
      }
    }
    fold.found.model = fit(problem(fold.seen, fold.found.scatter, model, workers_), model).model;
    fold.forecast = try_forecast(fold.unseen, fold.found.model).value_or(fold.base);
  }
  without_.clear();
}

void Confirmation::drop(std::size_t cause) {
  not_confirmed_.insert(not_confirmed_.begin(), effect_name(found_.accepted[cause].effect));
  found_ = without_term(training_, found_, cause, options_, workers_);
  keep_what_is_named();
}

// A size at an end of its range may be another one in truth, and the cause another with it.
bool Confirmation::stands_at_an_end(const AcceptedTerm& accepted) const {
  constexpr double near = 1e-3;  // share of the range
  const Effect& effect = found_.model.effects[place(found_.model, accepted.effect)];
  const auto parameters =
      searched_parameters(*effect.cause, nominal_.hardware, force_scale(*training_.data));
  if (parameters.empty() || parameters.front().ends_by_nature) return false;
  const Range range = parameters.front().range;
  const double margin = near * (range.high - range.low);
  const double size = effect.values.front();
  return size <= range.low + margin || size >= range.high - margin;
}

// The models of the folds: in likelihood than `likely`, or in residuals than `near`, each reading
// by its own noise. In newtons, what pulling does would drown in what is left of releasing.
bool Confirmation::is_worse_on_unseen_runs(const Forecast& likely, const Forecast& near) const {
  // About 0 they say nothing: what they know of a cause may all stand in one run.
  constexpr double refuted = -2;
  constexpr double same = 1.02;
  const Forecast after = beside_runs_apart(joined(folds_, training_, &Fold::forecast));
  const auto misfit_of = [&](const Forecast& at) {
    return robust_misfit(residuals(found_.problem, at));
  };
  const auto size_of = [&](const Forecast& at) { return own_residuals(found_.problem, at).norm(); };
  return (misfit_of(beside_runs_apart(likely)) - misfit_of(after)) / 2 < refuted ||
         size_of(after) > same * size_of(beside_runs_apart(near));
}

const Forecast& Confirmation::without(const std::string& name) {
  const auto known = without_.find(name);
  if (known != without_.end()) return known->second;
  const auto of_fold = [&](const Fold& fold) {
    const std::string its = its_name_in(fold.found.model, name);
    if (its.empty()) return fold.forecast;
    const Problem seen = problem(fold.seen, fold.found.scatter, fold.found.model, workers_);
    return try_forecast(fold.unseen, fitted_without(seen, fold.found.model, its))
        .value_or(fold.nominal);
  };
  return without_.emplace(name, joined(folds_, training_, of_fold)).first->second;
}

// Empty if the model has neither a cause of this name nor one that stands for it and is no other
// accepted one.
std::string Confirmation::its_name_in(const Model& model, const std::string& name) const {
  const AcceptedTerm* accepted = find_accepted(name);
  std::string stand_in;
  for (const Effect& effect : model.effects) {
    std::string own = effect_name(effect);
    if (own == name) return own;
    if (stand_in.empty() && accepted != nullptr && stands_for(effect, *accepted) &&
        find_accepted(own) == nullptr) {
      stand_in = std::move(own);
    }
  }
  return stand_in;
}

const AcceptedTerm* Confirmation::find_accepted(const std::string& name) const {
  for (const AcceptedTerm& accepted : found_.accepted) {
    if (effect_name(accepted.effect) == name) return &accepted;
  }
  return nullptr;
}

// Readings of runs that follow a law of their own are no model's to forecast.
Forecast Confirmation::beside_runs_apart(Forecast at) const {
  const MeasuredData& data = *training_.data;
  for (std::size_t i = 0; i < training_.cells.size(); ++i) {
    const Cell& cell = training_.cells[i];
    const std::string& run = data.runs[data.readings[cell.reading].run];
    const bool is_apart = std::ranges::any_of(found_.accepted, [&](const AcceptedTerm& of) {
      const std::vector<std::string> apart = runs_apart(of);
      return std::ranges::find(apart, run) != apart.end();
    });
    if (is_apart) at.reading_N[static_cast<Eigen::Index>(i)] = cell.measured_N;
  }
  return at;
}

}  // namespace reeve::diagnosis
