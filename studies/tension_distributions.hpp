// Strand tensions of several routings as shares of their sum, the model's beside what is published
// and what was measured: the figure with which the Exo-Glove II supplement sums up (its Fig. 9).
//
// "All simulation results were normalized so that the sum of T1 and T4 is equal to 1" (section I).
// Its tables give shares of the sum of T1 to T4, "Ratio", and so does this. Its two friction
// coefficients, 0.18 and 0.09, are "of Teflon tube": here of tubes and sheaths alike, which are
// both lined with Teflon.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/grasp.hpp"
#include "core/routing.hpp"
#include "diagnosis/diagnose.hpp"
#include "readings/measured_data.hpp"
#include "studies/published_models.hpp"

namespace reeve::studies {

enum class FrictionKind : std::uint8_t {
  coefficient,  // one coefficient of tubes and sheaths alike
  model,        // the model's own
  diagnosed,    // the model's own, which a diagnosis has fitted
};

// A model of which the shares are asked.
struct FrictionCase {
  FrictionKind kind = FrictionKind::model;
  Model model;
};

// In place of the hardware's coefficients of tubes and sheaths and of effects on them. The
// hardware's own values of one finger or one contact stay.
FrictionCase with_coefficient(Model model, double mu);

struct DistributionRequest {
  std::vector<Routing> routings;  // as many fingers each
  std::vector<FrictionCase> cases;
  std::optional<MeasuredData> data;
};

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
  std::string published_source;  // "Table IV"; "" if nothing is published of this case
  std::size_t readings = 0;
  std::vector<StrandShare> strands;
};

// √ Σ (share − share)² over the strands, averaged over the routings that have both.
struct MeanShareErrors {
  std::optional<double> model;      // model against measurement
  std::optional<double> published;  // publication against measurement
};

// Distribution of one case in one grasp, pulling.
struct TensionDistribution {
  FrictionKind kind = FrictionKind::model;
  double tube_mu = 0;
  double sheath_mu = 0;
  std::vector<std::string> other_effects{};  // names of those on other than these coefficients
  bool sensors_differ = false;  // by the case; the shares are those of the tensions themselves
  Grasp grasp;
  std::vector<RoutingShares> routings;  // in the order in which they were asked for
  // Root of the mean squared difference between measured and model; none without measured ones.
  std::optional<double> rms_measured;
  MeanShareErrors share_errors;
};

// The data behind the measured shares.
struct SharedData {
  std::string file;
  bool simulated = false;
  std::vector<DataNote> notes;  // on the data, and on what of them is not in the shares
};

struct TensionDistributions {
  std::vector<TensionDistribution> list;  // grasp by grasp, in each by case
  std::optional<SharedData> data;
  std::uint64_t unconverged = 0;  // tension solves
};

// In the paper's grasp, finger 1 held (with one finger: none), and in those of the data. Throws
// InputError if the data have nothing to show of these routings, or a case has no tensions.
TensionDistributions tension_distributions(const DistributionRequest& request,
                                           const Catalogue& catalogue);

// The same in the grasps of the data alone.
TensionDistributions measured_distributions(const DistributionRequest& request,
                                            const Catalogue& catalogue);

// The tension distributions of readings before and after their diagnosis: as the model stands, or,
// where publications draw the same routings, with the coefficients that they assume; and with what
// was diagnosed.
// Of the data's routings with as many fingers as the first that has shares, in their grasps.
// Nothing if no pulled reading has all strands, or a model has no tensions in one of the grasps.
std::optional<TensionDistributions> diagnosed_distributions(
    const MeasuredData& data, const Hardware& hardware, const DiagnosisResult& result,
    const std::vector<PublishedModel>& published, const Catalogue& catalogue);

}  // namespace reeve::studies
