#include "core/notation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "core/ledgers.hpp"
#include "core/token_text.hpp"
#include "core/word_fault.hpp"

namespace reeve::core {
namespace {

// Far above any real routing (64 fingers take some 500 characters), far below what could hurt.
constexpr std::size_t max_word_length = 4096;

PlacedWalk read_walk(std::string_view word, std::size_t begin, std::size_t end) {
  PlacedWalk walk;
  const std::string_view all = word.substr(begin, end - begin);
  walk.reserve(1 + static_cast<std::size_t>(std::count(all.begin(), all.end(), '-')));
  std::size_t at = begin;
  while (true) {
    const std::size_t dash = std::min(word.find('-', at), end);
    const std::string_view text = word.substr(at, dash - at);
    const TokenPlace place = at == begin || dash == end ? TokenPlace::end : TokenPlace::inside;
    walk.push_back({read_token(word, text, at + 1, place), text, at + 1});
    if (dash == end) return walk;
    at = dash + 1;
  }
}

void require_ends(std::string_view word, const PlacedWalk& walk) {
  for (const PlacedToken* outer : {&walk.front(), &walk.back()}) {
    if (!is_end(outer->token.kind)) {
      fail_word(
          word, outer->column,
          {.what = fmt::format("a walk must begin and end with M, F, a fingertip (1x) or a "
                               "block (Y1), or come back to the finger that it began with, and "
                               "{} does neither",
                               quoted_text(outer->text))});
    }
  }
}

void require_inner_tokens(std::string_view word, const PlacedWalk& walk) {
  for (std::size_t i = 1; i < walk.size(); ++i) {
    const TokenKind kind = walk[i].token.kind;
    if (is_end(kind) && i + 1 < walk.size()) {
      fail_word(
          word, walk[i].column,
          {.what = fmt::format("{} ends a walk and cannot stand inside it; join tendons with +",
                               quoted_text(walk[i].text))});
    }
    if (is_of_finger(kind) && is_of_finger(walk[i - 1].token.kind)) {
      fail_word(
          word, walk[i].column,
          {.what = fmt::format("between two fingers a join is needed: T, B, P or a block before "
                               "{}",
                               quoted_text(walk[i].text))});
    }
  }
}

// Of unequal arms, one loop pulls harder on the longer one until the bar lies in its line.
void require_equal_arms(std::string_view word, const PlacedWalk& walk) {
  for (const PlacedToken& placed : walk) {
    if (placed.token.arms == ArmRatio{}) continue;
    fail_word(word, placed.column,
              {.what = fmt::format("{}: a loop that is tied to both arms of a bar needs equal arms",
                                   quoted_text(placed.text))});
  }
}

bool comes_back(const PlacedWalk& walk) {
  const Token& first = walk.front().token;
  const Token& last = walk.back().token;
  return walk.size() > 1 && first.kind == TokenKind::finger && last.kind == TokenKind::finger &&
         first.finger == last.finger;
}

Tendon read_tendon(std::string_view word, PlacedWalk& walk) {
  Tendon tendon;
  tendon.closed = comes_back(walk);
  if (!tendon.closed) require_ends(word, walk);
  if (walk.size() == 1) {
    fail_word(word, walk.front().column,
              {.what = "the walk has one token: a second end is missing"});
  }
  require_inner_tokens(word, walk);
  if (tendon.closed) {
    if (walk.front().token != walk.back().token) {
      fail_word(word, walk.back().column,
                {.what = fmt::format("the loop begins with {} and comes back to {}",
                                     quoted_text(walk.front().text), quoted_text(walk.back().text)),
                 .expected = "the same token"});
    }
    require_equal_arms(word, walk);
    walk.pop_back();
  }
  for (const PlacedToken& placed : walk) tendon.walk.push_back(placed.token);
  return tendon;
}

}  // namespace

Routing parse_routing(std::string_view word) {
  if (word.empty()) {
    throw InputError({.where = "routing ''",
                      .what = "the word is empty",
                      .expected = "e.g. M-1-T-2-F",
                      .form = InputForm::unknown});
  }
  if (word.size() > max_word_length) {
    fail_word(word, {.what = fmt::format("the word has {} characters, at most {} are read",
                                         word.size(), max_word_length)});
  }
  Routing routing;
  routing.tendons.reserve(1 + static_cast<std::size_t>(std::count(word.begin(), word.end(), '+')));
  FingerLedger fingers(word);
  BlockLedger blocks(word);
  std::size_t at = 0;
  while (true) {
    const std::size_t plus = std::min(word.find('+', at), word.size());
    PlacedWalk walk = read_walk(word, at, plus);
    routing.tendons.push_back(read_tendon(word, walk));
    fingers.pass(walk);
    blocks.pass(walk);
    if (plus == word.size()) break;
    at = plus + 1;
  }
  fingers.require_no_gap();
  blocks.require_whole(routing);
  return routing;
}

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
