#include "studies/shared/crew_message.hpp"

#include <cstring>

namespace reeve::studies {
namespace {

// In the machine's own order: all run the same program on the same kind of machine.
constexpr std::size_t head = 1 + sizeof(ShardRange);

}  // namespace

std::string to_bytes(const CrewMessage& message) {
  std::string bytes(head, static_cast<char>(message.word));
  std::memcpy(bytes.data() + 1, &message.places, sizeof message.places);
  return bytes + message.text;
}

CrewMessage crew_message(const std::string& bytes) {
  CrewMessage message{static_cast<CrewWord>(bytes.front()), {}, bytes.substr(head)};
  std::memcpy(&message.places, bytes.data() + 1, sizeof message.places);
  return message;
}

}  // namespace reeve::studies
