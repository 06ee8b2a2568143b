// Published numbers of a routing: its printed table, its closed form, and their known faults and
// misprints. Values only; entry_file.hpp reads them, number_check.hpp recomputes them. Tensions are
// at motor tension T_M = 1.
#pragma once

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

#include "catalog/toml_node.hpp"

namespace reeve::catalog {

// A number with its digits: "0.10" is 0.1, known to half a unit of its second decimal.
struct PrintedNumber {
  std::string digits;
  double value = 0;
  double half_unit = 0.5;  // half a unit of the last printed digit
};

struct PublishedTable {
  std::string source;                        // "Table I"
  std::vector<PrintedNumber> tension;        // tensions of strands T1 … T2n
  std::vector<PrintedNumber> share_percent;  // shares of the sum over the strands
};

// The model's shares as a figure draws them, with one friction coefficient for tubes and sheaths
// alike.
struct PublishedLines {
  std::string source;  // "Fig. 9 (b)"
  double mu = 0;
  std::vector<PrintedNumber> share_percent;  // half_unit: reading precision of the figure
};

// Number of factors e^{-phi} for each kind of contact.
struct Losses {
  int tube = 0;
  int bearing = 0;
  int sheath = 0;
};

// T_i = K e^{-strand[i]}, K = 1 / Σ_j e^{-carriage[j]}: the motor-side segments, in walk order,
// carry K e^{-carriage[j]} and add up to T_M = 1.
struct ClosedForm {
  std::string source;  // "Eqs. 14, 15"
  std::vector<Losses> strand;
  std::vector<Losses> carriage;
};

// The table's tensions of these strands are the true ones times `times`, without some losses; its
// shares, and those of lines, may follow from tensions with this fault.
struct FactorFault {
  std::vector<int> strands;
  double times = 1;
  Losses left_out;
};

// The table's tensions, or shares, are those of another routing, digit by digit.
struct RepeatsFault {
  std::string routing;
};

// The table's tensions are those of another routing's table times one number, within rounding, and
// no multiple of the true ones.
struct ProportionalFault {
  std::string routing;
};

// The force balance is printed with a sheath sliding the wrong way.
struct ReversedContactFault {
  std::string source;                 // "Eq. 16, last line"
  int strand = 1;                     // the sheath lies between this strand
  std::size_t motor_side = 0;         // and this motor-side segment (from 0, in walk order)
  std::string segment;                // name of that segment
  bool printed_strand_higher = true;  // true if the strand has the larger tension, as printed
};

struct Fault {
  std::variant<FactorFault, RepeatsFault, ProportionalFault, ReversedContactFault> what;
  TomlPosition at;  // place in the entry's file
};

const char* fault_name(const Fault& fault);

// A slip that changes no number.
struct Misprint {
  std::string source;
  std::string text;
};

}  // namespace reeve::catalog
