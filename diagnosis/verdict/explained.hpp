// How much of the residuals each named term explains.
//
// The terms are added one after the other to the nominal model, and those that it has are fitted
// anew each time: always the one next that leaves the least mean square m of the residuals in
// newton. At their sizes in the extended model, terms that work against each other would each leave
// more than there was. A term that takes m_{k−1} to m_k explains √(m_{k−1} − m_k) newton, and the
// share (m_{k−1} − m_k) / m of the nominal model's m. One that raises m, so that others can let it
// fall, has the mean of theirs and its own. The last leaves what the extended model does: shares
// add up, and do not depend on the order in which terms were found.
#pragma once

#include <vector>

#include "causes/model.hpp"
#include "diagnosis/chosen_readings.hpp"
#include "diagnosis/fit/problem.hpp"

namespace reeve::diagnosis {

struct Explained {
  double rms_N = 0;  // below 0 of a term that raises the residuals
  double share = 0;  // share of the mean square
};

struct ExplainedResiduals {
  double before_N = 0;           // root of the mean squared residual of the nominal model
  double after_N = 0;            // root of the mean squared residual of the extended model
  std::vector<Explained> terms;  // parallel to those that were asked for
};

// Terms that the extended model has, whatever else it has. Training and held-out runs together. The
// problem is that of the training runs; what runs do that stand `apart` is fitted beside the terms,
// and left in the residuals.
ExplainedResiduals explained_residuals(const Sample& sample, const Problem& problem,
                                       const Model& nominal, const Model& extended,
                                       const std::vector<Effect>& terms,
                                       const std::vector<Effect>& apart = {});

}  // namespace reeve::diagnosis
