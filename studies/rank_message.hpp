// What the processes of one search tell each other.
#pragma once

#include <cstdint>
#include <string>

#include "search/enumerate/generator.hpp"

namespace reeve::studies {

enum class RankWord : char {
  // Of a follower.
  ready = 'h',      // text: the id of the exploration that it has read
  brought = 'r',    // places.begin: of the piece; text: its record
  bad_input = 'i',  // text: of an InputError
  no_answer = 'o',  // text: of an OutOfRange
  failed = 'f',     // text: of another failure
  gone = 'b',
  // Of the leader.
  piece = 'p',  // places
  over = 'e',
};

struct RankMessage {
  RankWord word = RankWord::over;
  ShardRange places{};
  std::string text{};
};

std::string to_bytes(const RankMessage& message);
RankMessage rank_message(const std::string& bytes);

}  // namespace reeve::studies
