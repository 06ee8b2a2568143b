// A catalogue entry recomputed by the general solver, in the grasp of its published numbers; unless
// said otherwise with the paper's coefficients (the default hardware). Tensions are at motor
// tension T_M = 1.
#pragma once

#include <cstddef>
#include <vector>

#include "catalog/catalogue.hpp"
#include "core/hardware.hpp"

namespace reeve::catalog {

// A sheath between a strand and a motor-side segment.
struct SheathEnds {
  std::size_t strand = 0;  // index, from 0
  double ratio = 1;        // tension of the motor-side segment over that of the strand
};

struct Solution {
  std::vector<double> tension;        // strands T1 … T2n
  std::vector<double> share_percent;  // shares of the sum over the strands
  // One for each motor-side segment, in walk order; empty if one of them leads to no strand.
  std::vector<SheathEnds> sheaths;
};

Solution solve(const CatalogueEntry& entry, const Hardware& hardware = {});

// The default hardware with this friction coefficient at tubes and sheaths.
Hardware with_friction(double mu);

std::vector<double> shares_percent(const std::vector<double>& tension);

// e^{-phi} of all these losses together.
double decay(const Losses& losses, const Hardware& hardware = {});

// K e^{-strand} for every strand.
std::vector<double> evaluate(const ClosedForm& form);
double gain(const ClosedForm& form);

// True if `computed` rounds to the printed digits. A tie may round either way.
bool rounds_to(double computed, const PrintedNumber& printed);

}  // namespace reeve::catalog
