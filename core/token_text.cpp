#include "core/token_text.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "core/word_fault.hpp"

namespace reeve::core {
namespace {

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

Token read_finger(std::string_view word, std::string_view text, std::size_t column) {
  const NumberedText read = read_number(text, max_fingers);
  if (!read.suffix.empty() && read.suffix != "b" && read.suffix != "x") {
    fail_word(
        word, column,
        {.value = shown_text(text),
         .expected = "behind the finger number no suffix (tube at the fingertip), b (bearing) "
                     "or x (the tendon is tied there)"});
  }
  if (!read.number) {
    fail_word(word, column,
              {.value = shown_text(text),
               .expected = fmt::format("a finger number from 1 to {}", max_fingers)});
  }
  if (read.suffix == "x") return anchored_tip(*read.number);
  return finger(*read.number, read.suffix == "b" ? TipKind::bearing : TipKind::tube);
}

int block_number(std::string_view word, std::string_view text, std::size_t column,
                 const NumberedText& read) {
  if (!read.number) {
    fail_word(word, column,
              {.value = shown_text(text),
               .expected = fmt::format("a {} number from 1 to {} behind {}",
                                       text[0] == 'Y' ? "block" : "bar", max_blocks, text[0])});
  }
  return *read.number;
}

Token read_block(std::string_view word, std::string_view text, std::size_t column,
                 TokenPlace place) {
  const NumberedText read = read_number(text.substr(1), max_blocks);
  const int number = block_number(word, text, column, read);
  if (read.suffix == "k") return block(TokenKind::becket, number);
  if (!read.suffix.empty()) {
    fail_word(word, column,
              {.value = shown_text(text),
               .expected = "behind the block number nothing, or k for a becket"});
  }
  return block(place == TokenPlace::end ? TokenKind::block_tail : TokenKind::block_pass, number);
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

Token read_bar(std::string_view word, std::string_view text, std::size_t column, TokenPlace place) {
  const NumberedText read = read_number(text.substr(1), max_blocks);
  const int number = block_number(word, text, column, read);
  if (read.suffix == "k") {
    fail_word(
        word, column,
        {.what = fmt::format("{}: a bar has no becket; its two arms are its neighbours inside "
                             "a walk, as in 1x-W1-2x",
                             quoted_text(text))});
  }
  if (place == TokenPlace::end) {
    if (read.suffix.empty()) return block(TokenKind::bar_pivot, number);
    fail_word(
        word, column,
        {.value = shown_text(text),
         .expected = fmt::format("W{} alone: the end of a walk is tied to the bar's pivot, and "
                                 "a ratio belongs to its arms",
                                 number)});
  }
  if (read.suffix.empty()) return bar(number);
  const auto arms = read.suffix[0] == '/' ? read_arms(read.suffix.substr(1)) : std::nullopt;
  if (!arms) {
    fail_word(
        word, column,
        {.value = shown_text(text),
         .expected = "behind the bar number nothing, or the ratio of its neighbours' tensions "
                     "in positive numbers of at most three decimals, such as W1/2:1"});
  }
  return bar(number, *arms);
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }

}  // namespace

Token read_token(std::string_view word, std::string_view text, std::size_t column,
                 TokenPlace place) {
  for (const auto& [letter, kind] : letters) {
    if (text.size() == 1 && text[0] == letter) return plain(kind);
  }
  const bool numbered = text.size() > 1 && is_digit(text[1]);
  if (!text.empty() && is_digit(text[0])) return read_finger(word, text, column);
  if (numbered && text[0] == 'Y') return read_block(word, text, column, place);
  if (numbered && text[0] == 'W') return read_bar(word, text, column, place);
  constexpr const char* expected =
      "M, F, T, B, P, a finger such as 1, 2b or 3x, a block such as Y1 or Y1k, or a bar such as W1";
  if (text.empty()) fail_word(word, column, {.what = "an empty token", .expected = expected});
  fail_word(word, column,
            {.what = "unknown token", .value = shown_text(text), .expected = expected});
}

void print_token(std::string& word, const Token& token) {
  for (const auto& [letter, kind] : letters) {
    if (kind == token.kind) word += letter;
  }
  if (is_of_finger(token.kind)) word += fmt::format_int(token.finger).c_str();
  if (token.kind == TokenKind::anchored_tip) word += 'x';
  if (token.tip == TipKind::bearing) word += 'b';
  if (!is_of_block(token.kind)) return;
  word += is_of_bar(token.kind) ? 'W' : 'Y';
  word += std::to_string(token.block);
  if (token.kind == TokenKind::becket) word += 'k';
  if (token.arms != ArmRatio{}) word += fmt::format("/{}:{}", token.arms.left, token.arms.right);
}

}  // namespace reeve::core
