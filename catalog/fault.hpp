// Whether a known fault of a publication really gives a printed number. A listed fault is a claim:
// it explains a number only if the arithmetic holds, to within the rounding of the printed digits.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "catalog/catalogue.hpp"
#include "catalog/solution.hpp"

namespace reeve {

enum class Quantity : std::uint8_t { tension, share };

// One number of an entry's table that the solver does not give.
struct DifferingNumber {
  const Catalogue& catalogue;
  const CatalogueEntry& entry;
  const Solution& solution;
  Quantity quantity = Quantity::tension;
  std::size_t strand = 0;  // from 0

  const PrintedNumber& printed() const;
  double computed() const;
};

// The sentence that explains the number, with the numbers in it; nothing if the fault does not
// hold. A reversed contact explains no number of a table.
std::optional<std::string> explain(const Fault& fault, const DifferingNumber& number);

// The force balance of the carriage, Σ over the motor-side segments at T_M = 1, as the equation
// with the reversed contact has it, and with that contact turned round.
struct CarriageBalance {
  double as_printed = 0;
  double corrected = 0;
};
CarriageBalance carriage_balance(const ReversedContactFault& fault, const ClosedForm& form);

}  // namespace reeve
