#include "reports/exploration/listed_design_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "reports/exploration/design_list.hpp"
#include "reports/output/json_text.hpp"

namespace reeve::reports {
namespace {

// Of a value within a design: the keys that lead there.
using KeyPath = std::vector<std::string>;

KeyPath path_of(const ObjectiveRow& row) {
  KeyPath path;
  if (row.of_hand) path.emplace_back("hand");
  path.emplace_back(row.family);
  if (*row.part != '\0') path.emplace_back(row.part);
  return path;
}

std::string member_indent(std::size_t depth) { return std::string(6 + 2 * depth, ' '); }

// From behind the value at one path to before that at another.
std::string way_between(const KeyPath& from, const KeyPath& to) {
  const std::size_t most = std::min(from.size(), to.size()) - 1;
  std::size_t shared = 0;
  while (shared < most && from[shared] == to[shared]) ++shared;
  std::string text;
  for (std::size_t depth = from.size() - 1; depth > shared; --depth) {
    text += "\n" + member_indent(depth - 1) + "}";
  }
  text += ",\n";
  for (std::size_t depth = shared; depth < to.size(); ++depth) {
    text += member_indent(depth) + '"' + to[depth] + "\": ";
    if (depth + 1 < to.size()) text += "{\n";
  }
  return text;
}

// A word needs no escapes.
void append_word(std::string& text, std::string_view word) {
  text += '"';
  text += word;
  text += '"';
}

void append_word_or_null(std::string& text, const std::string& word) {
  if (word.empty()) {
    text += "null";
  } else {
    append_word(text, word);
  }
}

void append_name(std::string& text, const std::string& name) {
  if (name.empty()) {
    text += "null";
  } else {
    append_indented(text, Json(name), "");
  }
}

void append_words(std::string& text, const std::vector<std::string>& words) {
  if (words.empty()) {
    text += "[]";
    return;
  }
  const std::string before = "\n" + member_indent(1);
  for (std::size_t i = 0; i < words.size(); ++i) {
    text += (i == 0 ? "[" : ",") + before;
    append_word(text, words[i]);
  }
  text += "\n" + member_indent(0) + "]";
}

}  // namespace

ListedDesignText::Members ListedDesignText::members(bool hand) {
  Members members;
  KeyPath before{"name"};
  const auto add = [&](const ObjectiveRow& row, KeyPath path) {
    members.list.push_back({&row, way_between(before, path)});
    before = std::move(path);
  };
  for (const ObjectiveRow& row : objective_table()) {
    if (row.of_hand && !hand) continue;
    add(row, path_of(row));
    if (row.objective == Objective::round_trip_efficiency) add(row, {"return_friction"});
  }
  members.after = way_between(before, {"alike"});
  return members;
}

ListedDesignText::ListedDesignText()
    : without_hand_(members(false)), with_hand_(members(true)), numbers_(print_json_number) {}

void ListedDesignText::append_objectives(std::string& text, const ObjectiveValues& values) {
  const Members& members = search::has_hand(values) ? with_hand_ : without_hand_;
  for (const Member& member : members.list) {
    text += member.before;
    const double given = value(values, member.row->objective);
    if (member.row->is_count()) {
      const fmt::format_int count(static_cast<int>(given));
      text.append(count.data(), count.size());
    } else {
      text += numbers_.text(given);
    }
  }
  text += members.after;
}

void ListedDesignText::append(std::string& text, const ListedDesign& design) {
  // What draws say is small beside the time that they take.
  if (design.distribution || design.constraints_met) {
    append_indented(text, to_json(design), "    ");
    return;
  }
  const RankedDesign& ranked = design.ranked;
  text += "{\n      \"rank\": ";
  text += fmt::format_int(ranked.rank).c_str();
  text += ",\n      \"front\": ";
  text += fmt::format_int(ranked.front).c_str();
  text += ",\n      \"routing\": ";
  append_word(text, ranked.design.word);
  text += ",\n      \"name\": ";
  append_name(text, design.name);
  append_objectives(text, ranked.design.values);
  append_words(text, design.equivalent);
  text += ",\n      \"same_as\": ";
  append_word_or_null(text, design.same_as);
  text += ",\n      \"place\": ";
  text += fmt::format_int(design.place).c_str();
  text += "\n    }";
}

}  // namespace reeve::reports
