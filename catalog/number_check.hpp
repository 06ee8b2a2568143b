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

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalogue.hpp"
#include "catalog/mechanisms/mechanism.hpp"

namespace reeve::catalog {

enum class CheckStatus : std::uint8_t {
  agrees,
  used,       // a coefficient was inferred from it
  explained,  // it differs, and arithmetic shows why
  refuted,    // it differs, and takes another coefficient or part than its source says
  open,       // it differs for an unknown reason, as the catalogue says
  differs,
};

inline constexpr std::array check_statuses{CheckStatus::agrees,    CheckStatus::used,
                                           CheckStatus::explained, CheckStatus::refuted,
                                           CheckStatus::open,      CheckStatus::differs};

const char* status_name(CheckStatus status);

enum class CheckedKind : std::uint8_t {
  strand_tension,
  strand_share,               // %
  motor_tension,              // motor tension that a table's tensions require
  motor_tension_of_equation,  // motor tension that an equation as printed requires
  idle_fault,                 // numbers explained by a fault that is listed
  tension_sum,                // sum over the strands as read, N
  indicator,                  // one of the five (core/indicators.hpp)
  indicator_mean,
  share_error,               // error of model lines as printed against readings, %
  share_error_of_equations,  // error of the shares that the model gives, %
  friction_coefficient,
  design_count,
  in_words,  // number of a mechanism, as its source calls it
};

// Identity of a number: its kind, and its strand, listed fault or indicator (each from 1, in their
// order) or number of fingers.
struct CheckedQuantity {
  CheckedKind kind = CheckedKind::strand_tension;
  int number = 0;

  friend bool operator==(const CheckedQuantity&, const CheckedQuantity&) = default;
};

struct CheckItem {
  std::string family = paper_family;
  std::string routing;  // "" if it is about no single one
  std::string source;   // "Table IV", "Eqs. 14, 15"
  CheckedQuantity quantity;
  std::string printed;  // the digits as printed; empty for equations
  double published = 0;
  double computed = 0;
  CheckStatus status = CheckStatus::differs;
  std::string reason;  // empty where it agrees
  std::string in_words;
  std::string inferred_from;  // the printed number from which a coefficient of its rig comes, or ""
};

struct CheckedMisprint {
  std::string routing;
  std::string source;
  std::string text;
  std::string family = paper_family;
};

struct CheckReport {
  std::vector<CheckItem> items;
  std::vector<CheckedMisprint> misprints;

  // Counts the items of one family, or of all families: "".
  std::size_t count(CheckStatus status, std::string_view family = "") const;
  // Returns the families in the order of the items.
  std::vector<std::string> families() const;
};

CheckReport check(const Catalogue& catalogue);

// Makes it explained, for one reason more.
void add_explanation(CheckItem& item, const std::string& reason);
// Says of a listed fault (from 0) that it counts the numbers it explains: one at least is claimed,
// none is found.
CheckItem idle_fault(std::size_t fault, const std::string& name, const std::string& file,
                     TomlPosition at);

// Recomputes the published numbers of the catalogue's mechanisms (mechanism.hpp) with the general
// solver, each with the rig and in the grasp that it was published for:
//
//   printed digits   agree if the computed number rounds to them, or is within their tolerance
//   closed forms     agree to 1e-9, relative
//   readings         their mean agrees within its 95 % confidence interval, each reading within the
//                    prediction interval
//
// A number from which a coefficient of its own rig was inferred has to agree, and proves nothing.
// A difference is explained if the listed expression gives it. It is refuted if what the number
// would take is known and contradicts its source: a coefficient, with which the number is computed
// again and has to agree, or a part that the model does not have. It is open if nobody knows why,
// and then listed with its size. A number that is listed as explained, refuted or open and agrees
// is an error of the catalogue: it is reported as differing.
CheckReport check_mechanism(const Mechanism& mechanism);

}  // namespace reeve::catalog
