// Losses from one sensor to the next, stretch by stretch.
//
// Between two neighbouring measured segments of a tendon whose contacts all slide, or are about to,
// in one direction, the friction exponents add up:
//
//   ln(T_high / T_low) = Σ φ_k
//
// so that each such stretch is a measurement of its contacts' friction by itself, without the motor
// tension and without the other readings. With x a stretch's loss less the extended model's, it
// stands apart from the others over the same contacts by the modified z-score of B. Iglewicz and
// D. C. Hoaglin (How to Detect and Handle Outliers, ASQC, 1993), 0.6745 |x − median| / MAD > 3.5,
// both of x and of x in units of each stretch's own noise (one of few readings scatters more
// than the rest), if it does so by more than two standard deviations of that noise too.
#pragma once

#include <vector>

#include "causes/model.hpp"
#include "diagnosis/verdict/compared_cell.hpp"
#include "readings/measured_data.hpp"

namespace reeve::diagnosis {

// With fewer stretches over the same contacts none of them can stand apart.
inline constexpr std::size_t enough_stretches = 6;

struct Loss {
  std::size_t routing = 0;  // in MeasuredData::routings
  Grasp grasp;
  Direction direction = Direction::pull;
  Segment high;                   // from which
  Segment low;                    // to which the tension falls, by the extended model
  std::vector<ContactKind> over;  // the contacts between them, from high to low
  std::size_t rows = 0;
  // ln(T_high / T_low), mean over the rows, weighed by their noise; those with a forecast within
  // three standard deviations of zero are left out.
  double measured = 0;
  double deviation = 0;  // standard deviation of `measured` by the noise
  double before = 0;     // by the forecasts of the nominal model
  double after = 0;      // by those of the extended model
  bool stands_apart = false;
};

// In the order of the file and of the walk.
std::vector<Loss> losses(const MeasuredData& data, const Model& extended,
                         const std::vector<ComparedCell>& cells);

}  // namespace reeve::diagnosis
