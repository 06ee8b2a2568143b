// Published models of the catalogue beside readings of the same routings in the same grasps: errors
// of the lines as printed and of the equations with the same coefficient, and the differences
// between lines and equations.
#pragma once

#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "diagnosis/diagnose.hpp"
#include "readings/measured_data.hpp"

namespace reeve::studies {

// One stretch of the diagnosis' losses (diagnosis/verdict/losses.hpp) as the lines have it.
struct PublishedLoss {
  std::size_t loss = 0;   // in DiagnosisResult::losses
  double printed = 0;     // ln of the ratio of the printed shares
  double equations = 0;   // ln of the ratio by the equations with the lines' coefficient
  int sheaths = 0;        // losses e^{-phi_s} that the equations have there,
  int sheaths_drawn = 0;  // and the lines, by the fault that is listed
};

struct PublishedLine {
  std::size_t group = 0;  // in ShareErrors::groups
  std::string source;     // "Table IV"
  std::vector<double> shares;
  double error = 0;  // √ Σ (share − share)², mean over the group's rows, of the lines as printed,
  double equations = 0;  // and of what the equations give
};

struct PublishedModel {
  std::string name;  // "Table I to Table VII", "Table I, Table IV", "Fig. 9 (b)"
  double mu = 0;     // μ of tubes and sheaths
  std::vector<PublishedLine> lines;
  double error = 0;  // means over the lines
  double equations = 0;
  std::vector<PublishedLoss> losses;  // losses in which lines and equations differ
};

// Returns the models by coefficient, the greatest first. Empty if no group of the diagnosis' share
// errors is published, or the data are simulated.
std::vector<PublishedModel> published_models(const Catalogue& catalogue, const MeasuredData& data,
                                             const DiagnosisResult& result);

}  // namespace reeve::studies
