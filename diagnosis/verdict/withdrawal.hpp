// Whether the names that the training runs earned forecast runs that nobody has seen.
//
// Each name had its own test; whether all together gain on the held-out runs, these alone can say,
// and of the last one by itself, since what the others gain may hide its loss. They may lose there
// where the interval of their gain in log-likelihood reaches below what as many parameters that are
// needed for nothing lose by chance (half the 95 % quantile of χ²), and below what chance leaves of
// the gain that is expected if they are right. The cause that was accepted last is then withdrawn,
// and so on: in the order of acceptance, since which of them loses is not for these runs to choose.
// If what is left may still lose, or the coefficients that are said to differ lose beside the
// causes that are left, they are no longer said to. Runs whose forecasts change by no more than
// what training leaves open of the parameters say nothing. Where residuals surely rise in newton
// and nothing is gained in likelihood either, whatever is open, the names lose.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "diagnosis/search/explanation.hpp"
#include "diagnosis/verdict/held_out.hpp"

namespace reeve::diagnosis {

struct Withdrawal {
  std::vector<std::string> names;
  std::optional<HeldOut> held_out;  // what all names do there while the last of these was one
};

// Changes the explanation. Nothing is withdrawn where nothing is held out.
Withdrawal withdraw_what_may_lose(Explanation& explanation, const Dataset& held_out,
                                  const Model& nominal, std::uint64_t seed, Workers& workers);

}  // namespace reeve::diagnosis
