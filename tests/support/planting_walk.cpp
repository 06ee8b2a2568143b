#include "tests/support/planting_walk.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

namespace reeve::testing {
namespace {

std::vector<std::string> split_at(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

int finger_of_token(const std::string& token) { return is_digit(token[0]) ? std::stoi(token) : 0; }

// Counts what is numbered over all tendons of a word.
struct Names {
  int motor_sides = 0;
  int hands = 0;

  std::string motor_side() { return std::string(1, static_cast<char>('a' + motor_sides++)); }

  std::string stretch(const std::string& before, const std::string& after) {
    if (const int f = finger_of_token(before)) return "T" + std::to_string(2 * f);
    if (const int f = finger_of_token(after)) return "T" + std::to_string(2 * f - 1);
    return "h" + std::to_string(++hands);
  }
};

void pass(std::size_t token, Names& names, Walk& walk) {
  const std::string& text = walk.tokens[token];
  if (text == "P") {
    walk.links.push_back({LinkKind::sheath_before_pulley, token});
    walk.segments.push_back(names.motor_side());
    walk.links.push_back({LinkKind::pulley, token});
    walk.segments.push_back(names.motor_side());
    walk.links.push_back({LinkKind::sheath_after_pulley, token});
  } else {
    walk.links.push_back({finger_of_token(text) != 0 ? LinkKind::tip : LinkKind::join, token});
  }
}

Walk walk_of(const std::string& word, Names& names) {
  Walk walk;
  walk.tokens = split_at(word, '-');
  const auto& tokens = walk.tokens;
  const std::size_t last = tokens.size() - 1;
  walk.loop = finger_of_token(tokens[0]) != 0;
  if (tokens[0] == "M") {
    walk.segments.push_back(names.motor_side());
    walk.links.push_back({LinkKind::end_sheath, 0});
  }
  for (std::size_t i = 0; i < last; ++i) {
    if (i > 0) pass(i, names, walk);
    walk.segments.push_back(names.stretch(tokens[i], tokens[i + 1]));
  }
  if (walk.loop) walk.links.push_back({LinkKind::tip, last});
  if (tokens[last] == "M") {
    walk.links.push_back({LinkKind::end_sheath, last});
    walk.segments.push_back(names.motor_side());
  }
  return walk;
}

}  // namespace

std::string Walk::link_name(std::size_t k) const {
  return segments[k] + "-" + segments[(k + 1) % segments.size()];
}

std::vector<Walk> walks_of(const std::string& word) {
  std::vector<Walk> walks;
  Names names;
  for (const std::string& part : split_at(word, '+')) walks.push_back(walk_of(part, names));
  return walks;
}

bool is_strand(const std::string& segment) { return segment[0] == 'T'; }

bool is_motor_side(const std::string& segment) { return segment.size() == 1; }

int finger_of_strand(const std::string& segment) {
  return is_strand(segment) ? (std::stoi(segment.substr(1)) + 1) / 2 : 0;
}

std::set<int> fingers_of(const std::string& word) {
  std::set<int> fingers;
  for (const Walk& walk : walks_of(word)) {
    for (const std::string& token : walk.tokens) fingers.insert(finger_of_token(token));
  }
  fingers.erase(0);
  return fingers;
}

bool has_bearing(const std::string& word) { return word.find_first_of("PBb") != std::string::npos; }

}  // namespace reeve::testing
