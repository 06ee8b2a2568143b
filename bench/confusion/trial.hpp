// One planted data set, diagnosed: what was hidden, what was found.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "bench/confusion/separability.hpp"
#include "diagnosis/diagnose.hpp"
#include "tests/support/planting.hpp"
#include "tests/support/planting_alias.hpp"
#include "tests/support/planting_dirt.hpp"

namespace reeve::bench {

enum class Part : std::uint8_t {
  single,
  null,
  pairs,
  unknown,
  alias,
  coverage,
  leakage,
  mounting,       // mountings differ by 3, 5 or 8 % in exponents; a third without cause
  few_mountings,  // the same with 3, 6 and 20 runs, no cause: coefficients and alarms
  heavy,          // Student's t of 3 degrees of freedom; a third without cause
  negative,       // small loads, and sensors that read below 0; a third without cause
  rig,            // a cause of the drive or of a sensor
  dirty           // a cause or none, in a file as loggers leave it, beside the clean one
};
const char* part_name(Part part);
const std::vector<Part>& all_parts();

struct Trial {
  Part part = Part::single;
  testing::PlantingPlan plan;
  testing::AliasKind alias = testing::AliasKind::gain_or_offset;  // kind of part alias
  testing::Dirt dirt = testing::Dirt::form;                       // kind of part dirty
  std::uint64_t seed = 0;

  std::string kind() const;    // tube_friction, gain_or_offset, nothing
  std::string column() const;  // "small, 1 %"
};

// `sets` trials, evenly over what the part varies.
std::vector<Trial> trials_of(Part part, std::size_t sets, std::uint64_t seed);

struct FoundInterval {
  std::string parameter;  // tube_friction.mu
  double truth = 0, value = 0, low = 0, high = 0;

  bool covers() const { return low <= truth && truth <= high; }
};

// Reductions of the rms residual on the same held-out readings.
struct FoundGain {
  double found = 0;
  double possible = 0;  // by the truth
};

// Result of one call of the diagnosis.
struct Finding {
  Verdict verdict = Verdict::none;
  std::vector<std::string> named;
  std::vector<std::vector<std::string>> indistinguishable;
  std::vector<std::string> given_up;  // accepted by the search, not named in the end
};

struct Outcome {
  Trial trial;
  std::vector<std::string> planted;     // names of the causes
  std::vector<std::string> equivalent;  // alias: the hidden cause, and the one that looks like it
  double oracle = 0;                    // the least log-likelihood ratio of the hidden causes
  std::optional<Separability> separability;
  Finding finding;
  std::optional<Finding> with_more;      // alias: with the separating rows; dirty: of that file
  std::optional<bool> copies_dropped;    // leakage: all copied rows, and nothing else
  std::vector<FoundInterval> intervals;  // intervals of causes named right
  std::optional<FoundGain> gain;         // given if the named causes are the hidden ones
  std::string csv;
};

MeasuredData parse_planted(const std::string& csv);

Outcome run(const Trial& trial, const DiagnoseOptions& options);

// Returns the name, or the group of those that explain the data as it does.
std::vector<std::string> said_equivalent(const Finding& finding, const std::string& name);

// True if the named causes are just the hidden ones.
bool names_all(const Outcome& outcome, const Finding& finding);
// True if some choice among the names that are said to explain the data alike is just what is
// hidden.
bool names_among_others(const Outcome& outcome);
// True if a cause is named that is not hidden there, and that is not among causes that explain the
// data alike together with the hidden one.
bool names_wrong(const Outcome& outcome, const Finding& finding);

}  // namespace reeve::bench
