// The causes that the data could show, each about each of its subjects, before anything is fitted.
#pragma once

#include <string>
#include <vector>

#include "causes/cause.hpp"
#include "causes/model.hpp"

namespace reeve::diagnosis {

struct Candidate {
  Effect effect;  // at its nominal size, which changes nothing; without size, as it is
  std::vector<Parameter> parameters;
  std::string name;  // "wrong_grasp[M-1-T-2-F]" has several candidates: one for each pair of grasps

  bool has_size() const { return !parameters.empty(); }
};

// A coefficient that the hardware knows is none of them. `force_scale` as of the data
// (dataset.hpp).
std::vector<Candidate> candidates(const Survey& survey, const Hardware& hardware,
                                  double force_scale = 1);

// Values at which the law of a candidate with parameters of shape is tried: the size is nominal.
std::vector<std::vector<double>> shapes(const Candidate& candidate);

// For a person: "recorded 1, measured 2" of wrong_grasp; otherwise empty.
std::string detail(const Effect& effect);

}  // namespace reeve::diagnosis
