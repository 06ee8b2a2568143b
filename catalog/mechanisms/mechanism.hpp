// A mechanism of the literature: a tackle, a haul, a bench, a hand. One TOML file each, in
// families/FAMILY/ of the catalogue:
//
//   name, word      required; the word may be spelt as its source goes along it, and names the
//                   segments as it stands
//   access          required: what of the source was read
//   topology        "secondary" if the way of the tendon is not from the source itself; then it can
//                   have no numbers. "read" otherwise, and where it is left out
//   title, source, notes
//   like            words of the same mechanism for other numbers of fingers
//   [hardware]      its own coefficients, in the tables of a hardware file (rig/hardware_file.hpp)
//   [rig.NAME]      what is different for some of the numbers: let, hardware, inferred_from
//   [[published]]   source, rig, let, word, held, direction, computed, unit; numbers, each with
//                   quantity, and one of value (digits in quotes, with their tolerance if it is not
//                   their rounding), equals (a closed form) and trials (readings whose mean is
//                   checked; trials.hpp); used = true, explained_by with because, open, or refuted.
//                   used may have an explained_by whose coefficient the number gave. refuted may
//                   have met_by, a rig with which the number would agree. let stands over that of
//                   the rig. What stands beside numbers holds for each that has none of its own
//   [[misprint]]    source, text
//
// Wherever a hardware has a number there may be an expression (expression.hpp) of pi and of what
// `let` defines. `computed`, `equals` and `explained_by` may besides name the coefficients (mu_t,
// theta_t, mu_b, theta_b, mu_block, theta_block, mu_s, theta_s), and what the solver finds at T_M =
// 1: segments (T1, a, h1, T_M), dl1 … that fingers close per travel of the carriage, efficiency and
// uniformity; and of finger 1 in free motion its joint angles q1 …, deg, at the `excursion_mm` of
// `let`. Values only; mechanism_file.hpp reads them, catalog/number_check.hpp recomputes them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "catalog/mechanisms/expression.hpp"
#include "catalog/published.hpp"
#include "core/grasp.hpp"
#include "core/hardware.hpp"
#include "core/routing.hpp"

namespace reeve::catalog {

struct MechanismRig {
  std::string name;  // "" for the mechanism's own hardware
  // The printed number that a coefficient was inferred from; "" if none was.
  std::string inferred_from;
  NamedValues let;  // with pi
  Hardware hardware;
};

enum class NumberStanding : std::uint8_t {
  plain,
  used,       // a coefficient of the rig was inferred from it, so that it proves nothing
  explained,  // an expression gives it
  open,       // it differs for an unknown reason
  refuted,    // it differs, and what it would take is known and not what its source says
};

struct PublishedNumber {
  std::string quantity;  // quantity in words: "load / line pull"
  std::string source;    // "p. 137"
  std::string word;
  Routing routing;
  Grasp grasp;
  Direction direction = Direction::pull;
  MechanismRig rig;
  Expression computed;
  // Either a closed form or printed digits.
  std::optional<Expression> equals;
  PrintedNumber printed;
  NumberStanding standing = NumberStanding::plain;
  std::optional<Expression> explained_by;
  std::optional<MechanismRig> met_by;  // rig with which a refuted number would agree
  std::string reason;                  // set for explained, open and refuted numbers
  TomlPosition at;                     // place in the mechanism's file
};

struct Mechanism {
  std::string family;
  std::string name;
  std::string word;
  Routing routing;
  Routing canonical;  // canonical for identical fingers
  std::string title;
  std::string source;
  std::string access;
  bool from_secondary_source = false;
  std::string notes;
  std::vector<Routing> like;
  // Own coefficients, if it has any.
  std::optional<Hardware> hardware;
  std::vector<PublishedNumber> numbers;
  std::vector<Misprint> misprints;
  std::string file;
};

}  // namespace reeve::catalog
