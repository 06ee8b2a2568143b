#include "diagnosis/data/data_columns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <limits>
#include <map>
#include <string_view>

#include "core/error.hpp"
#include "core/text.hpp"
#include "diagnosis/series/recognise_series.hpp"

namespace reeve::diagnosis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

struct KnownColumn {
  const char* name;
  DataRole role;
  double low;
  double high;
};

// The greatest numbers are far above any rig: they catch a slipped decimal mark, and keep sums of
// squares finite. An angle of 100 rad is sixteen turns of a sheath; more is likely in degrees.
constexpr std::array known_columns{
    KnownColumn{"run", DataRole::run, 0, 0},
    KnownColumn{"routing", DataRole::routing, 0, 0},
    KnownColumn{"held", DataRole::held, 0, 0},
    KnownColumn{"direction", DataRole::direction, 0, 0},
    KnownColumn{"motor_tension_N", DataRole::motor_tension, 0, 1e9},
    KnownColumn{"speed_mm_s", DataRole::speed, 0, 1e9},
    KnownColumn{"cycle", DataRole::cycle, 0, 1e15},
    KnownColumn{"temperature_C", DataRole::temperature, -273.15, 1e4},
    KnownColumn{"sheath_angle_rad", DataRole::sheath_angle, 0, 100},
};
constexpr double max_tension_N = 1e9;

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
}

bool all_of(std::string_view text, int (*is)(int)) {
  return std::all_of(text.begin(), text.end(),
                     [&](char c) { return is(static_cast<unsigned char>(c)) != 0; });
}

// Has the form of a tension's name, but for case and zeros: T1_N, Ta_N, Th1_N. A motor-side segment
// has two letters at most: 702 of them are more than 64 fingers can have.
bool looks_like_a_tension(const std::string& name) {
  if (name.size() < 4 || (name[0] != 'T' && name[0] != 't') || !lower(name).ends_with("_n")) {
    return false;
  }
  std::string_view middle = std::string_view(name).substr(1, name.size() - 3);
  if (all_of(middle, std::isalpha)) return middle.size() <= 2;
  if (middle[0] == 'h' || middle[0] == 'H') middle.remove_prefix(1);
  return all_of(middle, std::isdigit);
}

std::optional<Segment> segment_of(const std::string& name) {
  if (!name.starts_with('T') || !name.ends_with("_N")) return std::nullopt;
  const bool strand = std::isdigit(static_cast<unsigned char>(name[1])) != 0;
  const std::size_t begin = strand ? 0 : 1;
  return segment_named(std::string_view(name).substr(begin, name.size() - 2 - begin));
}

// Throws InputError without the place.
DataColumn read_column(const std::string& name) {
  if (name.empty()) throw InputError({.what = "has no name", .expected = "one"});
  for (const KnownColumn& known : known_columns) {
    if (name == known.name) return {known.role, name, known.low, known.high, {}};
    if (lower(name) == lower(known.name)) {
      throw InputError({.expected = fmt::format("'{}', written so", known.name)});
    }
  }
  if (!looks_like_a_tension(name)) {
    return {DataRole::covariate, name, -infinity, infinity, {}};
  }
  const std::optional<Segment> segment = segment_of(name);
  if (!segment) {
    throw InputError({.expected =
                          "a tension written as T1_N (strand), Ta_N (motor-side segment) or Th1_N "
                          "(stretch at the hand)"});
  }
  return {DataRole::tension, name, 0, max_tension_N, *segment};
}

std::string place_of_header(const CsvReader& csv) {
  return fmt::format("{}:{}", csv.name(), csv.header().line);
}

void require(const CsvReader& csv, const std::vector<DataColumn>& columns, DataRole role,
             const std::string& column, const std::string& expected) {
  if (find_column(columns, role)) return;
  throw InputError({.where = place_of_header(csv),
                    .what = "the header has no column " + column,
                    .expected = expected});
}

}  // namespace

std::vector<DataColumn> read_columns(const CsvReader& csv) {
  const CsvRow& header = csv.header();
  std::vector<DataColumn> columns;
  std::map<std::string, std::size_t> seen;
  for (const std::string& field : header.fields) {
    const std::string name(trimmed(field));
    const std::size_t number = columns.size() + 1;
    const auto [first, is_new] = seen.emplace(name, number);
    try {
      if (!is_new && !name.empty()) {
        throw InputError(fmt::format("column {} has that name already", first->second));
      }
      columns.push_back(read_column(name));
    } catch (const InputError& error) {
      throw error.at(InputFault{.where = place_of_header(csv),
                                .what = fmt::format("column {}", number),
                                .value = for_message(name)});
    }
  }
  require_no_log(csv, columns);
  require(csv, columns, DataRole::run, "'run'", "a name or number for each run");
  require(csv, columns, DataRole::routing, "'routing'", "a routing in each row");
  require(csv, columns, DataRole::tension, "of tensions",
          "at least one such as T1_N (strand), Ta_N (motor-side segment) or Th1_N (stretch at the "
          "hand)");
  return columns;
}

std::optional<std::size_t> find_column(const std::vector<DataColumn>& columns, DataRole role) {
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].role == role) return i;
  }
  return std::nullopt;
}

}  // namespace reeve::diagnosis
