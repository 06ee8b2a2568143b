#include "catalog/entry_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/network.hpp"
#include "core/notation.hpp"

namespace reeve::catalog {
namespace {

// No closed form passes a contact more often.
constexpr int max_losses = 1000;

bool is_word(const std::string& text) {
  try {
    parse_routing(text);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

Routing read_word(const TomlNode& node) {
  Routing routing = read_actuated_word(node);
  const Routing least = canonical(routing, FingerIdentity::identical);
  if (!(least == routing)) {
    node.fail_expected(fmt::format("the canonical word of this routing, \"{}\"", to_word(least)));
  }
  return routing;
}

const std::vector<TomlNode>& items(const TomlNode& node, std::size_t count,
                                   const std::string& of_what) {
  if (node.items().size() != count) {
    node.fail_at_value({.what = fmt::format("{} has {} items", node.name, node.items().size()),
                        .expected = fmt::format("{}, one for each {}", count, of_what)});
  }
  return node.items();
}

std::vector<PrintedNumber> read_printed(const TomlNode& node, std::size_t strands) {
  std::vector<PrintedNumber> numbers;
  for (const TomlNode& item : items(node, strands, "strand")) {
    numbers.push_back(read_printed_number(item));
  }
  return numbers;
}

PublishedTable read_table(const TomlNode& node, std::size_t strands) {
  node.table().allow_only({"source", "tension", "share_percent"});
  return {node.require("source", "where the table stands").text(),
          read_printed(node.require("tension", "the printed tensions of the strands"), strands),
          read_printed(node.require("share_percent", "the printed shares in %"), strands)};
}

PublishedLines read_lines(const TomlNode& node, std::size_t strands) {
  constexpr double greatest_mu = 1;
  node.allow_only({"source", "mu", "share_percent", "read_to_percent"});
  PublishedLines lines;
  lines.source = node.require("source", "where the lines are drawn").text();
  lines.mu = node.require("mu", "the friction coefficient of tubes and sheaths")
                 .number_between(0, greatest_mu);
  lines.share_percent =
      read_printed(node.require("share_percent", "the shares that are drawn, in %"), strands);
  const double read_to =
      node.require("read_to_percent", "how closely the figure can be read").number_between(0, 100);
  for (PrintedNumber& number : lines.share_percent) number.half_unit = read_to;
  return lines;
}

Losses read_losses(const TomlNode& node) {
  node.table().allow_only({"tube", "bearing", "sheath"});
  const auto count = [&](std::string_view key) {
    const TomlNode* found = node.find(key);
    return found == nullptr ? 0 : found->integer(0, max_losses);
  };
  return {count("tube"), count("bearing"), count("sheath")};
}

std::vector<Losses> read_losses(const TomlNode& node, std::size_t count,
                                const std::string& of_what) {
  std::vector<Losses> losses;
  for (const TomlNode& item : items(node, count, of_what)) losses.push_back(read_losses(item));
  return losses;
}

std::vector<std::string> motor_side_names(const Routing& routing) {
  std::vector<std::string> names;
  for (const Segment& segment : expand(routing).segments) {
    if (segment.kind == SegmentKind::motor_side) names.push_back(segment_name(segment));
  }
  return names;
}

ClosedForm read_closed_form(const TomlNode& node, const CatalogueEntry& entry,
                            std::size_t strands) {
  node.table().allow_only({"source", "strand", "carriage"});
  return {node.require("source", "where the equations stand").text(),
          read_losses(node.require("strand", "the losses of every strand"), strands, "strand"),
          read_losses(node.require("carriage", "the losses of every motor-side segment"),
                      motor_side_names(entry.routing).size(), "motor-side segment")};
}

FactorFault read_factor(const TomlNode& node, int strands) {
  node.allow_only({"kind", "strands", "times", "left_out"});
  FactorFault fault;
  for (const TomlNode& item : node.require("strands", "the strands concerned").items()) {
    fault.strands.push_back(item.integer(1, strands));
  }
  if (const TomlNode* times = node.find("times")) {
    fault.times = times->number_from_zero();
    if (fault.times == 0) times->fail_expected("a number above zero");
  }
  if (const TomlNode* left_out = node.find("left_out")) fault.left_out = read_losses(*left_out);
  return fault;
}

ReversedContactFault read_reversed_contact(const TomlNode& node, const CatalogueEntry& entry,
                                           int strands) {
  node.allow_only({"kind", "source", "strand", "segment", "printed_higher"});
  if (!entry.closed_form) {
    node.fail_at_key({.what = "a reversed contact needs a [closed_form] beside it"});
  }
  ReversedContactFault fault;
  fault.source = node.require("source", "where the equation stands").text();
  fault.strand = node.require("strand", "the strand at the sheath").integer(1, strands);
  const TomlNode& segment = node.require("segment", "the motor-side segment at the sheath");
  const std::vector<std::string> names = motor_side_names(entry.routing);
  const auto found = std::ranges::find(names, segment.text());
  if (found == names.end()) {
    segment.fail_expected(fmt::format("a motor-side segment, a to {}", names.back()));
  }
  fault.segment = *found;
  fault.motor_side = static_cast<std::size_t>(found - names.begin());
  const TomlNode& higher = node.require("printed_higher", "\"strand\" or \"segment\"");
  if (higher.text() != "strand" && higher.text() != "segment") {
    higher.fail_expected("\"strand\" or \"segment\"");
  }
  fault.printed_strand_higher = higher.text() == "strand";
  return fault;
}

std::string read_other_routing(const TomlNode& node) {
  node.allow_only({"kind", "routing"});
  return node.require("routing", "the name of another routing in the catalogue").text();
}

Fault read_fault(const TomlNode& node, const CatalogueEntry& entry, int strands) {
  const TomlNode& kind = node.require("kind", "factor, repeats, proportional or reversed_contact");
  const std::string& text = kind.text();
  if (text == "reversed_contact") return {read_reversed_contact(node, entry, strands), node.key_at};
  if (!entry.table && entry.lines.empty()) {
    node.fail_at_key({.what = "this fault needs a [table] or [[lines]] that it is about"});
  }
  if (text == "factor") return {read_factor(node, strands), node.key_at};
  if (text == "repeats") return {RepeatsFault{read_other_routing(node)}, node.key_at};
  if (text == "proportional") {
    if (!entry.table) {
      node.fail_at_key({.what = "a proportional fault needs a [table] that it is about"});
    }
    return {ProportionalFault{read_other_routing(node)}, node.key_at};
  }
  kind.fail_expected("factor, repeats, proportional or reversed_contact");
}

void read_published(const TomlNode& file, CatalogueEntry& entry) {
  const int fingers = finger_count(entry.routing);
  const int strands = 2 * fingers;
  const auto count = static_cast<std::size_t>(strands);
  const TomlNode* table = file.find("table");
  const TomlNode* closed_form = file.find("closed_form");
  const TomlNode* lines = file.find("lines");
  if (table != nullptr || closed_form != nullptr || lines != nullptr) {
    if (fingers == 0) file.fail_at_key({.what = "published tensions need a routing with fingers"});
    file.require("held", "the fingers held in the grasp of the published numbers");
  }
  if (const TomlNode* held = file.find("held")) entry.grasp = read_held(*held, fingers);
  if (table != nullptr) entry.table = read_table(*table, count);
  if (lines != nullptr) {
    for (const TomlNode& node : lines->tables()) entry.lines.push_back(read_lines(node, count));
  }
  if (closed_form != nullptr) entry.closed_form = read_closed_form(*closed_form, entry, count);
  if (const TomlNode* faults = file.find("fault")) {
    for (const TomlNode& node : faults->tables()) {
      entry.faults.push_back(read_fault(node, entry, strands));
    }
  }
}

}  // namespace

std::string read_name(const TomlNode& node) {
  const std::string& name = node.text();
  const bool plain = std::ranges::all_of(name, [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
           c == '-' || c == '.';
  });
  if (!plain || name.size() > 60) {
    node.fail_expected("at most 60 letters, digits, '_', '-' and '.'");
  }
  if (is_word(name)) node.fail_expected("a name that is not the word of a routing");
  return name;
}

Routing read_actuated_word(const TomlNode& node) {
  Routing routing;
  try {
    routing = parse_routing(node.text());
  } catch (const InputError& error) {
    node.fail_at_value(error.fault());
  }
  if (!is_actuated(routing)) node.fail_expected("a routing whose tendons all hang on the motor");
  return routing;
}

std::vector<Routing> read_like(const TomlNode* node, const Routing& own) {
  std::vector<Routing> like;
  if (node == nullptr) return like;
  std::set<int> taken{finger_count(own)};
  for (const TomlNode& item : node->items()) {
    like.push_back(read_actuated_word(item));
    if (taken.insert(finger_count(like.back())).second) continue;
    item.fail_expected("a word for a number of fingers that none before it has");
  }
  return like;
}

Grasp read_held(const TomlNode& node, int fingers) {
  Grasp grasp;
  for (const TomlNode& item : node.items()) {
    if (fingers == 0) item.fail_expected("nothing, the routing has no finger");
    const Grasp one = hold({item.integer(1, fingers)});
    if ((grasp.held & one.held) != 0) item.fail_expected("each finger once");
    grasp.held |= one.held;
  }
  return grasp;
}

std::vector<Misprint> read_misprints(const TomlNode* node) {
  std::vector<Misprint> misprints;
  if (node == nullptr) return misprints;
  for (const TomlNode& misprint : node->tables()) {
    misprint.allow_only({"source", "text"});
    misprints.push_back({misprint.require("source", "where it stands").text(),
                         misprint.require("text", "what is misprinted").text()});
  }
  return misprints;
}

std::optional<PrintedNumber> parse_printed_number(const std::string& digits) {
  constexpr std::string_view decimal = "0123456789";
  const std::size_t point = digits.find('.');
  const std::string_view whole = std::string_view(digits).substr(0, point);
  const std::string_view fraction =
      point == std::string::npos ? "0" : std::string_view(digits).substr(point + 1);
  const bool plain = !whole.empty() && !fraction.empty() && digits.size() <= 20 &&
                     whole.find_first_not_of(decimal) == std::string_view::npos &&
                     fraction.find_first_not_of(decimal) == std::string_view::npos;
  if (!plain) return std::nullopt;
  const auto decimals = point == std::string::npos ? 0.0 : static_cast<double>(fraction.size());
  return PrintedNumber{digits, std::strtod(digits.c_str(), nullptr),
                       0.5 * std::pow(10.0, -decimals)};
}

PrintedNumber read_printed_number(const TomlNode& node) {
  const auto number = parse_printed_number(node.content);
  if (node.kind != TomlKind::string || !number) {
    node.fail_expected("a number in quotes, with the digits as printed, such as \"0.10\"");
  }
  return *number;
}

const char* fault_name(const Fault& fault) {
  constexpr const char* names[] = {"factor", "repeats", "proportional", "reversed_contact"};
  return names[fault.what.index()];
}

CatalogueEntry read_entry(const TomlNode& file) {
  file.allow_only({"name", "word", "title", "source", "notes", "like", "held", "table", "lines",
                   "closed_form", "fault", "misprint"});
  CatalogueEntry entry;
  entry.file = *file.file;
  entry.name = read_name(file.require("name", "the routing's name"));
  const TomlNode& word = file.require("word", "the routing's word, such as \"M-1-T-2-F\"");
  entry.routing = read_word(word);
  entry.word = word.content;
  const auto optional_text = [&](std::string_view key) {
    const TomlNode* found = file.find(key);
    return found == nullptr ? std::string() : found->text();
  };
  entry.title = optional_text("title");
  entry.source = optional_text("source");
  entry.notes = optional_text("notes");
  entry.like = read_like(file.find("like"), entry.routing);
  read_published(file, entry);
  entry.misprints = read_misprints(file.find("misprint"));
  return entry;
}

}  // namespace reeve::catalog
