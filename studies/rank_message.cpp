#include "studies/rank_message.hpp"

#include <cstring>

namespace reeve::studies {
namespace {

// In the machine's own order: all run the same program on the same kind of machine.
constexpr std::size_t head = 1 + sizeof(ShardRange);

}  // namespace

std::string to_bytes(const RankMessage& message) {
  std::string bytes(head, static_cast<char>(message.word));
  std::memcpy(bytes.data() + 1, &message.places, sizeof message.places);
  return bytes + message.text;
}

RankMessage rank_message(const std::string& bytes) {
  RankMessage message{static_cast<RankWord>(bytes.front()), {}, bytes.substr(head)};
  std::memcpy(&message.places, bytes.data() + 1, sizeof message.places);
  return message;
}

}  // namespace reeve::studies
