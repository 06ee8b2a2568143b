#include "catalog/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "catalog/entry_file.hpp"
#include "catalog/mechanisms/mechanism_file.hpp"
#include "core/canonical.hpp"
#include "core/error.hpp"
#include "core/text.hpp"

namespace reeve::catalog {
namespace {

std::size_t token_count(const Routing& routing) {
  std::size_t count = 0;
  for (const Tendon& tendon : routing.tendons) count += tendon.walk.size();
  return count;
}

// True if a known routing has this size. This is faster than the canonical form of a routing.
bool may_be_known(const Catalogue& catalogue, const Routing& routing) {
  const std::size_t tokens = token_count(routing);
  const auto is_of_its_size = [&](const Routing& known) {
    return known.tendons.size() == routing.tendons.size() && token_count(known) == tokens;
  };
  return std::ranges::any_of(catalogue.entries,
                             [&](const auto& entry) { return is_of_its_size(entry.routing); }) ||
         std::ranges::any_of(catalogue.mechanisms, [&](const auto& mechanism) {
           return is_of_its_size(mechanism.canonical);
         });
}

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool same_name(std::string_view a, std::string_view b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [](char x, char y) { return lower(x) == lower(y); });
}

// Takes a run of digits off the front, without leading zeros.
std::string_view take_number(std::string_view& text) {
  std::size_t end = 0;
  while (end < text.size() && is_digit(text[end])) ++end;
  std::string_view number = text.substr(0, end);
  text.remove_prefix(end);
  while (number.size() > 1 && number[0] == '0') number.remove_prefix(1);
  return number;
}

// Runs of digits compare as numbers: TR2 before TR10.
bool precedes(std::string_view a, std::string_view b) {
  while (!a.empty() && !b.empty()) {
    if (is_digit(a[0]) && is_digit(b[0])) {
      const std::string_view m = take_number(a);
      const std::string_view n = take_number(b);
      if (m.size() != n.size()) return m.size() < n.size();
      if (m != n) return m < n;
      continue;
    }
    if (lower(a[0]) != lower(b[0])) return lower(a[0]) < lower(b[0]);
    a.remove_prefix(1);
    b.remove_prefix(1);
  }
  return a.size() < b.size();
}

void require_new_name(const Catalogue& catalogue, const std::string& name, const TomlNode& file) {
  const CatalogueEntry* entry = catalogue.find_name(name);
  const Mechanism* mechanism = catalogue.find_mechanism(name);
  if (entry == nullptr && mechanism == nullptr) return;
  file.find("name")->fail_expected(fmt::format("a name that is not taken ({} has it)",
                                               entry != nullptr ? entry->file : mechanism->file));
}

void require_new(const Catalogue& catalogue, const CatalogueEntry& entry, const TomlNode& file) {
  require_new_name(catalogue, entry.name, file);
  if (const CatalogueEntry* other = catalogue.find_word(entry.routing)) {
    file.find("word")->fail_expected(fmt::format(
        "a routing that is not in the catalogue yet ({} has it as {})", other->file, other->name));
  }
}

const std::string* other_routing(const Fault& fault) {
  if (const auto* repeats = std::get_if<RepeatsFault>(&fault.what)) return &repeats->routing;
  if (const auto* to = std::get_if<ProportionalFault>(&fault.what)) return &to->routing;
  return nullptr;
}

// True if a fault of `entry` can refer to `other`: by its table if there is one, else by lines of
// the same figure.
bool has_counterpart(const CatalogueEntry& entry, const CatalogueEntry& other) {
  if (entry.table) {
    return other.table && other.table->tension.size() == entry.table->tension.size();
  }
  return std::ranges::any_of(entry.lines, [&](const PublishedLines& own) {
    return std::ranges::any_of(other.lines, [&](const PublishedLines& theirs) {
      return theirs.source == own.source && theirs.share_percent.size() == own.share_percent.size();
    });
  });
}

void require_references(const Catalogue& catalogue) {
  for (const CatalogueEntry& entry : catalogue.entries) {
    for (const Fault& fault : entry.faults) {
      const std::string* wanted = other_routing(fault);
      if (wanted == nullptr) continue;
      const CatalogueEntry* other = catalogue.find_name(*wanted);
      if (other != nullptr && other != &entry && has_counterpart(entry, *other)) continue;
      throw InputError(
          {.where = fmt::format("{}:{}:{}", entry.file, fault.at.line, fault.at.column),
           .what = "fault.routing",
           .value = fmt::format("\"{}\"", *wanted),
           .expected = fmt::format("another routing in the catalogue, with {}",
                                   entry.table ? "a [table] of as many strands"
                                               : "[[lines]] of as many strands in the same figure"),
           .form = InputForm::equals});
    }
  }
}

void read_families(const CatalogueFiles& files, Catalogue& catalogue) {
  for (const std::string& family : files.folders("families")) {
    if (family == paper_family) {
      throw InputError({.where = "catalogue families/paper",
                        .what = "this name is taken",
                        .expected = "another, since the routings beside families/ are paper's",
                        .form = InputForm::unknown});
    }
    for (const TomlNode& file : files.toml("families/" + family)) {
      Mechanism mechanism = read_mechanism(file, family);
      require_new_name(catalogue, mechanism.name, file);
      catalogue.mechanisms.push_back(std::move(mechanism));
    }
  }
  std::stable_sort(catalogue.mechanisms.begin(), catalogue.mechanisms.end(),
                   [](const Mechanism& a, const Mechanism& b) {
                     return a.family != b.family ? a.family < b.family : precedes(a.name, b.name);
                   });
}

template <typename Item, typename IsMeant>
const Item* first_of(const std::vector<Item>& items, IsMeant is_meant) {
  const auto found = std::ranges::find_if(items, is_meant);
  return found == items.end() ? nullptr : &*found;
}

}  // namespace

std::string name_of(const Catalogue& catalogue, const Routing& routing) {
  if (!may_be_known(catalogue, routing)) return "";
  const Routing least = canonical(routing, FingerIdentity::identical);
  if (const CatalogueEntry* entry = catalogue.find_word(least)) return entry->name;
  for (const Mechanism& mechanism : catalogue.mechanisms) {
    if (mechanism.canonical == least) return mechanism.name;
  }
  return "";
}

const CatalogueEntry* Catalogue::find_name(std::string_view name) const {
  return first_of(
      entries, [&](const CatalogueEntry& entry) { return same_name(entry.name, trimmed(name)); });
}

const CatalogueEntry* Catalogue::find_word(const Routing& routing) const {
  return first_of(entries, [&](const CatalogueEntry& entry) { return entry.routing == routing; });
}

const Mechanism* Catalogue::find_mechanism(std::string_view name) const {
  return first_of(mechanisms, [&](const Mechanism& mechanism) {
    return same_name(mechanism.name, trimmed(name));
  });
}

const Routing* Catalogue::find_routing(std::string_view name) const {
  if (const CatalogueEntry* entry = find_name(name)) return &entry->routing;
  const Mechanism* mechanism = find_mechanism(name);
  return mechanism == nullptr ? nullptr : &mechanism->routing;
}

std::vector<Routing> Catalogue::sizes_of(std::string_view name) const {
  const CatalogueEntry* entry = find_name(name);
  const Mechanism* mechanism = find_mechanism(name);
  if (entry == nullptr && mechanism == nullptr) return {};
  std::vector<Routing> sizes = entry != nullptr ? entry->like : mechanism->like;
  sizes.push_back(*find_routing(name));
  std::ranges::sort(sizes, {}, [](const Routing& size) { return finger_count(size); });
  return sizes;
}

std::vector<std::string> Catalogue::families() const {
  std::vector<std::string> names;
  for (const Mechanism& mechanism : mechanisms) {
    if (names.empty() || names.back() != mechanism.family) names.push_back(mechanism.family);
  }
  return names;
}

Catalogue read_catalogue(const CatalogueFiles& files) {
  Catalogue catalogue;
  for (const TomlNode& file : files.toml("")) {
    CatalogueEntry entry = read_entry(file);
    require_new(catalogue, entry, file);
    catalogue.entries.push_back(std::move(entry));
  }
  std::sort(
      catalogue.entries.begin(), catalogue.entries.end(),
      [](const CatalogueEntry& a, const CatalogueEntry& b) { return precedes(a.name, b.name); });
  require_references(catalogue);
  read_families(files, catalogue);
  return catalogue;
}

Catalogue read_catalogue(const std::filesystem::path& folder) {
  return read_catalogue(CatalogueFiles::in(folder));
}

}  // namespace reeve::catalog
