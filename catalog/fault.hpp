// Checks if a known fault of a publication really gives a printed number. A listed fault is a
// claim: it explains a number only if the arithmetic holds, to within the rounding of the printed
// digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/solution.hpp"

namespace reeve::catalog {

enum class PrintedKind : std::uint8_t { tension, share };

// The strands' numbers as one table or one figure has them.
struct PrintedList {
  std::string source;
  PrintedKind kind = PrintedKind::tension;
  bool drawn = false;  // true if read from a figure
  std::vector<PrintedNumber> numbers;
  Hardware hardware;  // hardware for the computed numbers
};

// Tensions and shares of the table, then the lines.
std::vector<PrintedList> printed_lists(const CatalogueEntry& entry);

bool concerns(const FactorFault& fault, int strand);  // strand counts from 1

// Tensions of the strands with the factor faults that are listed of an entry.
std::vector<double> with_factor_faults(const CatalogueEntry& entry, const Hardware& hardware,
                                       std::vector<double> tension);

// One number that the solver does not give.
struct DifferingNumber {
  const Catalogue& catalogue;
  const CatalogueEntry& entry;
  const Solution& solution;  // solution with the list's hardware
  const PrintedList& list;
  std::size_t strand = 0;  // index, from 0

  const PrintedNumber& printed() const { return list.numbers[strand]; }
  double computed() const;
};

// The sentence that explains the number, with the numbers in it; nothing if the fault does not
// hold. A reversed contact explains none.
std::optional<std::string> explain(const Fault& fault, const DifferingNumber& number);

// The force balance of the carriage, Σ over the motor-side segments at T_M = 1, as the equation
// with the reversed contact has it, and with that contact turned round.
struct CarriageBalance {
  double as_printed = 0;
  double corrected = 0;
};
CarriageBalance carriage_balance(const ReversedContactFault& fault, const ClosedForm& form);

}  // namespace reeve::catalog
