// The power of a planned experiment: how often a diagnosis of its data finds what is hidden.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "diagnosis/diagnose.hpp"
#include "numerics/binomial.hpp"

namespace reeve::diagnosis {

// Outcome of a diagnosis if the hidden causes are known.
enum class Finding : std::uint8_t {
  found,  // all hidden causes named and no others; nothing named if nothing is hidden
  wrong,  // others named, or not all of them
  none,   // nothing named though something is hidden
  unexplained,
  indistinguishable,
};
inline constexpr std::array findings{Finding::found, Finding::wrong, Finding::none,
                                     Finding::unexplained, Finding::indistinguishable};
const char* finding_name(Finding finding);

// One simulated experiment.
struct PowerTrial {
  std::uint64_t seed = 0;
  Finding finding = Finding::none;
  std::vector<std::string> named;
  std::vector<std::vector<std::string>> indistinguishable;
};

PowerTrial judged(std::uint64_t seed, const DiagnosisResult& result,
                  const std::vector<std::string>& hidden);

struct FindingShare {
  Finding finding = Finding::found;
  std::size_t count = 0;
  double share = 0;
  ConfidenceInterval interval;  // 95 %
};

// In the order of the findings.
std::vector<FindingShare> finding_shares(const std::vector<PowerTrial>& trials);

}  // namespace reeve::diagnosis
