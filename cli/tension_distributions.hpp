// Solves what the figure of tension distributions shows (reports/tension_distribution.hpp).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "causes/model.hpp"
#include "core/routing.hpp"
#include "diagnosis/measured_data.hpp"
#include "reports/tension_distribution.hpp"

namespace reeve::cli {

struct DistributionRequest {
  std::vector<Routing> routings;  // as many fingers each
  Model model;
  // Friction coefficients of tubes and sheaths alike, in place of the hardware's. What the hardware
  // says of one finger or one contact stays.
  std::vector<double> mu{0.18, 0.09};
  std::optional<MeasuredData> data;
};

// "0.18,0.09". Throws InputError.
std::vector<double> parse_coefficients(const std::string& text);

// In the paper's grasp, finger 1 held (with one finger: none), and in those of the data. Throws
// InputError if the data have nothing to show of these routings.
TensionDistributions tension_distributions(const DistributionRequest& request,
                                           const Catalogue& catalogue);

}  // namespace reeve::cli
