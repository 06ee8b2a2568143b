// Recomputes every published number of the catalogue with the general solver, which is given no
// sliding directions, and compares number by number:
//
//   printed tensions and shares   agree if the computed number rounds to the printed digits
//   shares that a figure draws    agree to what the figure can be read to
//   closed forms, per strand      agree to 1e-9, relative
//   carriage of a printed table   the motor-side tensions that its strands ask for add up to
//                                 T_M = 1, to within the rounding of the strands
//   carriage of an equation       the same for an equation with a reversed contact
//
// What differs is explained only by a fault listed for the entry whose arithmetic holds
// (fault.hpp); a listed fault that explains nothing is itself an item that differs. Tensions are at
// T_M = 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "catalog/catalogue.hpp"

namespace reeve::catalog {

enum class CheckStatus : std::uint8_t { agrees, explained, differs };

const char* status_name(CheckStatus status);

enum class CheckedKind : std::uint8_t {
  strand_tension,
  strand_share,               // %
  motor_tension,              // that a table's tensions ask for
  motor_tension_of_equation,  // that an equation as printed asks for
  idle_fault,                 // numbers explained by a fault that is listed
  tension_sum,                // of the strands as read, N
  indicator,                  // one of the five (core/indicators.hpp)
  indicator_mean,
  share_error,               // of model lines as printed against readings, %
  share_error_of_equations,  // of the shares that the model gives
  friction_coefficient,
  design_count,
};

// What a number is: its kind, and of which strand (from 1), listed fault (from 1), indicator (from
// 1, in their order) or number of fingers.
struct CheckedQuantity {
  CheckedKind kind = CheckedKind::strand_tension;
  int number = 0;

  friend bool operator==(const CheckedQuantity&, const CheckedQuantity&) = default;
};

struct CheckItem {
  std::string routing;  // "" if it is about no single one
  std::string source;   // "Table IV", "Eqs. 14, 15"
  CheckedQuantity quantity;
  std::string printed;  // the digits as printed; empty for equations
  double published = 0;
  double computed = 0;
  CheckStatus status = CheckStatus::differs;
  std::string reason;  // empty where it agrees
};

struct CheckedMisprint {
  std::string routing;
  std::string source;
  std::string text;
};

struct CheckReport {
  std::vector<CheckItem> items;
  std::vector<CheckedMisprint> misprints;

  std::size_t count(CheckStatus status) const;
};

CheckReport check(const Catalogue& catalogue);

// Makes it explained, for one reason more.
void add_explanation(CheckItem& item, const std::string& reason);
// Says of a listed fault (from 0) that it counts the numbers it explains: one at least is claimed,
// none is found.
CheckItem idle_fault(std::size_t fault, const std::string& name, const std::string& file,
                     TomlPosition at);

}  // namespace reeve::catalog
