// Laws as a person writes them: what effect_name says, and parameters.
//
//   law[exponent of sheath, humidity_pct, linear]       a=0.0083
//   law[gain of T3]                                     a=0.05
//   law[offset of T1, load x speed_mm_s, product]       a=0.01, logarithmic=true,false
//
// `range` (20:80) is where the law follows its covariate, `middle` its x0. Without them they are
// those of the experiment, of loads up to the greatest motor tension. Of a product each has two
// values, with a comma.
#pragma once

#include <string>
#include <vector>

#include "causes/named_effect.hpp"

namespace reeve::causes {

bool is_law_name(const std::string& name);

// The law, and the settings that are of its parameters.
struct NamedLaw {
  const Cause* cause = nullptr;
  std::vector<Setting> settings;
};

// Throws InputError of what is wrong with the law, or with the experiment for it.
NamedLaw law_of(const NamedEffect& named, const Survey& survey);

}  // namespace reeve::causes
