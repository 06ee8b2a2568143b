// Tensions of several routings in several grasps, while coefficients of the hardware vary: one
// solve of the plain friction model for each routing, grasp and sample.
//
// A sample has one value of each coefficient that varies. The hardware's own values of one finger
// or of one contact stay.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/network.hpp"
#include "core/routing.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::studies {

// Coefficient of the law of all contacts of one kind.
enum class LawTerm : std::uint8_t { mu, angle };

struct CoefficientColumn {
  std::string name;  // for messages
  ContactKind kind = ContactKind::tube;
  LawTerm term = LawTerm::mu;
  std::span<const double> values;  // one for each sample; angles in rad
};

struct TensionTableRequest {
  std::vector<Routing> routings;
  Hardware hardware;
  std::vector<Grasp> grasps;
  Direction direction = Direction::pull;
  std::vector<CoefficientColumn> columns;
  std::size_t samples = 1;
  int threads = 0;
};

// Every segment that one of the routings has: strands by number, then motor sides, then those at
// the hand.
std::vector<Segment> table_segments(const std::vector<Routing>& routings);

// How many numbers the table has: [routing][grasp][sample][segment], the last one changing first.
std::size_t table_size(const TensionTableRequest& request);

// Fills it with N per N of motor tension; NaN where a routing has no such segment. False if it was
// stopped, and the rest is as it was. The same numbers for any number of threads. Throws InputError
// on a value that there cannot be, OutOfRange where the model has no tensions.
bool fill_tension_table(const TensionTableRequest& request, std::span<double> table,
                        const StudySupervision& supervision = {});

}  // namespace reeve::studies
