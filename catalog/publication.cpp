#include "catalog/publication.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "catalog/entry_file.hpp"

namespace reeve::catalog {
namespace {

constexpr double greatest_N = 1e9;
constexpr int most_strands = 64;

const std::vector<TomlNode>& five(const TomlNode& node) {
  if (node.items().size() != indicator_count) {
    node.fail_expected("five numbers, one for each indicator");
  }
  return node.items();
}

MotorSideRule read_rule(const TomlNode& node) {
  node.table().allow_only({"strand", "slides"});
  MotorSideRule rule;
  rule.strand = node.require("strand", "the strand at the sheath").integer(1, most_strands);
  const TomlNode& slides = node.require("slides", "\"to motor\" or \"to hand\"");
  if (slides.text() != "to motor" && slides.text() != "to hand") {
    slides.fail_expected("\"to motor\" or \"to hand\"");
  }
  rule.to_motor = slides.text() == "to motor";
  return rule;
}

IndicatorRow read_row(const TomlNode& node) {
  node.allow_only({"routing", "printed", "deviation", "mean", "motor_side"});
  IndicatorRow row;
  row.routing = node.require("routing", "the name of a routing").text();
  const auto& numbers = five(node.require("printed", "the five indicators as printed"));
  const auto& deviations = five(node.require("deviation", "their standard deviations"));
  for (std::size_t i = 0; i < indicator_count; ++i) {
    row.printed[i] = read_printed_number(numbers[i]);
    row.deviation[i] = deviations[i].number_from_zero();
  }
  row.mean = read_printed_number(node.require("mean", "the mean of the indicators as printed"));
  for (const TomlNode& rule : node.require("motor_side", "the motor-side segments").items()) {
    row.motor_side.push_back(read_rule(rule));
  }
  return row;
}

const std::string& read_routing(const TomlNode& node, const IndicatorTable& table) {
  if (table.find(node.text()) == nullptr) node.fail_expected("a routing of the table");
  return node.text();
}

IndicatorFault read_fault(const TomlNode& node, const IndicatorTable& table) {
  const TomlNode& kind = node.require("kind", "slides_to_hand or exchanged");
  if (kind.text() == "slides_to_hand") {
    node.allow_only({"kind", "routing", "strand"});
    return {SlidesToHandFault{
                read_routing(node.require("routing", "a routing of the table"), table),
                node.require("strand", "the strand at the sheath").integer(1, most_strands)},
            node.key_at};
  }
  if (kind.text() != "exchanged") kind.fail_expected("slides_to_hand or exchanged");
  node.allow_only({"kind", "routings"});
  const TomlNode& names = node.require("routings", "the names of two routings");
  if (names.items().size() != 2) names.fail_expected("two names");
  return {ExchangedFault{
              {read_routing(names.items()[0], table), read_routing(names.items()[1], table)}},
          node.key_at};
}

IndicatorTable read_indicators(const TomlNode& node) {
  node.table().allow_only({"source", "ratio_from", "row", "fault"});
  IndicatorTable table;
  table.source = node.require("source", "where the table stands").text();
  const TomlNode& ratio_from = node.require("ratio_from", "the routing that implies the ratio");
  table.ratio_from = ratio_from.text();
  for (const TomlNode& row : node.require("row", "the rows of the table").tables()) {
    table.rows.push_back(read_row(row));
  }
  const IndicatorRow* first = table.find(table.ratio_from);
  const bool implies_it = first != nullptr && first->motor_side.size() == 1;
  if (!implies_it) ratio_from.fail_expected("a routing of the table with one motor-side segment");
  if (const TomlNode* faults = node.find("fault")) {
    for (const TomlNode& fault : faults->tables()) {
      table.faults.push_back(read_fault(fault, table));
    }
  }
  return table;
}

PublishedError read_error(const TomlNode& node) {
  node.allow_only({"source", "mu", "printed", "lines"});
  const TomlNode& lines = node.require("lines", "\"table\", or the source of lines");
  return {node.require("source", "where it stands").text(),
          node.require("mu", "the friction coefficient of tubes and sheaths").number_between(0, 1),
          read_printed_number(node.require("printed", "the error in %")), lines.text(), lines.at};
}

PublishedCounts read_counts(const TomlNode& node) {
  constexpr int most_fingers = 12;
  node.table().allow_only({"source", "even_factor", "odd_factor", "fingers"});
  PublishedCounts counts;
  counts.source = node.require("source", "where the rule stands").text();
  counts.even_factor = node.require("even_factor", "of 2^n").integer(1, most_fingers);
  counts.odd_factor = node.require("odd_factor", "of 2^n").integer(1, most_fingers);
  for (const TomlNode& fingers : node.require("fingers", "numbers of fingers").items()) {
    counts.fingers.push_back(fingers.integer(1, most_fingers));
  }
  return counts;
}

// The indicators' readings, whose sums are checked with them.
void read_indicators(const TomlNode& file, Publication& publication) {
  const TomlNode* indicators = file.find("indicators");
  if (indicators == nullptr) {
    for (const char* key : {"readings_source", "sum_N"}) {
      if (const TomlNode* node = file.find(key)) {
        node->fail_at_key({.what = fmt::format("{} needs [indicators] beside it", key)});
      }
    }
    return;
  }
  publication.readings_source = file.require("readings_source", "where the readings stand").text();
  publication.sum_N =
      file.require("sum_N", "the sum of a routing's strands").number_between(0, greatest_N);
  publication.indicators = read_indicators(*indicators);
}

Publication read_publication(const TomlNode& file) {
  file.allow_only({"name", "readings", "readings_source", "read_to_N", "sum_N", "indicators",
                   "error", "coefficient", "designs"});
  Publication publication;
  publication.file = *file.file;
  publication.name = file.require("name", "the publication's name").text();
  const TomlNode& readings = file.require("readings", "a file in measured/");
  publication.readings = readings.text();
  if (std::filesystem::path(publication.readings).filename() != publication.readings) {
    readings.fail_expected("the name of a file in measured/");
  }
  publication.read_to_N =
      file.require("read_to_N", "how closely they can be read").number_between(0, greatest_N);
  read_indicators(file, publication);
  if (const TomlNode* errors = file.find("error")) {
    for (const TomlNode& node : errors->tables()) publication.errors.push_back(read_error(node));
  }
  if (const TomlNode* node = file.find("coefficient")) {
    if (!publication.indicators) {
      node->fail_at_key({.what = "a coefficient needs [indicators] beside it, which imply one"});
    }
    node->table().allow_only({"source", "printed"});
    publication.coefficient = {node->require("source", "where it stands").text(),
                               read_printed_number(node->require("printed", "the coefficient"))};
  }
  if (const TomlNode* node = file.find("designs")) publication.counts = read_counts(*node);
  return publication;
}

}  // namespace

const char* fault_name(const IndicatorFault& fault) {
  constexpr const char* names[] = {"slides_to_hand", "exchanged"};
  return names[fault.what.index()];
}

const IndicatorRow* IndicatorTable::find(const std::string& routing) const {
  const auto found = std::ranges::find(rows, routing, &IndicatorRow::routing);
  return found == rows.end() ? nullptr : &*found;
}

std::vector<Publication> read_publications(const CatalogueFiles& files) {
  std::vector<Publication> publications;
  for (const TomlNode& file : files.toml("publications")) {
    publications.push_back(read_publication(file));
  }
  return publications;
}

}  // namespace reeve::catalog
