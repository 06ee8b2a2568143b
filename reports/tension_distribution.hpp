// Strand tensions of several routings as shares of their sum, the model's beside what is published
// and what was measured: the figure with which the Exo-Glove II supplement sums up (its Fig. 9).
//
// "All simulation results were normalized so that the sum of T1 and T4 is equal to 1" (section I).
// Its tables give shares of the sum of T1 to T4, "Ratio", and so does this. Its two friction
// coefficients, 0.18 and 0.09, are "of Teflon tube": here of tubes and sheaths alike, which are
// both lined with Teflon. The paper does not say whether it changed both (docs/diagnosis.md).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "diagnosis/note.hpp"
#include "reports/json.hpp"

namespace reeve {

struct PublishedShare {
  double share = 0;
  std::string fault;  // why the check does not find it; "" where it does
};

struct MeasuredShare {
  double mean = 0;
  std::optional<double> deviation;  // standard deviation over the readings; none of one reading
};

struct StrandShare {
  std::string strand;
  double model = 0;  // NaN if all strands are slack
  std::optional<PublishedShare> published;
  std::optional<MeasuredShare> measured;
};

struct RoutingShares {
  std::string word;
  std::string name;              // "" if it has none
  std::string published_source;  // "Table IV"; "" if nothing is published in this grasp
  std::size_t readings = 0;
  std::vector<StrandShare> strands;
};

// At one friction coefficient and in one grasp, pulling.
struct TensionDistribution {
  double mu = 0;
  Grasp grasp;
  std::vector<RoutingShares> routings;  // in the order in which they were asked for
  // Root of the mean squared difference between measured and model; none without measured ones.
  std::optional<double> rms_measured;
};

// The data behind the measured shares.
struct SharedData {
  std::string file;
  bool simulated = false;
  std::vector<DataNote> notes;  // on the data, and on what of them is not in the shares
};

struct TensionDistributions {
  std::vector<TensionDistribution> list;  // grasp by grasp, in each by coefficient
  std::optional<SharedData> data;
  std::uint64_t unconverged = 0;  // tension solves
};

Json to_json(const TensionDistribution& distribution);
Json to_json(const SharedData& data);

}  // namespace reeve
