// Computes the 5 % quantiles of uniformity and efficiency where no two contacts are alike, to first
// order.
//
// Contact k has the exponent φ_k (1 + σ_k z_k), z_k standard normal and independent of the others
// (ContactScatter). Across contacts that slide, ln T is linear in the exponents, so that in a grasp
//
//   ln T_i = ln T_i⁰ + Σ_k g_ik z_k,   g_ik = ½ [ln T_i at z_k = 1 − ln T_i at z_k = −1]
//   uniformity = exp(min_i ln T_i − max_i ln T_i),   i: strands
//   ln efficiency = ln efficiency⁰ + Σ_k h_k z_k,    h_k likewise
//
// The quantiles are those of the means over the grasps, over the draws 0, 1, … of one seed, the
// same for all designs. Assumption: what does not slide stays near the line. For known routings the
// quantiles are off by 0.002 on average (tests/search/contact_quantiles_test.cpp).
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <functional>
#include <vector>

#include "core/grasp.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"
#include "core/tension/tension.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::search {

// Keeps its memory.
class ContactQuantileFinder {
 public:
  static constexpr std::size_t draws = 400;
  static constexpr std::uint64_t seed = 1;

  // Solves a pull in this grasp with these exponents; `again` is true if the grasp is that of the
  // call before. The state is valid until the next call.
  using Solve = std::function<const TensionState&(const Mechanics&, Grasp, bool again)>;

  // `deviations` has σ of each contact. `nominal` is changed and put back.
  ContactQuantiles find(const Network& network, Mechanics& nominal,
                        const std::vector<double>& deviations, const GraspSet& grasps,
                        const Solve& solve);

 private:
  using Draws = Eigen::Array<double, Eigen::Dynamic, 1>;

  // Writes the logarithms of one grasp: ln T of the strands, then ln of the efficiency.
  void read(const Network& network, const TensionState& state, std::vector<double>& logs) const;
  void add_grasp(const Network& network, Mechanics& nominal, const std::vector<double>& deviations,
                 const WeightedGrasp& grasp, const Solve& solve);
  void draw_contacts(std::size_t contacts);
  // Draws the logarithms of one grasp from their values and slopes.
  void draw_logs();
  double low_quantile(const Draws& values);

  // A contact's z_k adds `value` times z_k to a logarithm.
  struct Slope {
    std::size_t contact;
    double value;
  };

  std::vector<std::size_t> strands_;        // segments that count in a grasp
  std::vector<Draws> z_;                    // one for each contact
  std::vector<Draws> drawn_;                // one for each logarithm
  std::vector<std::vector<Slope>> slopes_;  // likewise, but for those that are 0
  std::vector<double> base_;
  std::vector<double> more_;
  std::vector<double> less_;
  Draws least_;
  Draws most_;
  Draws uniformity_;
  Draws efficiency_;
  std::vector<double> sorted_;
};

}  // namespace reeve::search
