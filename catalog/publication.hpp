// Numbers that a publication derives from readings and from its model, as printed. One TOML file
// each in publications/ beside the catalogue's routings, with the readings in measured/.
//
//   name, readings, read_to_N
//   [indicators]    beside it readings_source, sum_N; source, ratio_from; [[indicators.row]]
//   routing, printed (the five of
//                   core/indicators.hpp), deviation, mean, motor_side; [[indicators.fault]]
//   [[error]]       source, mu, printed (%), lines: model lines against the readings
//   [coefficient]   source, printed: of the sheaths
//   [designs]       source, even_factor, odd_factor, fingers: factor · 2^n − 1 designs of n fingers
//
// Values only; studies/catalogue_check.hpp derives them again.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "catalog/catalogue_files.hpp"
#include "catalog/published.hpp"
#include "catalog/toml_node.hpp"

namespace reeve::catalog {

inline constexpr std::size_t indicator_count = 5;

// A motor-side segment, whose tension follows from a strand's by the ratio of a sheath.
struct MotorSideRule {
  int strand = 1;
  bool to_motor = true;  // T_strand / ratio; to the hand: T_strand · ratio

  friend bool operator==(const MotorSideRule&, const MotorSideRule&) = default;
};

struct IndicatorRow {
  std::string routing;
  std::array<PrintedNumber, indicator_count> printed;
  std::array<double, indicator_count> deviation{};  // over the trials
  PrintedNumber mean;
  std::vector<MotorSideRule> motor_side;
};

// The motor tension was computed as if the tendon slid from the motor to this strand.
struct SlidesToHandFault {
  std::string routing;
  int strand = 1;
};

// The rows of two routings stand in each other's place.
struct ExchangedFault {
  std::array<std::string, 2> routings;
};

struct IndicatorFault {
  std::variant<SlidesToHandFault, ExchangedFault> what;
  TomlPosition at;  // place in the publication's file
};

const char* fault_name(const IndicatorFault& fault);

struct IndicatorTable {
  std::string source;
  std::string ratio_from;  // the routing whose transmission implies the sheaths' ratio
  std::vector<IndicatorRow> rows;
  std::vector<IndicatorFault> faults;

  const IndicatorRow* find(const std::string& routing) const;
};

struct PublishedError {
  std::string source;
  double mu = 0;
  PrintedNumber percent;
  std::string lines;      // "table", or the source of lines
  TomlPosition lines_at;  // place in the publication's file
};

struct PublishedCoefficient {
  std::string source;
  PrintedNumber mu;
};

struct PublishedCounts {
  std::string source;
  int even_factor = 1;
  int odd_factor = 1;
  std::vector<int> fingers;
};

struct Publication {
  std::string name;
  std::string readings;         // file in measured/
  std::string readings_source;  // their place in the source: "Fig. 5"; with indicators
  double read_to_N = 0;         // reading precision
  double sum_N = 0;             // sum over a routing's strands; with indicators
  std::optional<IndicatorTable> indicators;
  std::vector<PublishedError> errors;
  std::optional<PublishedCoefficient> coefficient;
  std::optional<PublishedCounts> counts;
  std::string file;
};

// Every *.toml in the catalogue's folder publications/, by file name; none if there is no such
// folder. Throws InputError with file, line and column.
std::vector<Publication> read_publications(const CatalogueFiles& files);

}  // namespace reeve::catalog
