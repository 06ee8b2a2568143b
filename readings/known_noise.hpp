// What is known of how a channel's readings scatter, before any data are seen: a data sheet's
// accuracy, a calibration, a dead weight.
//
//   sd² = absolute² + (relative T)²
//
// of a tension T that the sensor should read. Both are 0 of what is exact, such as the force of a
// weight that hangs at the far end of a bench.
#pragma once

#include <optional>
#include <string>

#include "numerics/floors.hpp"

namespace reeve::readings {

struct KnownNoise {
  double relative = 0;
  double absolute_N = 0;

  double deviation(double tension_N) const;
};

// "2 % and 0.3 N", "exact".
std::string noise_text(const KnownNoise& noise);

// Of one column of tensions, in any name that it may have (intake/column_name.hpp), or of the
// motor tension: "motor", "T1", "Ta", "at_T1".
struct ColumnNoise {
  std::string column;
  KnownNoise noise;
};

// "motor=2%", "T1=0.3N", "T1=2%+0.3N". Throws InputError.
ColumnNoise parse_column_noise(const std::string& text);

}  // namespace reeve::readings
