#include "studies/ranks.hpp"

#include <chrono>
#include <new>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "search/exploration_part.hpp"
#include "search/pieces.hpp"
#include "studies/rank_message.hpp"
#include "studies/shared_search.hpp"

namespace reeve::studies {
namespace {

constexpr int the_leader = 0;

void wait_a_moment() { std::this_thread::sleep_for(std::chrono::milliseconds(1)); }

}  // namespace

Leader::Leader(Processes& processes, const std::atomic<bool>& deserted)
    : processes_(processes), deserted_(deserted) {}

Leader::~Leader() {
  send_home();
  int here = processes_.size() - 1;
  while (here > 0 && !deserted_.load()) {
    const std::optional<ProcessMessage> message = processes_.poll();
    if (!message) {
      wait_a_moment();
    } else if (rank_message(message->bytes).word == RankWord::gone) {
      --here;
    }
  }
  if (here == 0) processes_.finish();
}

void Leader::send_home() {
  if (std::exchange(is_over_, true)) return;
  for (int rank = 1; rank < processes_.size(); ++rank) {
    processes_.send(rank, to_bytes({RankWord::over}));
  }
}

Searcher Leader::search(const std::string& exploration, const RecordText& text) {
  return [this, exploration, text](const ExploreOptions& options, const Supervision& supervision,
                                   const Checkpoint& checkpoint) {
    ExplorationPart part =
        SharedSearch(processes_, exploration, text, options, supervision, checkpoint).run();
    // What is left to do the leader does alone.
    send_home();
    return part;
  };
}

void Follower::follow(const ExploreOptions& options, const std::string& exploration,
                      const RecordText& text) {
  processes_.send(the_leader, to_bytes({RankWord::ready, {}, exploration}));
  const PieceSearch explore = piece_search(options);
  const Supervision supervision{[this](const Progress&) { take_messages(); }, &is_over_};
  while (true) {
    take_messages();
    if (is_over_) return;
    if (pieces_.empty()) {
      wait_a_moment();
      continue;
    }
    const ShardRange piece = pieces_.front();
    pieces_.erase(pieces_.begin());
    ExplorationPart part = explore(piece, supervision);
    if (is_over_) return;
    processes_.send(the_leader,
                    to_bytes({RankWord::brought, piece, text.written(record_of(part))}));
  }
}

void Follower::report_failure(const std::exception& failure) {
  const bool is_input = dynamic_cast<const InputError*>(&failure) != nullptr;
  const bool is_range = dynamic_cast<const OutOfRange*>(&failure) != nullptr;
  const RankWord word = is_input   ? RankWord::bad_input
                        : is_range ? RankWord::no_answer
                                   : RankWord::failed;
  const bool is_memory = dynamic_cast<const std::bad_alloc*>(&failure) != nullptr;
  processes_.send(the_leader,
                  to_bytes({word, {}, is_memory ? "not enough memory" : failure.what()}));
}

void Follower::go_home() {
  while (!is_over_) {
    wait_a_moment();
    take_messages();
  }
  processes_.send(the_leader, to_bytes({RankWord::gone}));
  processes_.finish();
}

void Follower::take_messages() {
  while (const std::optional<ProcessMessage> message = processes_.poll()) {
    const RankMessage told = rank_message(message->bytes);
    if (told.word == RankWord::piece) pieces_.push_back(told.places);
    if (told.word == RankWord::over) is_over_ = true;
  }
}

}  // namespace reeve::studies
