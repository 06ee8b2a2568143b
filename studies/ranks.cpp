#include "studies/ranks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <map>
#include <new>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "search/batches.hpp"
#include "search/enumerate/generator.hpp"
#include "search/exploration_part.hpp"

namespace reeve::studies {
namespace {

// Messages between the processes of one search.
enum class RankWord : char {
  // Messages of a follower.
  ready = 'h',      // text: the id of the exploration that it has read
  brought = 'r',    // places.begin: first place of the piece; text: its record
  bad_input = 'i',  // text: the message of an InputError
  no_answer = 'o',  // text: the message of an OutOfRange
  failed = 'f',     // text: the message of another failure
  gone = 'b',
  // Messages of the leader.
  piece = 'p',  // places
  over = 'e',
};

struct RankMessage {
  RankWord word = RankWord::over;
  ShardRange places{};
  std::string text{};
};

// In the machine's own order: all run the same program on the same kind of machine.
constexpr std::size_t head = 1 + sizeof(ShardRange);

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

// Duration of a piece. It is short enough for a kill to cost little. It is long enough for the
// overhead of each piece (some hundredths of a second) not to matter in a long search.
constexpr double least_seconds = 0.5;
constexpr double most_seconds = 5;
constexpr double part_of_elapsed = 0.05;
constexpr std::uint64_t least_piece = 2048;
constexpr auto patience = std::chrono::microseconds(200);

ExplorationPart part_before(const Checkpoint& checkpoint, const ExploreOptions& options) {
  return checkpoint.before ? part_of(*checkpoint.before, options) : ExplorationPart(options);
}

// The leader's part of a search that several processes share (ranks.hpp).
class SharedSearch {
 public:
  SharedSearch(Processes& processes, std::string exploration, const RecordText& text,
               const ExploreOptions& options, const Supervision& supervision,
               const Checkpoint& checkpoint)
      : processes_(processes),
        exploration_(std::move(exploration)),
        text_(text),
        supervision_(supervision),
        checkpoint_(checkpoint),
        explore_here_(piece_search(options)),
        absorb_(record_absorbing(options, static_cast<bool>(checkpoint.save))),
        whole_(part_before(checkpoint, options)),
        left_(shard_range(RoutingGenerator(options.generator).total(), options.shard.index,
                          options.shard.count)),
        begin_(left_.begin),
        before_(whole_.generated),
        seconds_before_(whole_.seconds),
        pace_(static_cast<std::size_t>(processes.size()), 0) {
    whole_.total = left_.end - left_.begin;
    left_.begin += before_;
    together_ = left_.begin;
  }

  // Throws what a follower reported.
  ExplorationPart run() {
    while (left_.begin < left_.end && !is_stopped()) {
      explore_piece();
      put_together();
      save_if_due();
    }
    // A process that has read another exploration must report it, however fast the others are.
    while ((together_ < left_.end || ready_ < processes_.size()) && !is_stopped()) {
      take_messages();
      put_together();
      save_if_due();
      report(0);
      std::this_thread::sleep_for(patience);
    }
    put_together();
    // A shard without routings is saved, too, but once.
    if (checkpoint_.save && (whole_.generated > before_ || !checkpoint_.before)) save();
    return std::move(whole_);
  }

 private:
  bool is_stopped() const { return supervision_.stop != nullptr && supervision_.stop->load(); }

  // The last ones are short, and so are the first, when nobody knows how fast it goes.
  ShardRange cut_piece(int rank) {
    const std::uint64_t left = left_.end - left_.begin;
    const double seconds = std::clamp(part_of_elapsed * elapsed(), least_seconds, most_seconds);
    const auto in_time =
        static_cast<std::uint64_t>(pace_[static_cast<std::size_t>(rank)] * seconds);
    const std::uint64_t share = left / (2 * pace_.size());
    const std::uint64_t length = std::min(left, std::max(least_piece, std::min(in_time, share)));
    const ShardRange piece{left_.begin, left_.begin + length};
    left_.begin = piece.end;
    return piece;
  }

  void hand_to(int rank) {
    if (left_.begin == left_.end) return;
    processes_.send(rank, to_bytes({RankWord::piece, cut_piece(rank)}));
  }

  void explore_piece() {
    const ShardRange piece = cut_piece(0);
    ExplorationPart part = explore_here_(piece, {[this](const Progress& progress) {
                                                   take_messages();
                                                   report(progress.done);
                                                 },
                                                 supervision_.stop});
    keep(piece.begin, 0, record_of(part));
  }

  void take_messages() {
    while (const std::optional<ProcessMessage> message = processes_.poll()) {
      take(message->from, rank_message(message->bytes));
    }
  }

  void take(int from, const RankMessage& message) {
    const std::string who = fmt::format("rank {} of {}", from, processes_.size());
    switch (message.word) {
      case RankWord::ready:
        if (message.text != exploration_) {
          throw InputError({.where = who,
                            .what = "it has read another exploration: its files, its catalogue or "
                                    "its version of reeve are others"});
        }
        ++ready_;
        hand_to(from);
        hand_to(from);
        return;
      case RankWord::brought:
        keep(message.places.begin, from, text_.read(message.text));
        hand_to(from);
        return;
      case RankWord::bad_input:
        throw InputError({.where = who, .what = message.text});
      case RankWord::no_answer:
        throw OutOfRange(message.text);
      case RankWord::failed:
        throw FollowerFailed(who + ": " + message.text);
      case RankWord::gone:
      case RankWord::piece:
      case RankWord::over:
        return;
    }
  }

  void keep(std::uint64_t begin, int rank, ShardRecord record) {
    if (record.seconds > 0) {
      pace_[static_cast<std::size_t>(rank)] =
          static_cast<double>(record.generated) / record.seconds;
    }
    brought_.emplace(begin, std::move(record));
  }

  // As far as there is no gap: of a piece that was stopped what is there is put to the rest, and
  // nothing behind it.
  void put_together() {
    const std::uint64_t total = whole_.total;
    for (auto next = brought_.find(together_); next != brought_.end();
         next = brought_.find(together_)) {
      together_ += next->second.generated;
      absorb_(whole_, next->second);
      brought_.erase(next);
    }
    whole_.total = total;
  }

  void save_if_due() {
    if (checkpoint_.save && !is_stopped() && checkpoint_.is_due()) save();
  }

  void save() {
    whole_.seconds = seconds_before_ + elapsed();
    checkpoint_.save(whole_);
  }

  double elapsed() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

  void report(std::uint64_t done_here) {
    if (!supervision_.report) return;
    std::uint64_t done = together_ - begin_ + done_here;
    for (const auto& [begin, record] : brought_) done += record.generated;
    supervision_.report({done, whole_.total, before_});
  }

  Processes& processes_;
  std::string exploration_;
  RecordText text_;
  const Supervision& supervision_;
  const Checkpoint& checkpoint_;
  PieceSearch explore_here_;
  RecordAbsorbing absorb_;
  ExplorationPart whole_;     // part of the places before `together_`
  ShardRange left_;           // places that no process has in hand
  std::uint64_t begin_ = 0;   // first place of the shard
  std::uint64_t before_ = 0;  // routings, by an earlier run
  double seconds_before_ = 0;
  std::uint64_t together_ = 0;
  std::map<std::uint64_t, ShardRecord> brought_;  // by their first place, from `together_` on
  std::vector<double> pace_;                      // routings a second, of each rank
  int ready_ = 1;                                 // processes that have read the same
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

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
    // The leader does the rest alone.
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
