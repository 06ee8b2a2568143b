#include "cli/inputs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/canonical.hpp"
#include "core/graph.hpp"
#include "core/idle_values.hpp"
#include "core/nearest_name.hpp"
#include "core/notation.hpp"
#include "core/text.hpp"
#include "reports/document/document.hpp"
#include "reports/output/files.hpp"

namespace reeve::cli {
namespace {

// Words begin with a token and go on with a dash or a plus; names do not.
bool looks_like_a_name(const std::string& text) {
  return text.size() > 1 && text.size() < 64 && text.find_first_of("-+") == std::string::npos &&
         std::isalpha(static_cast<unsigned char>(text[0])) != 0;
}

std::string names(const Catalogue& catalogue) {
  std::string list = joined(catalogue.entries, ", ", &CatalogueEntry::name);
  const std::vector<std::string> families = catalogue.families();
  if (families.empty()) return list;
  return fmt::format("{}, a mechanism of {}", list, fmt::join(families, ", "));
}

std::vector<std::string> routing_names(const Catalogue& catalogue) {
  std::vector<std::string> names;
  for (const CatalogueEntry& entry : catalogue.entries) names.push_back(entry.name);
  for (const Mechanism& mechanism : catalogue.mechanisms) names.push_back(mechanism.name);
  return names;
}

InputError no_file(const std::string& option) {
  return InputError({.what = option, .value = "", .expected = "a TOML file"});
}

void require_in_range(const MechanicsBuilder& builder, const Network& network,
                      const std::string& word) {
  Mechanics mechanics;
  builder.apply(network, mechanics);
  try {
    builder.require_in_range(network, mechanics);
  } catch (const OutOfRange& error) {
    throw error.at(fmt::format("routing '{}'", word));
  }
}

// Returns the word of the only routing.
std::string place_of(const std::vector<Routing>& routings) {
  return routings.size() == 1 ? to_word(routings.front()) : "one of the routings";
}

}  // namespace

Catalogue shipped_catalogue() { return read_catalogue(CatalogueFiles::shipped()); }

Routing read_routing(const std::string& text, const Catalogue& catalogue) {
  if (const Routing* named = catalogue.find_routing(text)) return *named;
  if (looks_like_a_name(text)) {
    throw InputError(
        {.where = fmt::format("routing '{}'", text),
         .what = "no such name in the catalogue",
         .expected = fmt::format("one of {}, or a word such as M-1-T-2-F{}", names(catalogue),
                                 did_you_mean(text, routing_names(catalogue))),
         .form = InputForm::unknown});
  }
  return parse_routing(text);
}

Routing read_like(const std::string& name, int fingers, const Catalogue& catalogue) {
  const std::vector<Routing> sizes = catalogue.sizes_of(name);
  if (sizes.empty()) {
    throw InputError(
        {.what = "--like",
         .value = name,
         .expected = fmt::format("a name of the catalogue, which reeve catalogue lists{}",
                                 did_you_mean(name, routing_names(catalogue)))});
  }
  std::vector<int> known;
  for (const Routing& routing : sizes) {
    if (finger_count(routing) == fingers) return routing;
    known.push_back(finger_count(routing));
  }
  throw InputError(
      {.what = "--fingers",
       .value = std::to_string(fingers),
       .expected = fmt::format("{}{}: the catalogue has {} for no other number",
                               known.size() > 1 ? "one of " : "", fmt::join(known, ", "), name)});
}

Routing read_actuated_routing(const std::string& text, const Catalogue& catalogue) {
  Routing routing = read_routing(text, catalogue);
  require_actuated(expand(routing), to_word(routing));
  return routing;
}

void GivenRoutings::add(const Routing& routing) {
  const std::string word = to_word(routing);
  const auto [first, is_new] =
      words_.emplace(to_word(canonical(routing, FingerIdentity::distinct)), word);
  if (is_new) return;
  const std::string as = first->second == word ? "" : ", as " + first->second;
  throw InputError(fmt::format("routing '{}' is given twice{}", word, as));
}

CLI::Validator one_of(std::vector<std::string> names) {
  const std::string set = fmt::format("{{{}}}", fmt::join(names, ","));
  return CLI::Validator(
      [names = std::move(names), set](const std::string& text) {
        if (std::ranges::find(names, text) != names.end()) return std::string();
        return fmt::format("{} not in {}{}", text, set, did_you_mean(text, names));
      },
      set);
}

CLI::Validator number_from(double low, double high) {
  return CLI::Validator(
      [=](const std::string& text) {
        const auto number = number_in(text);
        if (number && *number >= low && *number <= high) return std::string();
        return fmt::format("Value '{}': expected a number from {} to {}", text, low, high);
      },
      "");
}

std::string is_seed(const std::string& text) {
  if (text.find('-') != std::string::npos) {
    return "Value " + text + " is negative: expected a whole number from 0";
  }
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error != std::errc::result_out_of_range) return {};
  return fmt::format("Value {} is too large: expected a whole number to {}", text,
                     std::numeric_limits<std::uint64_t>::max());
}

std::string names_a_file(const std::string& text) {
  return text.empty() ? "Value '': expected a file or folder" : "";
}

void add_threads(CLI::App& command, int& threads) {
  add_with_default(command, "--threads", threads,
                   "Number of threads; 0: all. The result does not depend on it")
      ->check(CLI::Range(0, 1024));
}

CLI::Option* HardwareOption::add_to(CLI::App& command) {
  return add(
      command, "--hardware",
      "TOML file of the parts, such as catalog/hardware/example.toml (default: the paper's)");
}

HardwareFile HardwareOption::read() const {
  if (!is_given()) return {};
  if (text.empty()) throw no_file("--hardware");
  return read_hardware_file(text);
}

std::string HardwareOption::name() const { return is_given() ? text : default_hardware_name; }

std::optional<std::string> FamilyOption::read(const Catalogue& catalogue) const {
  if (!is_given()) return std::nullopt;
  std::vector<std::string> families = catalogue.families();
  families.insert(families.begin(), paper_family);
  if (std::ranges::find(families, text) != families.end()) return text;
  throw InputError({.what = "--family",
                    .value = text,
                    .expected = fmt::format("one of {}{}", fmt::join(families, ", "),
                                            did_you_mean(text, families))});
}

void require_svg(const std::string& file, const std::string& option) {
  const std::string ending = lower(std::filesystem::path(file).extension().string());
  const std::vector<std::string> others{".pdf", ".png", ".eps", ".ps", ".jpg", ".jpeg", ".tif"};
  if (std::ranges::find(others, ending) == others.end()) return;
  const std::string stem = std::filesystem::path(file).replace_extension(".svg").string();
  throw InputError({.what = option,
                    .value = file,
                    .expected = fmt::format("a file of SVG, such as '{}'; rsvg-convert -f {} or "
                                            "Inkscape converts it",
                                            stem, ending.substr(1))});
}

void SvgOption::require_apart_from(const std::vector<InputFile>& inputs) const {
  if (!is_given()) return;
  require_svg(text, "--svg");
  require_not_an_input(text, inputs, "--svg");
}

void SvgOption::write(const std::string& content) const {
  require_file_can_be_written(text, "--svg");
  for_option("--svg", [&] { write_file(text, content); });
}

CLI::Option* OutOption::add_to(CLI::App& command, const std::string& files) {
  return add(command, "--out", "Folder for " + files + " (default: none written)");
}

void OutOption::require_apart_from(const std::vector<InputFile>& inputs) const {
  if (is_given()) require_no_input_in(text, inputs);
}

std::filesystem::path OutOption::prepare() const {
  prepare_directory(text, "--out");
  require_file_can_be_written(std::filesystem::path(text) / "index.html", "--out");
  return text;
}

void ModelOption::add_to(CLI::App& command) {
  CLI::Option* hardware = hardware_.add_to(command);
  model_
      .add(command, "--model",
           "TOML file with hardware and effects beyond the friction model; see "
           "catalog/model/example.toml")
      ->excludes(hardware);
}

void ModelOption::add_with_friction_to(CLI::App& command) {
  add_to(command);
  friction_.add_to(command);
  friction_.exclude(*model_.option);
}

ModelFile ModelOption::read(const Catalogue& catalogue) const {
  if (model_.is_given()) {
    if (model_.text.empty()) throw no_file("--model");
    return read_model_file(model_.text, catalogue);
  }
  HardwareFile file = hardware_.read();
  friction_.apply(file.hardware);
  return {{file.hardware}, file.uncertainty, file.vary};
}

void ModelOption::list_in(std::vector<InputFile>& inputs) const {
  hardware_.list_in(inputs, "the hardware");
  model_.list_in(inputs, "the model");
}

namespace {

// Lists the tendons of a network that may have what the hardware gives tendon `wrong`.
std::vector<int> possible_tendons(Hardware hardware, const Network& network, TendonHardware wrong) {
  std::vector<int> possible;
  for (wrong.tendon = 1; std::cmp_less_equal(wrong.tendon, network.tendons.size());
       ++wrong.tendon) {
    hardware.tendon.own = {wrong};
    if (MechanicsBuilder(hardware).unmatched_tendons(network).empty()) {
      possible.push_back(wrong.tendon);
    }
  }
  return possible;
}

InputError no_such_tendon(const Hardware& hardware, const Network& network,
                          const std::string& number, const std::string& word) {
  const auto wrong = std::ranges::find_if(hardware.tendon.own, [&](const TendonHardware& own) {
    return std::to_string(own.tendon) == number;
  });
  const std::string needs = fmt::format(
      "{}{}{}", wrong->stiffness_N_mm ? "a spring needs a tendon with one end at an M" : "",
      wrong->stiffness_N_mm && wrong->slack_mm ? ", and " : "",
      wrong->slack_mm ? "slack one on a motor and on no block" : "");
  const std::vector<int> possible = possible_tendons(hardware, network, *wrong);
  return InputError(
      {.where = hardware_place(hardware, "tendon." + number),
       .what = "tendon",
       .value = number,
       .expected = possible.empty()
                       ? fmt::format("none in {}: {}", word, needs)
                       : fmt::format("{} of {}: {}", fmt::join(possible, " or "), word, needs)});
}

}  // namespace

void require_hardware_to_fit(const Hardware& hardware, const std::vector<Routing>& routings) {
  const MechanicsBuilder builder(hardware);
  std::vector<std::string> spools = builder.unmatched_spools({});
  for (const Routing& routing : routings) {
    const Network network = expand(routing);
    require_in_range(builder, network, to_word(routing));
    const std::vector<std::string> here = builder.unmatched_spools(network);
    std::erase_if(spools, [&](const std::string& spool) {
      return std::ranges::find(here, spool) == here.end();
    });
  }
  if (!spools.empty()) {
    throw InputError({.where = hardware_place(hardware, "spools." + spools.front()),
                      .what = "spools",
                      .value = spools.front(),
                      .expected = fmt::format("a motor-side segment that ends at an M (a P has no "
                                              "spool) in {}",
                                              place_of(routings))});
  }
  for (const Routing& routing : routings) {
    const Network network = expand(routing);
    const std::vector<std::string> unmatched = builder.unmatched_tendons(network);
    if (unmatched.empty()) continue;
    throw no_such_tendon(hardware, network, unmatched.front(), to_word(routing));
  }
}

void require_none_idle(const Hardware& hardware, const std::vector<std::string>& keys,
                       const std::string& where) {
  if (keys.empty()) return;
  const std::string& key = keys.front();
  constexpr std::string_view contact = "contact.";
  if (!key.starts_with(contact)) {
    throw InputError({.where = hardware_place(hardware, key),
                      .what = key,
                      .expected = fmt::format("a contact on which it acts in {}", where),
                      .form = InputForm::unknown});
  }
  throw InputError({.where = hardware_place(hardware, key),
                    .what = "contact",
                    .value = key.substr(contact.size()),
                    .expected = fmt::format("two segments with a contact between them, each "
                                            "contact once, in {}",
                                            where)});
}

void require_values_to_act(const Hardware& hardware, const std::vector<Routing>& routings) {
  int fingers = 0;
  for (const Routing& routing : routings) fingers = std::max(fingers, finger_count(routing));
  IdleValues idle(hardware, fingers);
  for (const Routing& routing : routings) idle.look_at(expand(routing));
  require_none_idle(hardware, idle.keys(), place_of(routings));
}

void FormatOption::add_to(CLI::App& command, const std::vector<std::string>& formats) {
  add_with_default(command, "--format", format, "How to print the result")->check(one_of(formats));
}

std::vector<Constraint> read_constraints(const std::vector<std::string>& texts) {
  std::vector<Constraint> constraints;
  for (const std::string& text : texts) {
    const Constraint constraint = for_name("--", [&] { return parse_constraint(text); });
    for (const Constraint& other : constraints) {
      if (other.text != constraint.text) continue;
      throw InputError(fmt::format("--constraint '{}' is given twice", constraint.text));
    }
    constraints.push_back(constraint);
  }
  return constraints;
}

void read_vary(const VaryTable& table, SizingOptions& options) {
  for (const GivenBounds& given : table.bounds) {
    options.varied.push_back(varied_range(given.name, {given.low, given.high}, given.place));
  }
  for (const GivenEqual& given : table.equal) {
    for (EqualGroup& group : for_option(given.place, [&] { return parse_equal(given.text); })) {
      group.text = given.place;
      options.equal.push_back(std::move(group));
    }
  }
}

}  // namespace reeve::cli
