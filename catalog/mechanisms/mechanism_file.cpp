#include "catalog/mechanisms/mechanism_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include "catalog/entry_file.hpp"
#include "catalog/hardware_tables.hpp"
#include "catalog/mechanisms/named_values.hpp"
#include "catalog/mechanisms/trials.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/mechanics.hpp"
#include "core/network.hpp"

namespace reeve::catalog {
namespace {

Expression read_expression(const TomlNode& node) {
  try {
    return parse_expression(node.text());
  } catch (const InputError& error) {
    node.fail_at_value(error.fault());
  }
}

double read_value(const TomlNode& node, const NamedValues& names) {
  const Expression expression = read_expression(node);
  try {
    return expression.evaluate(names);
  } catch (const InputError& error) {
    node.fail_at_value(error.fault());
  }
}

// The same tables with numbers in place of expressions. The guide of a joint is a word.
TomlNode with_numbers(TomlNode node, const NamedValues& names) {
  if (node.kind == TomlKind::string && node.key != "guide") {
    node.number = read_value(node, names);
    node.kind = TomlKind::floating;
  }
  for (TomlNode& child : node.children) child = with_numbers(std::move(child), names);
  return node;
}

// Returns the keys of `over`, and those of `base` that `over` does not have.
TomlNode overlaid(TomlNode base, const TomlNode& over) {
  for (const TomlNode& child : over.children) {
    const auto same = std::ranges::find(base.children, child.key, &TomlNode::key);
    if (same == base.children.end()) {
      base.children.push_back(child);
    } else if (same->kind == TomlKind::table && child.kind == TomlKind::table) {
      *same = overlaid(std::move(*same), child);
    } else {
      *same = child;
    }
  }
  return base;
}

Hardware read_own_hardware(const TomlNode& tables, const NamedValues& names) {
  tables.table().allow_only(hardware_table_names());
  return read_hardware_tables(with_numbers(tables, names)).hardware;
}

// The variables of a rig, with those that a number has in place of them.
NamedValues read_let(const TomlNode* of_rig, const TomlNode* of_number) {
  NamedValues values{{"pi", std::numbers::pi}};
  TomlNode let;
  if (of_rig != nullptr) let = of_rig->table();
  if (of_number != nullptr) let = overlaid(std::move(let), of_number->table());
  for (const TomlNode& item : let.children) {
    const bool plain =
        std::ranges::all_of(
            item.key,
            [](unsigned char c) { return (std::isalnum(c) != 0 && c < 0x80) || c == '_'; }) &&
        !item.key.empty() && std::isdigit(static_cast<unsigned char>(item.key[0])) == 0;
    if (!plain || values.contains(item.key)) {
      item.fail_at_key({.what = "let",
                        .value = item.key,
                        .expected = "a new name of letters, digits and '_', such as K or P1"});
    }
    values[item.key] = item.is_number() ? item.number : read_value(item, values);
  }
  return values;
}

// [hardware] and [rig.NAME] of the mechanism's file: hardware of its own, in which an expression
// may stand wherever a hardware file has a number (mechanism.hpp). Throws InputError.
class RigTables {
 public:
  explicit RigTables(const TomlNode& file) : others_(file.find("rig")) {
    own_.file = file.file;
    own_.name = "hardware";
    if (const TomlNode* hardware = file.find("hardware")) own_ = *hardware;
    if (others_ == nullptr) return;
    for (const TomlNode& node : others_->table().children) {
      node.table().allow_only({"inferred_from", "let", "hardware"});
      read(&node, nullptr);
    }
  }

  // The rig that `name` names, or the mechanism's own hardware. `let` is that of a number, which
  // stands over the rig's.
  MechanismRig find(const TomlNode* name, const TomlNode* let) const {
    if (name == nullptr) return read(nullptr, let);
    std::string names;
    if (others_ != nullptr) {
      for (const TomlNode& node : others_->children) {
        if (node.key == name->text()) return read(&node, let);
        names += (names.empty() ? "" : ", ") + node.key;
      }
    }
    name->fail_expected(names.empty() ? "nothing, there is no [rig.NAME]" : "one of " + names);
  }

 private:
  // Keys that a rig does not give are as in the mechanism's own hardware.
  MechanismRig read(const TomlNode* node, const TomlNode* let) const {
    if (node == nullptr) {
      MechanismRig rig{"", "", read_let(nullptr, let), {}};
      rig.hardware = read_own_hardware(own_, rig.let);
      return rig;
    }
    MechanismRig rig{node->key, "", read_let(node->find("let"), let), {}};
    if (const TomlNode* from = node->find("inferred_from")) rig.inferred_from = from->text();
    const TomlNode* hardware = node->find("hardware");
    rig.hardware =
        read_own_hardware(hardware == nullptr ? own_ : overlaid(own_, *hardware), rig.let);
    return rig;
  }

  TomlNode own_;
  const TomlNode* others_;
};

// Keys that may stand beside a list of numbers, for all of them, or at one number.
const std::vector<std::string_view> shared_keys{"rig",       "let",      "word",         "held",
                                                "direction", "computed", "unit",         "open",
                                                "refuted",   "met_by",   "explained_by", "because"};

std::string optional_text(const TomlNode& node, std::string_view key) {
  const TomlNode* found = node.find(key);
  return found == nullptr ? std::string() : found->text();
}

// A number and the set it stands in, which has what the number has not.
struct NumberNodes {
  const TomlNode& number;
  const TomlNode& set;

  const TomlNode* find(std::string_view key) const {
    const TomlNode* own = number.find(key);
    return own == nullptr ? set.find(key) : own;
  }
  const TomlNode& require(std::string_view key, std::string_view expected) const {
    const TomlNode* found = find(key);
    return found == nullptr ? number.require(key, expected) : *found;
  }
};

Direction read_direction(const TomlNode* node) {
  if (node == nullptr || node->text() == "pull") return Direction::pull;
  if (node->text() != "release") node->fail_expected("\"pull\" or \"release\"");
  return Direction::release;
}

std::vector<PrintedNumber> read_trials(const TomlNode& node) {
  std::vector<PrintedNumber> trials;
  for (const TomlNode& item : node.items()) trials.push_back(read_printed_number(item));
  if (trials.size() < 2) node.fail_expected("at least two readings: one has no spread");
  return trials;
}

void read_value(const NumberNodes& nodes, PublishedNumber& number) {
  const TomlNode* value = nodes.number.find("value");
  const TomlNode* equals = nodes.number.find("equals");
  const TomlNode* trials = nodes.number.find("trials");
  const TomlNode* tolerance = nodes.number.find("tolerance");
  if ((value != nullptr) + (equals != nullptr) + (trials != nullptr) != 1) {
    nodes.number.fail_at_key({.what = nodes.number.name,
                              .expected = "one of value, equals and trials",
                              .form = InputForm::equals});
  }
  if (value != nullptr) number.printed = read_printed_number(*value);
  if (equals != nullptr) number.equals = read_expression(*equals);
  if (trials != nullptr) number.printed = mean_of(read_trials(*trials));
  if (tolerance == nullptr) return;
  if (value == nullptr) tolerance->fail_expected("none but beside value");
  number.printed.half_unit = tolerance->number_from_zero();
}

void read_used(const TomlNode& used, const NumberNodes& nodes, PublishedNumber& number) {
  if (used.kind != TomlKind::boolean || used.number == 0) used.fail_expected("true");
  if (number.rig.inferred_from.empty()) used.fail_expected("a rig with inferred_from");
  number.standing = NumberStanding::used;
  const TomlNode* by = nodes.find("explained_by");
  if (by == nullptr) return;
  number.explained_by = read_expression(*by);
  number.reason = nodes.require("because", "what the expression is").text();
}

void read_refuted(const TomlNode& refuted, const NumberNodes& nodes, const RigTables& rigs,
                  PublishedNumber& number) {
  number.standing = NumberStanding::refuted;
  number.reason = refuted.text();
  if (const TomlNode* rig = nodes.find("met_by")) number.met_by = rigs.find(rig, nullptr);
}

// Reads at most one of the four statuses; that of the number comes before that of its set. A number
// that gave a coefficient of an expression is used, and has the expression as well.
void read_standing(const NumberNodes& nodes, const RigTables& rigs, PublishedNumber& number) {
  for (const TomlNode* from : {&nodes.number, &nodes.set}) {
    const TomlNode* used = from->find("used");
    const TomlNode* by = used == nullptr ? from->find("explained_by") : nullptr;
    const TomlNode* open = from->find("open");
    const TomlNode* refuted = from->find("refuted");
    const int given =
        (used != nullptr) + (by != nullptr) + (open != nullptr) + (refuted != nullptr);
    if (given == 0) continue;
    if (given > 1) {
      from->fail_at_key({.what = from->name,
                         .expected = "at most one of used, explained_by, open and refuted",
                         .form = InputForm::equals});
    }
    if (used != nullptr) {
      read_used(*used, nodes, number);
    } else if (by != nullptr) {
      number.standing = NumberStanding::explained;
      number.explained_by = read_expression(*by);
      number.reason = from->require("because", "what the expression is").text();
    } else if (refuted != nullptr) {
      read_refuted(*refuted, nodes, rigs, number);
    } else {
      number.standing = NumberStanding::open;
      number.reason = open->text();
    }
    return;
  }
}

// Before the solver is asked: whatever an expression names has to be there, and every contact that
// the rig is about.
void require_names(const NumberNodes& nodes, const PublishedNumber& number,
                   const MechanismRig& rig) {
  const Network network = expand(number.routing);
  const auto unmatched = MechanicsBuilder(rig.hardware).unmatched_contacts(network);
  if (!unmatched.empty()) {
    nodes.number.fail_at_key({.what = "contact",
                              .value = unmatched.front(),
                              .expected = fmt::format("two segments with a contact between them "
                                                      "in {}",
                                                      number.word)});
  }
  const auto ends = MechanicsBuilder(rig.hardware).unmatched_spools(network);
  if (!ends.empty()) {
    nodes.number.fail_at_key(
        {.what = "spools",
         .value = ends.front(),
         .expected = fmt::format("a motor-side segment that ends at an M in {}", number.word)});
  }
  const auto tendons = MechanicsBuilder(rig.hardware).unmatched_tendons(network);
  if (!tendons.empty()) {
    nodes.number.fail_at_key(
        {.what = "tendon",
         .value = tendons.front(),
         .expected = fmt::format("a tendon of {} that can have its spring or slack", number.word)});
  }
  TensionState state;
  state.tension.assign(network.segments.size(), 1);
  state.closing.assign(static_cast<std::size_t>(network.fingers), 1);
  const auto require = [&](std::string_view key, const Expression& expression,
                           const NamedValues& values) {
    try {
      expression.evaluate(values);
    } catch (const InputError& error) {
      nodes.find(key)->fail_at_value(error.fault());
    }
  };
  try {
    const NamedValues values = named_values(rig, network, state, number.direction);
    require("computed", number.computed, values);
    if (number.equals) require("equals", *number.equals, values);
    if (number.explained_by) require("explained_by", *number.explained_by, values);
  } catch (const InputError& error) {
    if (error.fault().where) throw;
    nodes.number.fail_at_key(error.fault());
  }
}

PublishedNumber read_number(const NumberNodes& nodes, const Mechanism& mechanism,
                            const RigTables& rigs) {
  std::vector<std::string_view> keys = shared_keys;
  keys.insert(keys.end(), {"quantity", "where", "value", "equals", "trials", "tolerance", "used"});
  nodes.number.table().allow_only(keys);
  PublishedNumber number;
  number.at = nodes.number.key_at;
  number.quantity = nodes.number.require("quantity", "what is printed, in words").text();
  if (const TomlNode* unit = nodes.find("unit")) number.quantity += ", " + unit->text();
  number.source = nodes.set.require("source", "where the numbers stand").text();
  if (const TomlNode* where = nodes.number.find("where")) number.source += ", " + where->text();
  const TomlNode* word = nodes.find("word");
  number.routing = word == nullptr ? mechanism.routing : read_actuated_word(*word);
  number.word = word == nullptr ? mechanism.word : word->content;
  if (const TomlNode* held = nodes.find("held")) {
    number.grasp = read_held(*held, finger_count(number.routing));
  }
  number.direction = read_direction(nodes.find("direction"));
  number.rig = rigs.find(nodes.find("rig"), nodes.find("let"));
  number.computed =
      read_expression(nodes.require("computed", "what of the tensions it is, such as \"T1/T_M\""));
  read_value(nodes, number);
  read_standing(nodes, rigs, number);
  require_names(nodes, number, number.rig);
  if (number.met_by) require_names(nodes, number, *number.met_by);
  return number;
}

// Each reading behind a mean is a published number, too. It stands as the mean does.
void add_trials(const TomlNode& node, const PublishedNumber& mean,
                std::vector<PublishedNumber>& numbers) {
  if (mean.standing != NumberStanding::plain && mean.standing != NumberStanding::used) {
    node.fail_at_key({.what = node.name,
                      .expected = "nothing but used beside it: readings are of a quantity that "
                                  "the model gives",
                      .form = InputForm::equals});
  }
  const std::vector<PrintedNumber> trials = with_scatter(read_trials(node));
  for (std::size_t i = 0; i < trials.size(); ++i) {
    PublishedNumber trial = mean;
    trial.printed = trials[i];
    trial.quantity += fmt::format(", reading {} of {}", i + 1, trials.size());
    numbers.push_back(std::move(trial));
  }
}

std::vector<PublishedNumber> read_numbers(const TomlNode& sets, const Mechanism& mechanism,
                                          const RigTables& rigs) {
  std::vector<std::string_view> keys = shared_keys;
  keys.insert(keys.end(), {"source", "numbers"});
  std::vector<PublishedNumber> numbers;
  for (const TomlNode& set : sets.tables()) {
    set.allow_only(keys);
    for (const TomlNode& number : set.require("numbers", "what is printed there").items()) {
      numbers.push_back(read_number({number, set}, mechanism, rigs));
      if (const TomlNode* trials = number.find("trials")) {
        const PublishedNumber mean = numbers.back();
        add_trials(*trials, mean, numbers);
      }
    }
  }
  return numbers;
}

bool is_from_secondary_source(const TomlNode& file) {
  const TomlNode* node = file.find("topology");
  if (node == nullptr || node->text() == "read") return false;
  if (node->text() != "secondary") node->fail_expected("\"read\" or \"secondary\"");
  return true;
}

// Numbers that nobody read at their source cannot be checked against it.
void require_no_numbers(const TomlNode& file) {
  const TomlNode* published = file.find("published");
  if (published != nullptr && !published->children.empty()) {
    published->children.front().fail_at_key(
        {.what = "published", .expected = "no numbers of a mechanism whose topology is secondary"});
  }
}

}  // namespace

Mechanism read_mechanism(const TomlNode& file, const std::string& family) {
  file.allow_only({"name", "word", "title", "source", "access", "topology", "notes", "like",
                   "hardware", "rig", "published", "misprint"});
  Mechanism mechanism;
  mechanism.family = family;
  mechanism.file = *file.file;
  mechanism.name = read_name(file.require("name", "the mechanism's name"));
  const TomlNode& word = file.require("word", "the routing's word, such as \"M-Y1-F+Y1-1x\"");
  mechanism.routing = read_actuated_word(word);
  mechanism.word = word.content;
  mechanism.canonical = canonical(mechanism.routing, FingerIdentity::identical);
  if (finger_count(mechanism.routing) == 0) word.fail_expected("a routing with fingers");
  mechanism.access = file.require("access", "what of the source was read").text();
  mechanism.from_secondary_source = is_from_secondary_source(file);
  mechanism.title = optional_text(file, "title");
  mechanism.source = optional_text(file, "source");
  mechanism.notes = optional_text(file, "notes");
  mechanism.like = read_like(file.find("like"), mechanism.routing);
  const RigTables rigs(file);
  if (file.find("hardware") != nullptr) mechanism.hardware = rigs.find(nullptr, nullptr).hardware;
  if (mechanism.from_secondary_source) require_no_numbers(file);
  if (const TomlNode* published = file.find("published")) {
    mechanism.numbers = read_numbers(*published, mechanism, rigs);
  }
  mechanism.misprints = read_misprints(file.find("misprint"));
  return mechanism;
}

}  // namespace reeve::catalog
