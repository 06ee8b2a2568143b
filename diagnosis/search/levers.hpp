// Levers: changes of every reading by a small change of the rig. The contacts' exponents and forces
// change, and the gains and offsets of channels and motor. A term's sensitivity is that of its
// site, times the law of its covariate in each row, so that any number of terms costs products
// alone:
//
//   exponent  sum over the site's contacts of dy/dphi_k, times phi_k at tubes and sheaths
//   force     sum of dy/dphi_k e^{phi_k} / T_high,k, since e^{-phi'} = e^{-phi} - F / T_high
//   gain      y of a channel, or dy/dT_M T_M of the motor's pull
//   offset    1, or dy/dT_M; a force at the motor is an offset that turns its sign in release
//
// The load differs from contact to contact, so a law of it weighs what each of them does by itself.
//
// The derivatives by exponents are central differences of forecasts; all else is exact.
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <optional>
#include <vector>

#include "causes/term.hpp"
#include "diagnosis/fit/forecast.hpp"
#include "diagnosis/search/row_laws.hpp"
#include "numerics/parallel.hpp"

namespace reeve::diagnosis {

// How far a site is from being the whole rig.
enum class Breadth : std::uint8_t { whole, part, one };

// Change of one cell by the value of the law at one contact.
struct ContactShare {
  Eigen::Index cell = 0;
  double by_value_N = 0;
  double load_N = 0;
};

struct Lever {
  Target target = Target::exponent;
  Site site;
  Breadth breadth = Breadth::whole;
  Eigen::VectorXd by_value_N;          // change of each cell by the value of the row's law
  std::optional<RowCovariate> load{};  // without rows; none where it does not differ
  std::vector<ContactShare> shares{};  // what adds up to the change, where there is a load
  bool has_coefficient = false;        // of its kind, which moves contacts of the site
};

// Returns the levers of all sites that the routings of the data have. Levers that no reading
// answers are left out.
std::vector<Lever> levers(const Dataset& dataset, const Model& model, const Forecast& at,
                          Workers& workers);

}  // namespace reeve::diagnosis
