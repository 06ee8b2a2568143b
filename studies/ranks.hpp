// Processes that share one exploration: the first leads, the others follow.
//
// The leader cuts pieces off the places that are left, some seconds of work each, and goes through
// pieces of its own. A follower has two in hand, and gets another one when it has brought what it
// kept of one. The leader puts together what it is brought in the order of the places; so at any
// moment it has what a search by one process would have had at some place (search/batches.hpp), and
// that is what is saved, what is left of a stopped search, and at the end the same bytes as without
// the others, whoever did what.
//
// A follower that fails says so and waits for the end; the leader throws that here. One that dies
// is a matter of the launcher, which ends all.
#pragma once

#include <atomic>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

#include "numerics/processes.hpp"
#include "search/explore.hpp"
#include "search/shard_record.hpp"

namespace reeve::studies {

// As a record travels.
struct RecordText {
  std::string (*written)(const ShardRecord&);
  ShardRecord (*read)(const std::string&);
};

// For want of memory, or by a fault of the program.
class FollowerFailed : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

class Leader {
 public:
  // `deserted`, set from a signal: the others will not answer any more. Both outlive it.
  Leader(Processes& processes, const std::atomic<bool>& deserted);
  // Sends the others home, and waits for them.
  ~Leader();
  Leader(const Leader&) = delete;
  Leader& operator=(const Leader&) = delete;

  // Returns the search of the exploration with this id. It is an error if other processes have read
  // another one. May be called once.
  Searcher search(const std::string& exploration, const RecordText& text);

 private:
  void send_home();

  Processes& processes_;
  const std::atomic<bool>& deserted_;
  bool is_over_ = false;
};

// Until the leader says that it is over.
class Follower {
 public:
  explicit Follower(Processes& processes) : processes_(processes) {}

  void follow(const ExploreOptions& options, const std::string& exploration,
              const RecordText& text);
  // In place of following, or of going on with it.
  void report_failure(const std::exception& failure);
  // All has been said.
  void go_home();

 private:
  void take_messages();

  Processes& processes_;
  std::vector<ShardRange> pieces_;  // in hand
  std::atomic<bool> is_over_ = false;
};

}  // namespace reeve::studies
