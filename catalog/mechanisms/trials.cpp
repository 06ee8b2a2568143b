#include "catalog/mechanisms/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "numerics/student_t.hpp"

namespace reeve::catalog {
namespace {

struct ReadingSpread {
  double mean = 0;
  double count = 0;
  double half_width = 0;  // t s, with 95 % of the readings within it of a mean that is known
};

ReadingSpread spread_of(const std::vector<PrintedNumber>& trials) {
  ReadingSpread spread;
  spread.count = static_cast<double>(trials.size());
  for (const PrintedNumber& trial : trials) spread.mean += trial.value / spread.count;
  double squares = 0;
  for (const PrintedNumber& trial : trials) squares += std::pow(trial.value - spread.mean, 2);
  constexpr double upper_end = 0.975;
  const double degrees = spread.count - 1;
  spread.half_width = student_t_quantile(upper_end, degrees) * std::sqrt(squares / degrees);
  return spread;
}

}  // namespace

PrintedNumber mean_of(const std::vector<PrintedNumber>& trials) {
  const ReadingSpread spread = spread_of(trials);
  // Readings that are all alike are known to their rounding.
  const double half =
      std::max(spread.half_width / std::sqrt(spread.count), trials.front().half_unit);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(half))));
  return {fmt::format("{:.{}f} ± {:.{}f}", spread.mean, decimals, half, decimals), spread.mean,
          half};
}

std::vector<PrintedNumber> with_scatter(std::vector<PrintedNumber> trials) {
  const ReadingSpread spread = spread_of(trials);
  for (PrintedNumber& trial : trials) {
    trial.half_unit =
        std::max(spread.half_width * std::sqrt(1 + 1 / spread.count), trial.half_unit);
  }
  return trials;
}

}  // namespace reeve::catalog
