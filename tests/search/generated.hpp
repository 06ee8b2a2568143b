// What a generator gives, and the parts that it is asked for in its tests.
#pragma once

#include <functional>
#include <string>
#include <tuple>
#include <vector>

#include "core/notation.hpp"
#include "search/enumerate/generator.hpp"
#include "search/evaluate/objectives.hpp"

namespace reeve::testing {

inline constexpr FingerIdentity identical = FingerIdentity::identical;
inline constexpr FingerIdentity distinct = FingerIdentity::distinct;

inline PartSet parts_of(const char* tips, const char* joins, const char* ends) {
  return {parse_tips(tips), parse_joins(joins), parse_ends(ends)};
}

// No joins, no ends, one kind only, no motor, nothing but motor.
inline std::vector<PartSet> odd_parts() {
  return {
      parts_of("tube", "T,P", ""),       parts_of("tube,bearing", "T,B,P", ""),
      parts_of("tube", "", "M,F"),       parts_of("tube,bearing", "", "M,F"),
      parts_of("tube", "P", ""),         parts_of("tube", "T", ""),
      parts_of("bearing", "", "M"),      parts_of("tube", "", "F"),
      parts_of("tube", "P", "F"),        parts_of("bearing", "T", "M"),
      parts_of("tube", "P", "M"),        parts_of("tube,bearing", "B", "F"),
      parts_of("bearing", "B,P", "M,F"),
  };
}

// The same parts, and what the member allows.
template <bool PartSet::*member>
PartSet allowing(PartSet parts) {
  parts.*member = true;
  return parts;
}

inline constexpr auto anchored = allowing<&PartSet::anchored>;
inline constexpr auto linked = allowing<&PartSet::linked>;
inline constexpr auto in_series = allowing<&PartSet::series>;
inline constexpr auto barred = allowing<&PartSet::bars>;
inline constexpr auto becketed = allowing<&PartSet::beckets>;
inline constexpr auto passed_twice = allowing<&PartSet::double_passes>;

inline PartSet with_blocks(PartSet parts, int blocks) {
  parts.blocks = blocks;
  return parts;
}

inline PartSet with_motors(PartSet parts, int motors) {
  parts.motors = motors;
  return parts;
}

inline PartSet with_beside(PartSet parts, const char* joins) {
  parts.beside = parse_joins(joins);
  return parts;
}

inline GeneratorOptions generating(const PartSet& parts, int fingers, FingerIdentity identity,
                                   bool one_tendon = false) {
  return {parts, fingers, identity, one_tendon};
}

inline std::vector<Constraint> constraints_of(const std::vector<std::string>& texts) {
  std::vector<Constraint> constraints;
  for (const std::string& text : texts) constraints.push_back(parse_constraint(text));
  return constraints;
}

inline std::vector<Routing> parsed(const std::vector<std::string>& words) {
  std::vector<Routing> routings;
  for (const std::string& word : words) routings.push_back(parse_routing(word));
  return routings;
}

inline std::string label_of(const GeneratorOptions& o) {
  return tips_text(o.parts) + " " + joins_text(o.parts) + " " + ends_text(o.parts) +
         (o.parts.anchored ? " x" : "") + ", " +
         (o.parts.blocks > 0 ? std::to_string(o.parts.blocks) + " blocks, " : "") +
         (o.parts.beside.empty() ? "" : "beside " + beside_text(o.parts) + ", ") +
         (o.parts.linked ? "linked, " : "") + (o.parts.series ? "in series, " : "") +
         (o.parts.bars ? "bars, " : "") + (o.parts.beckets ? "beckets, " : "") +
         (o.parts.double_passes ? "double passes, " : "") +
         (o.parts.motors > 1 ? std::to_string(o.parts.motors) + " motors, " : "") +
         std::to_string(o.fingers) + (o.identity == distinct ? " distinct" : "") + " fingers" +
         (o.one_tendon ? ", one tendon" : "");
}

inline void for_each_generated(const GeneratorOptions& o,
                               const std::function<void(const Routing&)>& visit) {
  RoutingGenerator generator(o);
  Routing routing;
  while (generator.next(routing)) visit(routing);
}

inline std::vector<std::string> generated_words(const GeneratorOptions& o) {
  std::vector<std::string> result;
  for_each_generated(o, [&](const Routing& routing) { result.push_back(to_word(routing)); });
  return result;
}

// M < F < 1x < finger (tube tip < bearing tip) < T < B < P
inline int token_rank(const Token& token) {
  return 2 * static_cast<int>(token.kind) + (token.tip == TipKind::bearing ? 1 : 0);
}

// Compares as canonical.hpp says: the tendons' shapes, and then the numbers of the fingers.
struct CanonicalKey {
  std::vector<std::tuple<int, bool, std::vector<int>>> shapes;
  std::vector<int> numbers;

  friend auto operator<=>(const CanonicalKey&, const CanonicalKey&) = default;
};

inline CanonicalKey canonical_key(const Routing& routing) {
  CanonicalKey key;
  for (const Tendon& tendon : routing.tendons) {
    std::vector<int> ranks;
    for (const Token& token : tendon.walk) {
      ranks.push_back(token_rank(token));
      if (is_of_finger(token.kind)) key.numbers.push_back(token.finger);
    }
    key.shapes.emplace_back(-finger_count(tendon), tendon.closed, ranks);
  }
  return key;
}

}  // namespace reeve::testing
