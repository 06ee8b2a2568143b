#include "core/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace reeve::core {
namespace {

// Far above any real routing (64 fingers take some 500 characters), far below what could hurt.
constexpr std::size_t max_word_length = 4096;

constexpr std::array<std::pair<char, TokenKind>, 5> letters{{{'M', TokenKind::motor_end},
                                                             {'F', TokenKind::fixed_end},
                                                             {'T', TokenKind::tube_join},
                                                             {'B', TokenKind::bearing_join},
                                                             {'P', TokenKind::movable_pulley}}};

struct Placed {
  Token token;
  std::string_view text;
  std::size_t column;
};

// As it can be shown: short, and printable.
std::string shown(std::string_view word) {
  std::size_t shown_bytes = std::min<std::size_t>(word.size(), 60);
  // Not in the middle of a UTF-8 sequence.
  while (shown_bytes < word.size() && (word[shown_bytes] & '\xC0') == '\x80') --shown_bytes;
  std::string text;
  for (const char c : word.substr(0, shown_bytes)) {
    const bool plain = std::isprint(static_cast<unsigned char>(c)) != 0 || (c & '\x80') != 0;
    text += plain ? c : '?';
  }
  return shown_bytes < word.size() ? text + "…" : text;
}

std::string quoted(std::string_view word) { return "'" + shown(word) + "'"; }

// Of a token: what it is called, and what was expected in its place.
[[noreturn]] void fail(std::string_view word, std::size_t column, InputFault fault) {
  fault.where = fmt::format("routing {}, column {}", quoted(word), column);
  throw InputError(std::move(fault));
}

Token read_finger(std::string_view word, std::string_view text, std::size_t column) {
  const std::size_t digits = text.find_first_not_of("0123456789");
  const std::string_view number = text.substr(0, digits);
  const std::string_view suffix = digits == std::string_view::npos ? "" : text.substr(digits);
  if (suffix == "x") {
    fail(word, column,
         {.what =
              fmt::format("{}: a tendon anchored at the fingertip (suffix x) is not yet supported",
                          quoted(text))});
  }
  if (!suffix.empty() && suffix != "b") {
    fail(word, column,
         {.value = shown(text),
          .expected = "no suffix (tube at the fingertip) or b (bearing) behind the finger number"});
  }
  if (number[0] == '0' || number.size() > 2 || std::stoi(std::string(number)) > max_fingers) {
    fail(word, column,
         {.value = shown(text),
          .expected = fmt::format("a finger number from 1 to {}", max_fingers)});
  }
  return finger(std::stoi(std::string(number)), suffix == "b" ? TipKind::bearing : TipKind::tube);
}

Token read_token(std::string_view word, std::string_view text, std::size_t column) {
  for (const auto& [letter, kind] : letters) {
    if (text.size() == 1 && text[0] == letter) return {kind, TipKind::tube, 0};
  }
  if (!text.empty() && std::isdigit(static_cast<unsigned char>(text[0])) != 0) {
    return read_finger(word, text, column);
  }
  if (!text.empty() && text[0] == 'Y') {
    fail(word, column,
         {.what = fmt::format("{}: floating pulleys (Y) are not yet supported", quoted(text))});
  }
  constexpr const char* expected = "M, F, T, B, P or a finger number such as 1 or 2b";
  if (text.empty()) fail(word, column, {.what = "an empty token", .expected = expected});
  fail(word, column, {.what = "unknown token", .value = shown(text), .expected = expected});
}

std::vector<Placed> read_walk(std::string_view word, std::size_t begin, std::size_t end) {
  std::vector<Placed> walk;
  std::size_t at = begin;
  while (true) {
    const std::size_t dash = std::min(word.find('-', at), end);
    const std::string_view text = word.substr(at, dash - at);
    walk.push_back({read_token(word, text, at + 1), text, at + 1});
    if (dash == end) return walk;
    at = dash + 1;
  }
}

void require_ends(std::string_view word, const std::vector<Placed>& walk) {
  for (const Placed* outer : {&walk.front(), &walk.back()}) {
    if (!is_end(outer->token.kind)) {
      fail(word, outer->column,
           {.what = fmt::format("a walk must begin and end with M or F, or come back to the "
                                "finger that it began with, and {} does neither",
                                quoted(outer->text))});
    }
  }
}

void require_inner_tokens(std::string_view word, const std::vector<Placed>& walk) {
  for (std::size_t i = 1; i < walk.size(); ++i) {
    const TokenKind kind = walk[i].token.kind;
    if (is_end(kind) && i + 1 < walk.size()) {
      fail(word, walk[i].column,
           {.what = fmt::format("{} ends a walk and cannot stand inside it; join tendons with +",
                                quoted(walk[i].text))});
    }
    if (kind == TokenKind::finger && walk[i - 1].token.kind == TokenKind::finger) {
      fail(word, walk[i].column,
           {.what = fmt::format("between two fingers a join is needed: T, B or P before {}",
                                quoted(walk[i].text))});
    }
  }
}

bool comes_back(const std::vector<Placed>& walk) {
  const Token& first = walk.front().token;
  const Token& last = walk.back().token;
  return walk.size() > 1 && first.kind == TokenKind::finger && last.kind == TokenKind::finger &&
         first.finger == last.finger;
}

Tendon read_tendon(std::string_view word, std::vector<Placed>& walk) {
  Tendon tendon;
  tendon.closed = comes_back(walk);
  if (!tendon.closed) require_ends(word, walk);
  if (walk.size() == 1) {
    fail(word, walk.front().column, {.what = "the walk has one token: a second end is missing"});
  }
  require_inner_tokens(word, walk);
  if (tendon.closed) {
    if (walk.front().token != walk.back().token) {
      fail(word, walk.back().column,
           {.what = fmt::format("the loop begins with {} and comes back to {}",
                                quoted(walk.front().text), quoted(walk.back().text)),
            .expected = "the same token"});
    }
    walk.pop_back();
  }
  for (const Placed& placed : walk) tendon.walk.push_back(placed.token);
  return tendon;
}

class FingerLedger {
 public:
  explicit FingerLedger(std::string_view word) : word_(word) {}

  void pass(const std::vector<Placed>& walk) {
    for (const Placed& placed : walk) {
      if (placed.token.kind != TokenKind::finger) continue;
      if (std::exchange(passed_[placed.token.finger], true)) {
        fail(word_, placed.column,
             {.what =
                  fmt::format("finger {} is passed twice; a finger has two strands and one tendon",
                              placed.token.finger)});
      }
      highest_ = std::max<int>(highest_, placed.token.finger);
    }
  }

  void require_no_gap() const {
    for (std::size_t f = 1; f < static_cast<std::size_t>(highest_); ++f) {
      if (!passed_[f]) {
        throw InputError(
            {.where = "routing " + quoted(word_),
             .what = fmt::format("finger {} is missing; fingers are numbered 1 to {} without a gap",
                                 f, highest_)});
      }
    }
  }

 private:
  std::string_view word_;
  std::array<bool, max_fingers + 1> passed_{};
  int highest_ = 0;
};

}  // namespace

Routing parse_routing(std::string_view word) {
  if (word.empty()) {
    throw InputError({.where = "routing ''",
                      .what = "the word is empty",
                      .expected = "e.g. M-1-T-2-F",
                      .form = InputForm::unknown});
  }
  if (word.size() > max_word_length) {
    throw InputError({.where = "routing " + quoted(word),
                      .what = fmt::format("the word has {} characters, at most {} are read",
                                          word.size(), max_word_length)});
  }
  Routing routing;
  FingerLedger ledger(word);
  std::size_t at = 0;
  while (true) {
    const std::size_t plus = std::min(word.find('+', at), word.size());
    std::vector<Placed> walk = read_walk(word, at, plus);
    routing.tendons.push_back(read_tendon(word, walk));
    ledger.pass(walk);
    if (plus == word.size()) break;
    at = plus + 1;
  }
  ledger.require_no_gap();
  return routing;
}

namespace {

void print_token(std::string& word, const Token& token) {
  if (token.kind == TokenKind::finger) {
    word += std::to_string(token.finger);
    if (token.tip == TipKind::bearing) word += 'b';
    return;
  }
  for (const auto& [letter, kind] : letters) {
    if (kind == token.kind) word += letter;
  }
}

}  // namespace

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
