#include "core/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "core/ledgers.hpp"
#include "core/plates.hpp"
#include "core/text.hpp"
#include "core/word.hpp"

namespace reeve::core {
namespace {

// Far above any real routing (64 fingers take some 500 characters), far below what could hurt.
constexpr std::size_t max_word_length = 4096;

// A token that stands at an end of its walk, or inside it: Y1 and W1 mean another thing there.
enum class TokenPlace { end, inside };

constexpr std::array<std::pair<char, TokenKind>, 5> letters{{{'M', TokenKind::motor_end},
                                                             {'F', TokenKind::fixed_end},
                                                             {'T', TokenKind::tube_join},
                                                             {'B', TokenKind::bearing_join},
                                                             {'P', TokenKind::movable_pulley}}};

struct NumberedText {
  std::optional<int> number;  // without leading zeros, at most `highest`
  std::string_view suffix;
};

NumberedText read_number(std::string_view text, int highest) {
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  NumberedText read{std::nullopt, text.substr(digits)};
  if (digits == 0 || digits > 2 || text[0] == '0') return read;
  int number = 0;
  std::from_chars(text.data(), text.data() + digits, number);
  if (number <= highest) read.number = number;
  return read;
}

// Lengths of arms to three decimals.
std::optional<long long> read_arm(std::string_view text) {
  double arm = 0;
  const auto [end, error] =
      std::from_chars(text.data(), text.data() + text.size(), arm, std::chars_format::fixed);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  if (!(arm >= 0.001 && arm <= 10000)) return std::nullopt;
  return std::llround(arm * 1000);
}

std::optional<ArmRatio> read_arms(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return std::nullopt;
  const auto left = read_arm(text.substr(0, colon));
  const auto right = read_arm(text.substr(colon + 1));
  if (!left || !right) return std::nullopt;
  const long long common = std::gcd(*left, *right);
  constexpr long long largest = std::numeric_limits<std::uint16_t>::max();
  if (*left / common > largest || *right / common > largest) return std::nullopt;
  return ArmRatio{static_cast<std::uint16_t>(*left / common),
                  static_cast<std::uint16_t>(*right / common)};
}

std::string angle_text(WrapAngle angle) { return fmt::format("{}", angle.degrees()); }

// Written in one way only, so that a word is printed as it was read.
std::optional<WrapAngle> read_angle(std::string_view text) {
  double degrees = 0;
  std::from_chars(text.data(), text.data() + text.size(), degrees, std::chars_format::fixed);
  if (!(degrees >= 0.001 && degrees <= 3600)) return std::nullopt;
  const WrapAngle angle{static_cast<std::uint32_t>(std::llround(degrees * 1000))};
  return angle_text(angle) == text ? std::optional(angle) : std::nullopt;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool comes_back(const PlacedWalk& walk) {
  const Token& first = walk.front().token;
  const Token& last = walk.back().token;
  return walk.size() > 1 && first.kind == TokenKind::finger && last.kind == TokenKind::finger &&
         first.finger == last.finger;
}

class WordParser {
 public:
  explicit WordParser(std::string_view word) : word_{word} {}

  Routing parse() const;

 private:
  [[noreturn]] void refuse_inside(const PlacedText& at) const;
  Token read_finger(const PlacedText& at) const;
  Token read_on_carriage(const PlacedText& at, TokenKind kind) const;
  int block_number(const PlacedText& at, const NumberedText& read) const;
  Token read_block(const PlacedText& at, TokenPlace place) const;
  Token read_bar(const PlacedText& at, TokenPlace place) const;
  Token read_token(const PlacedText& at, TokenPlace place) const;
  Token read_angled(const PlacedText& at, TokenPlace place) const;
  PlacedWalk read_walk(std::size_t begin, std::size_t end) const;
  void require_ends(const PlacedWalk& walk) const;
  void require_inner_tokens(const PlacedWalk& walk) const;
  void require_equal_arms(const PlacedWalk& walk) const;
  Tendon read_tendon(PlacedWalk& walk) const;

  Word word_;
};

void WordParser::refuse_inside(const PlacedText& at) const {
  word_.fail(at, {.what = fmt::format("{} ends a walk and cannot stand inside it; join tendons "
                                      "with +",
                                      quoted_text(at.text))});
}

Token WordParser::read_finger(const PlacedText& at) const {
  const NumberedText read = read_number(at.text, max_fingers);
  if (!read.suffix.empty() && read.suffix != "b" && read.suffix != "x" && read.suffix != "e") {
    word_.fail(
        at, {.value = shown_text(at.text),
             .expected = "behind the finger number no suffix (tube at the fingertip), b (bearing), "
                         "x (the tendon is tied there) or e (tied on the back: an extensor)"});
  }
  if (!read.number) {
    word_.fail(at, {.value = shown_text(at.text),
                    .expected = fmt::format("a finger number from 1 to {}", max_fingers)});
  }
  if (read.suffix == "x") return anchored_tip(*read.number);
  if (read.suffix == "e") return anchored_tip(*read.number, TipKind::back);
  return finger(*read.number, read.suffix == "b" ? TipKind::bearing : TipKind::tube);
}

Token WordParser::read_on_carriage(const PlacedText& at, TokenKind kind) const {
  const NumberedText read = read_number(at.text.substr(1), max_carriages);
  if (!read.number || *read.number < 2 || !read.suffix.empty()) {
    word_.fail(at,
               {.value = shown_text(at.text),
                .expected = fmt::format("{} alone for the first motor, or the number of another "
                                        "motor behind it, from 2 to {}",
                                        at.text[0], max_carriages)});
  }
  return on_carriage(kind, *read.number);
}

int WordParser::block_number(const PlacedText& at, const NumberedText& read) const {
  if (!read.number) {
    word_.fail(
        at, {.value = shown_text(at.text),
             .expected = fmt::format("a {} number from 1 to {} behind {}",
                                     at.text[0] == 'Y' ? "block" : "bar", max_blocks, at.text[0])});
  }
  return *read.number;
}

Token WordParser::read_block(const PlacedText& at, TokenPlace place) const {
  const NumberedText read = read_number(at.text.substr(1), max_blocks);
  const int number = block_number(at, read);
  if (read.suffix == "k") return block(TokenKind::becket, number);
  if (!read.suffix.empty()) {
    word_.fail(at, {.value = shown_text(at.text),
                    .expected = "behind the block number nothing, or k for a becket"});
  }
  return block(place == TokenPlace::end ? TokenKind::block_tail : TokenKind::block_pass, number);
}

Token WordParser::read_bar(const PlacedText& at, TokenPlace place) const {
  const NumberedText read = read_number(at.text.substr(1), max_blocks);
  const int number = block_number(at, read);
  const bool third = read.suffix.starts_with('k');
  const std::string_view ratio = read.suffix.substr(third ? 1 : 0);
  if (third && place == TokenPlace::inside) refuse_inside(at);
  if (place == TokenPlace::end && !third) {
    if (ratio.empty()) return block(TokenKind::bar_pivot, number);
    word_.fail(
        at, {.value = shown_text(at.text),
             .expected = fmt::format("W{} alone: the end of a walk is tied to the bar's pivot, and "
                                     "a ratio belongs to its arms",
                                     number)});
  }
  if (ratio.empty()) return bar(number, third ? ArmRatio{1, 2} : ArmRatio{});
  const auto arms = ratio[0] == '/' ? read_arms(ratio.substr(1)) : std::nullopt;
  if (!arms) {
    word_.fail(at, {.value = shown_text(at.text),
                    .expected = "behind the bar number nothing, or the ratio of its neighbours' "
                                "tensions in positive numbers of at most three decimals, such as "
                                "W1/2:1; behind W1k that of the third tie to both others"});
  }
  return bar(number, *arms);
}

Token WordParser::read_token(const PlacedText& at, TokenPlace place) const {
  for (const auto& [letter, kind] : letters) {
    if (at.text.empty() || at.text[0] != letter) continue;
    if (at.text.size() == 1) return plain(kind);
    if (is_on_carriage(kind) && is_digit(at.text[1])) return read_on_carriage(at, kind);
  }
  const bool numbered = at.text.size() > 1 && is_digit(at.text[1]);
  if (!at.text.empty() && is_digit(at.text[0])) return read_finger(at);
  if (numbered && at.text[0] == 'Y') return read_block(at, place);
  if (numbered && at.text[0] == 'W') return read_bar(at, place);
  constexpr const char* expected =
      "M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1";
  if (at.text.empty()) word_.fail(at, {.what = "an empty token", .expected = expected});
  word_.fail(at, {.what = "unknown token", .value = shown_text(at.text), .expected = expected});
}

// A wrap angle stands behind a slash, where a bar has its ratio.
Token WordParser::read_angled(const PlacedText& at, TokenPlace place) const {
  const std::size_t slash = at.text.find('/');
  if (slash == std::string_view::npos || at.text[0] == 'W') return read_token(at, place);
  Token token = read_token({at.text.substr(0, slash), at.column}, place);
  if (!has_angle(token.kind)) {
    word_.fail(at, {.value = shown_text(at.text),
                    .expected = fmt::format("{} alone: a wrap angle belongs to a finger, T, B, P "
                                            "or a block inside a walk",
                                            at.text.substr(0, slash))});
  }
  const auto angle = read_angle(at.text.substr(slash + 1));
  if (!angle) {
    word_.fail(at, {.value = shown_text(at.text),
                    .expected = "behind / the wrap angle in degrees, from 0.001 to 3600 with at "
                                "most three decimals and no needless zeros, such as B/90"});
  }
  token.angle = *angle;
  return token;
}

PlacedWalk WordParser::read_walk(std::size_t begin, std::size_t end) const {
  PlacedWalk walk;
  const std::string_view all = word_.text.substr(begin, end - begin);
  walk.reserve(1 + static_cast<std::size_t>(std::count(all.begin(), all.end(), '-')));
  std::size_t at = begin;
  while (true) {
    const std::size_t dash = std::min(word_.text.find('-', at), end);
    const TokenPlace place = at == begin || dash == end ? TokenPlace::end : TokenPlace::inside;
    const PlacedText placed{word_.text.substr(at, dash - at), at + 1};
    walk.push_back({read_angled(placed, place), placed});
    if (dash == end) return walk;
    at = dash + 1;
  }
}

void WordParser::require_ends(const PlacedWalk& walk) const {
  for (const PlacedToken* outer : {&walk.front(), &walk.back()}) {
    if (!is_end(outer->token.kind)) {
      word_.fail(outer->at, {.what = fmt::format(
                                 "a walk must begin and end with M, F, a fingertip (1x) or a "
                                 "block (Y1), or come back to the finger that it began with, and "
                                 "{} does neither",
                                 quoted_text(outer->at.text))});
    }
  }
}

bool is_at_sheaves(const Token& token) {
  return token.kind == TokenKind::block_pass || token.kind == TokenKind::becket;
}

void WordParser::require_inner_tokens(const PlacedWalk& walk) const {
  for (std::size_t i = 1; i < walk.size(); ++i) {
    const TokenKind kind = walk[i].token.kind;
    if (is_end(kind) && i + 1 < walk.size()) refuse_inside(walk[i].at);
    if (is_of_finger(kind) && is_of_finger(walk[i - 1].token.kind)) {
      word_.fail(walk[i].at, {.what = fmt::format(
                                  "between two fingers a join is needed: T, B, P or a block before "
                                  "{}",
                                  quoted_text(walk[i].at.text))});
    }
    if (is_at_sheaves(walk[i].token) && is_at_sheaves(walk[i - 1].token) &&
        walk[i].token.block == walk[i - 1].token.block) {
      word_.fail(walk[i].at, {.what = fmt::format(
                                  "from {} straight to {} a tendon pulls block Y{} against itself: "
                                  "B, T, P or a finger is needed between, as in M-Y1-B-Y1k",
                                  quoted_text(walk[i - 1].at.text), quoted_text(walk[i].at.text),
                                  walk[i].token.block)});
    }
  }
}

// Rejects unequal arms: one loop pulls harder on the longer one until the bar lies in its line.
void WordParser::require_equal_arms(const PlacedWalk& walk) const {
  for (const PlacedToken& placed : walk) {
    if (placed.token.arms == ArmRatio{}) continue;
    word_.fail(placed.at, {.what = fmt::format(
                               "{}: a loop that is tied to both arms of a bar needs equal arms",
                               quoted_text(placed.at.text))});
  }
}

Tendon WordParser::read_tendon(PlacedWalk& walk) const {
  Tendon tendon;
  tendon.closed = comes_back(walk);
  if (!tendon.closed) require_ends(walk);
  if (walk.size() == 1) {
    word_.fail(walk.front().at, {.what = "the walk has one token: a second end is missing"});
  }
  require_inner_tokens(walk);
  if (tendon.closed) {
    if (walk.front().token != walk.back().token) {
      word_.fail(
          walk.back().at,
          {.what = fmt::format("the loop begins with {} and comes back to {}",
                               quoted_text(walk.front().at.text), quoted_text(walk.back().at.text)),
           .expected = "the same token"});
    }
    require_equal_arms(walk);
    walk.pop_back();
  }
  for (const PlacedToken& placed : walk) tendon.walk.push_back(placed.token);
  return tendon;
}

Routing WordParser::parse() const {
  if (word_.text.empty()) {
    throw InputError({.where = "routing ''",
                      .what = "the word is empty",
                      .expected = "e.g. M-1-T-2-F",
                      .form = InputForm::unknown});
  }
  if (word_.text.size() > max_word_length) {
    word_.fail({.what = fmt::format("the word has {} characters, at most {} are read",
                                    word_.text.size(), max_word_length)});
  }
  std::vector<PlacedWalk> walks;
  walks.reserve(1 +
                static_cast<std::size_t>(std::count(word_.text.begin(), word_.text.end(), '+')));
  for (std::size_t at = 0; at <= word_.text.size();) {
    const std::size_t plus = std::min(word_.text.find('+', at), word_.text.size());
    walks.push_back(read_walk(at, plus));
    at = plus + 1;
  }
  replace_plates(word_, walks);
  Routing routing;
  routing.tendons.reserve(walks.size());
  FingerLedger fingers(word_);
  CarriageLedger carriages(word_);
  BlockLedger blocks(word_);
  for (PlacedWalk& walk : walks) {
    routing.tendons.push_back(read_tendon(walk));
    fingers.pass(walk);
    carriages.pass(walk);
    blocks.pass(walk);
  }
  fingers.require_no_gap();
  carriages.require_no_gap();
  blocks.require_whole(routing);
  return routing;
}

void print_token(std::string& word, const Token& token) {
  for (const auto& [letter, kind] : letters) {
    if (kind == token.kind) word += letter;
  }
  if (is_on_carriage(token.kind) && token.carriage > 1) word += std::to_string(token.carriage);
  if (is_of_finger(token.kind)) word += fmt::format_int(token.finger).c_str();
  if (token.kind == TokenKind::anchored_tip) word += token.tip == TipKind::back ? 'e' : 'x';
  if (token.tip == TipKind::bearing) word += 'b';
  if (is_of_block(token.kind)) {
    word += is_of_bar(token.kind) ? 'W' : 'Y';
    word += std::to_string(token.block);
  }
  if (token.kind == TokenKind::becket) word += 'k';
  if (token.angle.is_given()) word += '/' + angle_text(token.angle);
  if (token.arms != ArmRatio{}) word += fmt::format("/{}:{}", token.arms.left, token.arms.right);
}

}  // namespace

Routing parse_routing(std::string_view word) { return WordParser(trimmed(word)).parse(); }

std::string to_word(const Routing& routing) {
  std::string word;
  for (const Tendon& tendon : routing.tendons) {
    if (!word.empty()) word += '+';
    for (std::size_t i = 0; i < tendon.walk.size(); ++i) {
      if (i > 0) word += '-';
      print_token(word, tendon.walk[i]);
    }
    if (tendon.closed) {
      word += '-';
      print_token(word, tendon.walk.front());
    }
  }
  return word;
}

}  // namespace reeve::core
