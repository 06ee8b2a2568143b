// Confirmation of what a search has accepted, by the folds (folds.hpp).
//
// A term stays that holds in most folds, whose size is known, and without which the models of the
// folds lose on the runs that they have not seen. None stays if these models together lose there
// against coefficients alone. Then these models keep the terms that stay, or what stands for them
// in a fold, and their gain is that of the answer. Runs apart are of no model that forecasts
// others.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/verdict/folds.hpp"

namespace reeve::diagnosis {

// The run that a term is about by itself; empty of what is about more than one.
std::string run_apart(const AcceptedTerm& accepted);
// "gain of motor in run 3, or exponent of sheath in run 3": the term, and what might as well be in
// its place.
std::string what_differs(const AcceptedTerm& accepted);

// The model without the effects of this name, fitted.
Model fitted_without(const Problem& seen, Model model, const std::string& name);

// A group that follows a law of its own, by the search on all runs: "gain of T2 in group B".
struct GroupApart {
  std::string text;
  double evidence = 0;
};

class Confirmation {
 public:
  // All but the folds must outlive it; `found` is what the search on all runs has found.
  Confirmation(const Dataset& training, const Model& nominal, const TermSearchOptions& options,
               std::vector<Fold> folds, Explanation& found, Workers& workers);

  // Removes from what was found what is not confirmed, and what is of one group. Returns the names
  // of the former.
  std::vector<std::string> remove_the_others();

  // Returns the most evident of what was removed since it is of one group.
  const std::optional<GroupApart>& group_apart() const { return group_apart_; }

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
  std::optional<GroupApart> group_apart_;
  std::map<std::string, Forecast> without_;  // by the name of a cause
};

}  // namespace reeve::diagnosis
