// Confirmation of what a search has accepted, by the folds (folds.hpp).
//
// A term stays that holds in most folds, whose size is known, and without which the models of the
// folds lose on the runs that they have not seen. None stays if these models together lose there
// against coefficients alone. Then these models keep the terms that stay, or what stands for them
// in a fold, and their gain is that of the answer. Runs apart are of no model that forecasts
// others.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "diagnosis/verdict/folds.hpp"

namespace reeve::diagnosis {

// The runs that a term is about alone; none of what is about all.
std::vector<std::string> runs_apart(const AcceptedTerm& accepted);
// "gain of motor in run 3, or exponent of sheath in run 3": the term, and what might as well be in
// its place.
std::string what_differs(const AcceptedTerm& accepted);

// The model without the effects of this name, fitted.
Model fitted_without(const Problem& seen, Model model, const std::string& name);

class Confirmation {
 public:
  // All but the folds must outlive it; `found` is what the search on all runs has found.
  Confirmation(const Dataset& training, const Model& nominal, const TermSearchOptions& options,
               std::vector<Fold> folds, Explanation& found, Workers& workers);

  // Removes from what was found what is not confirmed. Returns the names.
  std::vector<std::string> remove_the_others();

  const std::vector<Fold>& folds() const { return folds_; }

  // Returns the forecasts of the folds' models without the cause of this name, or without what they
  // have in its place.
  const Forecast& without(const std::string& name);

 private:
  void keep_what_is_named();
  bool lose_on_unseen_runs() const;
  void drop(std::size_t cause);
  bool stands_at_an_end(const AcceptedTerm& accepted) const;
  bool is_worse_on_unseen_runs(const Forecast& likely, const Forecast& near) const;
  Forecast beside_runs_apart(Forecast at) const;
  std::string its_name_in(const Model& model, const std::string& name) const;
  const AcceptedTerm* find_accepted(const std::string& name) const;

  const Dataset& training_;
  const Model& nominal_;
  const TermSearchOptions& options_;
  std::vector<Fold> folds_;
  Explanation& found_;
  Workers& workers_;
  std::vector<std::string> not_confirmed_;
  std::map<std::string, Forecast> without_;  // by the name of a cause
};

}  // namespace reeve::diagnosis
