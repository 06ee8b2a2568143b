#include "tests/support/reference_walk.hpp"

#include <cctype>
#include <cstddef>
#include <sstream>
#include <stdexcept>

namespace reeve::testing::reference {

namespace {

std::vector<std::string> split(const std::string& text, char separator) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) parts.push_back(part);
  return parts;
}

int finger_of(const std::string& token) {
  return std::isdigit(static_cast<unsigned char>(token.at(0))) ? std::stoi(token) : 0;
}

bool is_extensor(const std::string& token) { return finger_of(token) != 0 && token.back() == 'e'; }

bool is_anchored(const std::string& token) {
  return is_extensor(token) || (finger_of(token) != 0 && token.back() == 'x');
}

bool is_on_carriage(const std::string& token, char letter) {
  return token.at(0) == letter && (token.size() == 1 || (token.size() == 2 && token[1] > '1'));
}

int carriage_of(const std::string& token) { return token.size() == 1 ? 1 : token[1] - '0'; }

bool is_block(const std::string& token) { return token.at(0) == 'Y' || token.at(0) == 'W'; }

std::string tip_kind(const std::string& token) { return token.back() == 'b' ? "bearing" : "tube"; }

// 0 -> a, 25 -> z, 26 -> aa, ...
std::string letters(int number) {
  std::string name;
  for (int rest = number + 1; rest > 0; rest = (rest - 1) / 26)
    name.insert(name.begin(), static_cast<char>('a' + (rest - 1) % 26));
  return name;
}

class Reader {
 public:
  std::vector<Tendon> read(const std::string& word) {
    std::vector<Tendon> tendons;
    for (const auto& walk : split(word, '+')) tendons.push_back(read_walk(split(walk, '-')));
    return tendons;
  }

 private:
  Tendon read_walk(const std::vector<std::string>& tokens) {
    Tendon tendon;
    tendon.tokens = tokens;
    tendon.loop = tokens.size() > 1 && finger_of(tokens.front()) != 0 &&
                  !is_anchored(tokens.front()) && tokens.front() == tokens.back();
    if (is_on_carriage(tokens.front(), 'M')) {
      tendon.segments.push_back(motor_side(tokens.front()));
      tendon.kinds.emplace_back("sheath");
    }
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
      if (i > 0) pass(tokens[i], tendon);
      tendon.places.resize(tendon.kinds.size(), i);
      tendon.segments.push_back(stretch(tokens[i], tokens[i + 1]));
    }
    if (is_on_carriage(tokens.back(), 'M')) {
      tendon.kinds.emplace_back("sheath");
      tendon.segments.push_back(motor_side(tokens.back()));
    }
    tie(tokens.front(), 0, tendon);
    tie(tokens.back(), tendon.segments.size() - 1, tendon);
    if (tendon.loop) tendon.kinds.push_back(tip_kind(tokens.front()));
    tendon.places.resize(tendon.kinds.size(), tokens.size() - 1);
    for (const auto& segment : tendon.segments)
      if (segment.finger != 0) tendon.fingers.insert(segment.finger);
    return tendon;
  }

  static void tie(const std::string& end, std::size_t segment, Tendon& tendon) {
    if (!is_block(end)) return;
    const bool becket = end.back() == 'k';
    const std::string block = becket ? end.substr(0, end.size() - 1) : end;
    check_name(block, end);
    tendon.ends.push_back({block, segment, becket});
  }

  static void pass_block(const std::string& token, Tendon& tendon) {
    const bool bar = token[0] == 'W';
    const std::size_t slash = bar ? token.find('/') : std::string::npos;
    BlockPass pass{token.substr(0, slash), tendon.kinds.size(), bar, 1, 1};
    check_name(pass.block, token);
    if (slash != std::string::npos) {
      std::istringstream ratio(token.substr(slash + 1));
      char colon = 0;
      ratio >> pass.left >> colon >> pass.right;
      if (!ratio || colon != ':' || !(pass.left > 0 && pass.right > 0)) unknown(token);
    }
    tendon.passes.push_back(pass);
    tendon.kinds.emplace_back(bar ? "bar" : "block");
  }

  static void check_name(const std::string& block, const std::string& token) {
    const bool number =
        block.size() > 1 && block.find_first_not_of("0123456789", 1) == std::string::npos;
    if (!number) unknown(token);
  }

  [[noreturn]] static void unknown(const std::string& token) {
    throw std::invalid_argument("the reference model does not know the token " + token);
  }

  void pass(const std::string& token, Tendon& tendon) {
    if (is_block(token)) {
      pass_block(token, tendon);
    } else if (finger_of(token) != 0 && !is_anchored(token)) {
      tendon.kinds.push_back(tip_kind(token));
    } else if (token == "T") {
      tendon.kinds.emplace_back("tube");
    } else if (token == "B") {
      tendon.kinds.emplace_back("bearing");
    } else if (is_on_carriage(token, 'P')) {
      for (const char* kind : {"sheath", "bearing", "sheath"}) tendon.kinds.emplace_back(kind);
      for (int side = 0; side < 2; ++side) tendon.segments.push_back(motor_side(token));
    } else {
      unknown(token);
    }
  }

  Segment motor_side(const std::string& token) {
    return {letters(motor_sides_++), Place::motor_side, 0, carriage_of(token)};
  }

  Segment stretch(const std::string& before, const std::string& after) {
    if (is_anchored(before)) return tied_strand(before);
    if (const int f = finger_of(before)) return {"T" + std::to_string(2 * f), Place::strand, f};
    if (is_anchored(after)) return tied_strand(after);
    if (const int f = finger_of(after)) return {"T" + std::to_string(2 * f - 1), Place::strand, f};
    return {"h" + std::to_string(++hands_), Place::hand, 0};
  }

  Segment tied_strand(const std::string& token) {
    const int f = finger_of(token);
    const bool second = is_extensor(token) || !flexed_.insert(f).second;
    return {"T" + std::to_string(second ? 2 * f : 2 * f - 1), Place::strand, f, 0,
            is_extensor(token)};
  }

  std::set<int> flexed_;
  int motor_sides_ = 0;
  int hands_ = 0;
};

}  // namespace

std::vector<Tendon> read_tendons(const std::string& word) { return Reader().read(word); }

}  // namespace reeve::testing::reference
