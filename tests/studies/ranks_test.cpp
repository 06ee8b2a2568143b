// A search that several share, without MPI: threads that pass each other notes.
#include "studies/ranks.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <deque>
#include <memory>
#include <mutex>
#include <new>
#include <thread>
#include <vector>

#include "numerics/processes.hpp"
#include "reports/exploration/shard_file.hpp"
#include "search/exploration_part.hpp"

namespace reeve::testing {
namespace {

constexpr RecordText json_text{record_json, read_record_json};

struct Mailboxes {
  explicit Mailboxes(int size) : boxes(static_cast<std::size_t>(size)) {}

  std::mutex guard;
  std::vector<std::deque<ProcessMessage>> boxes;
  int finished = 0;
};

class MailedProcess : public Processes {
 public:
  MailedProcess(Mailboxes& mail, int rank) : mail_(mail), rank_(rank) {}

  int rank() const override { return rank_; }
  int size() const override { return static_cast<int>(mail_.boxes.size()); }
  int sharing_cores() const override { return size(); }
  void send(int to, std::string bytes) override {
    const std::lock_guard lock(mail_.guard);
    mail_.boxes[static_cast<std::size_t>(to)].push_back({rank_, std::move(bytes)});
  }
  std::optional<ProcessMessage> poll() override {
    const std::lock_guard lock(mail_.guard);
    auto& box = mail_.boxes[static_cast<std::size_t>(rank_)];
    if (box.empty()) return std::nullopt;
    ProcessMessage message = std::move(box.front());
    box.pop_front();
    return message;
  }
  void finish() override {
    const std::lock_guard lock(mail_.guard);
    ++mail_.finished;
  }

 private:
  Mailboxes& mail_;
  int rank_;
};

ExploreOptions rank_options() {
  ExploreOptions options;
  options.generator.fingers = 4;
  options.generator.parts = full_parts();
  options.grasps = single_grasps(4);
  options.top = 20;
  options.sample = 30;
  options.threads = 1;
  return options;
}

void follow_in_thread(Mailboxes& mail, int rank) {
  MailedProcess process(mail, rank);
  Follower follower(process);
  follower.follow(rank_options(), "same", json_text);
  follower.go_home();
}

// The followers do as they are told; the first process does `lead`.
template <typename Lead, typename Follow>
auto with_ranks(int size, Lead lead, Follow follow) {
  Mailboxes mail(size);
  std::vector<std::jthread> others;
  for (int rank = 1; rank < size; ++rank) {
    others.emplace_back([&mail, rank, follow] { follow(mail, rank); });
  }
  MailedProcess process(mail, 0);
  const std::atomic<bool> deserted = false;
  Leader leader(process, deserted);
  return lead(leader);
}

std::vector<std::string> words_of(const ExploreResult& result) {
  std::vector<std::string> words;
  for (const RankedDesign& ranked : result.top) words.push_back(ranked.design.word);
  for (const Design& design : result.sample) words.push_back(design.word);
  return words;
}

TEST(Ranks, AnyNumberOfThemFindsTheSame) {
  const ExploreResult alone = explore(rank_options());
  for (const int size : {1, 2, 5}) {
    SCOPED_TRACE(size);
    const ExploreResult together = with_ranks(
        size,
        [](Leader& leader) {
          return explore(rank_options(), {}, {}, leader.search("same", json_text));
        },
        follow_in_thread);
    EXPECT_EQ(together.generated, alone.generated);
    EXPECT_EQ(together.evaluated, alone.evaluated);
    EXPECT_FALSE(together.partial);
    EXPECT_EQ(words_of(together), words_of(alone));
  }
}

TEST(Ranks, SaveWhatOneProcessContinuesToTheSame) {
  std::vector<ShardRecord> saved;
  Checkpoint checkpoint;
  checkpoint.is_due = [] { return true; };
  checkpoint.save = [&](ExplorationPart& part) { saved.push_back(record_of(part)); };
  with_ranks(
      3,
      [&](Leader& leader) {
        return explore(rank_options(), {}, checkpoint, leader.search("same", json_text));
      },
      follow_in_thread);
  const ExploreResult whole = explore(rank_options());
  ASSERT_GE(saved.size(), 2U);
  EXPECT_EQ(saved.back().generated, whole.generated);
  for (const ShardRecord& record : saved) {
    SCOPED_TRACE(record.generated);
    EXPECT_EQ(record.total, whole.total);
    Checkpoint later;
    later.before = record;
    EXPECT_EQ(words_of(explore(rank_options(), {}, later)), words_of(whole));
    const ExploreResult together = with_ranks(
        2,
        [&](Leader& leader) {
          return explore(rank_options(), {}, later, leader.search("same", json_text));
        },
        follow_in_thread);
    EXPECT_EQ(words_of(together), words_of(whole));
    EXPECT_EQ(together.generated, whole.generated);
  }
}

TEST(Ranks, KeepTheFirstPartWhenStopped) {
  std::atomic<bool> stop = false;
  const ExploreResult stopped = with_ranks(
      3,
      [&](Leader& leader) {
        return explore(rank_options(),
                       {[&](const Progress& progress) { stop = progress.done > 0; }, &stop}, {},
                       leader.search("same", json_text));
      },
      follow_in_thread);
  EXPECT_TRUE(stopped.partial);
  EXPECT_GT(stopped.generated, 0U);
  EXPECT_LT(stopped.generated, stopped.total);
  EXPECT_EQ(stopped.rejected.front().count + stopped.evaluated, stopped.generated);
}

template <typename Thrown, typename Failure>
std::string told_by_the_second(const Failure& failure) {
  try {
    with_ranks(
        2,
        [](Leader& leader) {
          return explore(rank_options(), {}, {}, leader.search("same", json_text));
        },
        [&](Mailboxes& mail, int rank) {
          MailedProcess process(mail, rank);
          Follower follower(process);
          follower.report_failure(failure);
          follower.go_home();
        });
  } catch (const Thrown& error) {
    return error.what();
  }
  return "(nothing)";
}

TEST(Ranks, ReportTheFailureOfAnother) {
  EXPECT_EQ(told_by_the_second<InputError>(InputError("h.toml: cannot be read")),
            "rank 1 of 2: h.toml: cannot be read");
  EXPECT_EQ(told_by_the_second<OutOfRange>(OutOfRange("no tensions")), "no tensions");
  EXPECT_EQ(told_by_the_second<FollowerFailed>(FollowerFailed("a fault")), "rank 1 of 2: a fault");
  EXPECT_EQ(told_by_the_second<FollowerFailed>(std::bad_alloc()), "rank 1 of 2: not enough memory");
}

TEST(Ranks, MustHaveReadTheSameFiles) {
  EXPECT_THROW(with_ranks(
                   2,
                   [](Leader& leader) {
                     return explore(rank_options(), {}, {}, leader.search("another", json_text));
                   },
                   follow_in_thread),
               InputError);
}

}  // namespace
}  // namespace reeve::testing
