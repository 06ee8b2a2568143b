#include "studies/shared_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "core/error.hpp"

namespace reeve::studies {
namespace {

// Of a piece: short enough for a kill to cost little, and long enough for what each piece costs
// besides (some hundredths of a second) not to matter where there is much to do.
constexpr double least_seconds = 0.5;
constexpr double most_seconds = 5;
constexpr double part_of_elapsed = 0.05;
constexpr std::uint64_t least_piece = 2048;
constexpr auto patience = std::chrono::microseconds(200);

ExplorationPart part_before(const Checkpoint& checkpoint, const ExploreOptions& options) {
  return checkpoint.before ? part_of(*checkpoint.before, options) : ExplorationPart(options);
}

}  // namespace

SharedSearch::SharedSearch(Processes& processes, std::string exploration, const RecordText& text,
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

ExplorationPart SharedSearch::run() {
  while (left_.begin < left_.end && !is_stopped()) {
    explore_piece();
    put_together();
    save_if_due();
  }
  // Who has read something else should be heard of, however fast the others are.
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

// The last ones are short, and so are the first, when nobody knows how fast it goes.
ShardRange SharedSearch::cut_piece(int rank) {
  const std::uint64_t left = left_.end - left_.begin;
  const double seconds = std::clamp(part_of_elapsed * elapsed(), least_seconds, most_seconds);
  const auto in_time = static_cast<std::uint64_t>(pace_[static_cast<std::size_t>(rank)] * seconds);
  const std::uint64_t share = left / (2 * pace_.size());
  const std::uint64_t length = std::min(left, std::max(least_piece, std::min(in_time, share)));
  const ShardRange piece{left_.begin, left_.begin + length};
  left_.begin = piece.end;
  return piece;
}

void SharedSearch::hand_to(int rank) {
  if (left_.begin == left_.end) return;
  processes_.send(rank, to_bytes({RankWord::piece, cut_piece(rank)}));
}

void SharedSearch::explore_piece() {
  const ShardRange piece = cut_piece(0);
  ExplorationPart part = explore_here_(piece, {[this](const Progress& progress) {
                                                 take_messages();
                                                 report(progress.done);
                                               },
                                               supervision_.stop});
  keep(piece.begin, 0, record_of(part));
}

void SharedSearch::take_messages() {
  while (const std::optional<ProcessMessage> message = processes_.poll()) {
    take(message->from, rank_message(message->bytes));
  }
}

void SharedSearch::take(int from, const RankMessage& message) {
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

void SharedSearch::keep(std::uint64_t begin, int rank, ShardRecord record) {
  if (record.seconds > 0) {
    pace_[static_cast<std::size_t>(rank)] = static_cast<double>(record.generated) / record.seconds;
  }
  brought_.emplace(begin, std::move(record));
}

// As far as there is no gap: of a piece that was stopped what is there is put to the rest, and
// nothing behind it.
void SharedSearch::put_together() {
  const std::uint64_t total = whole_.total;
  for (auto next = brought_.find(together_); next != brought_.end();
       next = brought_.find(together_)) {
    together_ += next->second.generated;
    absorb_(whole_, next->second);
    brought_.erase(next);
  }
  whole_.total = total;
}

void SharedSearch::save_if_due() {
  if (checkpoint_.save && !is_stopped() && checkpoint_.is_due()) save();
}

void SharedSearch::save() {
  whole_.seconds = seconds_before_ + elapsed();
  checkpoint_.save(whole_);
}

double SharedSearch::elapsed() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void SharedSearch::report(std::uint64_t done_here) {
  if (!supervision_.report) return;
  std::uint64_t done = together_ - begin_ + done_here;
  for (const auto& [begin, record] : brought_) done += record.generated;
  supervision_.report({done, whole_.total, before_});
}

}  // namespace reeve::studies
