// The models that a diagnosis weighs against each other: that of the named causes, and with each
// rival in the place of the cause that it would stand for.
#pragma once

#include <string>
#include <vector>

#include "diagnosis/search/rivals.hpp"

namespace reeve::diagnosis {

struct WeighedModel {
  std::vector<std::string> causes;
  Model model;
  double gain = 0;  // in log-likelihood on the training runs, over the nominal model
};

// `rivals` is parallel to the causes, whose names these are. Of several models of the same causes
// only the first. Empty without causes.
std::vector<WeighedModel> weighed_models(const Problem& problem, const Model& nominal,
                                         const Model& extended,
                                         const std::vector<std::string>& causes,
                                         const std::vector<std::vector<Rival>>& rivals);

}  // namespace reeve::diagnosis
