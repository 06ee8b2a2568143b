#include "search/enumerate/parts.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/text.hpp"

namespace reeve::search {
namespace {

template <typename Kind>
using Named = std::pair<const char*, Kind>;

constexpr std::array<Named<TipKind>, 2> tip_names{
    {{"tube", TipKind::tube}, {"bearing", TipKind::bearing}}};
constexpr std::array<Named<TokenKind>, 3> join_names{{{"T", TokenKind::tube_join},
                                                      {"B", TokenKind::bearing_join},
                                                      {"P", TokenKind::movable_pulley}}};
constexpr std::array<Named<TokenKind>, 2> end_names{
    {{"M", TokenKind::motor_end}, {"F", TokenKind::fixed_end}}};

template <typename Kind, std::size_t n>
std::vector<Kind> parse(const std::string& option, const std::string& text,
                        const std::array<Named<Kind>, n>& names) {
  std::vector<Kind> kinds;
  std::vector<std::string> labels;
  for (const auto& [label, kind] : names) labels.emplace_back(label);
  if (text.empty()) return kinds;
  for (const std::string& item : comma_separated(text)) {
    const auto found = std::find_if(names.begin(), names.end(),
                                    [&](const auto& named) { return named.first == item; });
    if (found == names.end()) {
      throw InputError(
          {.where = fmt::format("{} '{}'", option, text),
           .value = item,
           .expected = fmt::format("a comma-separated list of {}{}", fmt::join(labels, ", "),
                                   did_you_mean(item, labels))});
    }
    if (std::ranges::find(kinds, found->second) != kinds.end()) {
      throw InputError({.where = fmt::format("{} '{}'", option, text),
                        .what = fmt::format("'{}' is named twice", item)});
    }
    kinds.push_back(found->second);
  }
  std::sort(kinds.begin(), kinds.end());
  return kinds;
}

template <typename Kind, std::size_t n>
std::string print(const std::vector<Kind>& kinds, const std::array<Named<Kind>, n>& names) {
  std::string text;
  for (const auto& [label, kind] : names) {
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) continue;
    text += (text.empty() ? "" : ",") + std::string(label);
  }
  return text;
}

}  // namespace

PartSet paper_parts() {
  return {{TipKind::tube},
          {TokenKind::tube_join, TokenKind::movable_pulley},
          {TokenKind::motor_end, TokenKind::fixed_end}};
}

PartSet full_parts() {
  return {{TipKind::tube, TipKind::bearing},
          {TokenKind::tube_join, TokenKind::bearing_join, TokenKind::movable_pulley},
          {TokenKind::motor_end, TokenKind::fixed_end}};
}

PartSet all_parts() {
  PartSet parts = full_parts();
  parts.anchored = true;
  parts.blocks = 1;
  return parts;
}

std::vector<TipKind> parse_tips(const std::string& text) { return parse("tips", text, tip_names); }
std::vector<TokenKind> parse_joins(const std::string& text, const std::string& option) {
  return parse(option, text, join_names);
}
std::vector<TokenKind> parse_ends(const std::string& text) {
  return parse("ends", text, end_names);
}

std::string tips_text(const PartSet& parts) { return print(parts.tips, tip_names); }
std::string joins_text(const PartSet& parts) { return print(parts.joins, join_names); }
std::string beside_text(const PartSet& parts) { return print(parts.beside, join_names); }
std::string ends_text(const PartSet& parts) { return print(parts.ends, end_names); }

void validate(const PartSet& parts) {
  if (parts.tips.empty()) {
    throw InputError({.what = "tips", .value = "", .expected = "at least one of tube, bearing"});
  }
  if (parts.joins.empty() && parts.ends.empty()) {
    throw InputError({.what = "joins '' without ends", .expected = "at least one join or one end"});
  }
  if (parts.blocks < 0 || parts.blocks > max_generated_blocks) {
    throw InputError({.what = fmt::format("blocks {}", parts.blocks),
                      .expected = fmt::format("a number from 0 to {}", max_generated_blocks)});
  }
  if (parts.motors < 1 || parts.motors > max_carriages) {
    throw InputError({.what = fmt::format("motors {}", parts.motors),
                      .expected = fmt::format("a number from 1 to {}", max_carriages)});
  }
  if (parts.series && !parts.beside.empty()) {
    throw InputError({.what = "beside-ends",
                      .value = beside_text(parts),
                      .expected = "no joins beside ends together with blocks in series"});
  }
}

PartSet with_carriages(const PartSet& parts, int carriages) {
  PartSet result = parts;
  for (std::vector<TokenKind>* kinds : {&result.joins, &result.ends, &result.beside}) {
    const auto is_moved = std::stable_partition(
        kinds->begin(), kinds->end(), [](TokenKind kind) { return !is_on_carriage(kind); });
    const std::vector<TokenKind> moved(is_moved, kinds->end());
    kinds->erase(is_moved, kinds->end());
    for (int c = 0; c < carriages; ++c) kinds->insert(kinds->end(), moved.begin(), moved.end());
  }
  return result;
}

}  // namespace reeve::search
