// Number of independent readings in a stretch of samples whose noise goes on from one sample to the
// next: n / τ, with the correlation time in samples
//
//   τ = 1 + 2 Σ_k ρ_k      (k = 1, 2, …; ρ_k: autocorrelation at lag k)
//
// so that the mean of n samples of standard deviation σ has the standard error σ √(τ / n). The sum
// ends by the initial monotone sequence (over pairs ρ_2m + ρ_2m+1 as long as they are positive,
// none counted greater than the one before), or at five τ. Noise that swings from one sample to the
// next is taken as independent: τ is at least 1.
//
// The samples are residuals about a straight line, which has taken a part of the noise with it:
// with u = k / n the autocovariance at lag k is too small by
//
//   σ² τ / n (1 + (1 - u)² - 3 u²)
//
// and that is added, with the τ of the round before, four times.
//
// Sources: G. V. Bayley, J. M. Hammersley, The "effective" number of independent observations in an
// autocorrelated time series, Suppl. J. R. Stat. Soc. 8 (1946); C. J. Geyer, Practical Markov chain
// Monte Carlo, Statistical Science 7 (1992), section 3.3.
//
// The correlation is one of sensor, filter and clock, so that it is estimated from all stretches of
// a log together, each scaled by its own deviation: a single short one could not tell it. Assumed
// is that the noise is stationary within a stretch, that its correlation is the same in all, and
// that each is ten times as long as τ or more; with shorter ones τ is too small.
#pragma once

#include <span>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::readings {

// τ, in samples. Of the residuals of each stretch.
double correlation_time(std::vector<std::vector<double>> residuals);

// Standard deviation σ of one sample: σ² = Σ r² / (n - 2 τ), where at least half of n stays.
double deviation_of_samples(std::span<const double> residuals, double correlation_time);

}  // namespace reeve::readings
