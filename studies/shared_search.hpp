// The leader's part of a search that several processes share (ranks.hpp).
#pragma once

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "search/exploration_part.hpp"
#include "search/pieces.hpp"
#include "studies/rank_message.hpp"
#include "studies/ranks.hpp"

namespace reeve::studies {

class SharedSearch {
 public:
  SharedSearch(Processes& processes, std::string exploration, const RecordText& text,
               const ExploreOptions& options, const Supervision& supervision,
               const Checkpoint& checkpoint);

  // Throws what a follower reported.
  ExplorationPart run();

 private:
  bool is_stopped() const { return supervision_.stop != nullptr && supervision_.stop->load(); }
  ShardRange cut_piece(int rank);
  void hand_to(int rank);
  void explore_piece();
  void take_messages();
  void take(int from, const RankMessage& message);
  void keep(std::uint64_t begin, int rank, ShardRecord record);
  void put_together();
  void save_if_due();
  void save();
  double elapsed() const;
  void report(std::uint64_t done_here);

  Processes& processes_;
  std::string exploration_;
  RecordText text_;
  const Supervision& supervision_;
  const Checkpoint& checkpoint_;
  PieceSearch explore_here_;
  RecordAbsorbing absorb_;
  ExplorationPart whole_;     // of the places before `together_`
  ShardRange left_;           // that nobody has in hand
  std::uint64_t begin_ = 0;   // of the shard
  std::uint64_t before_ = 0;  // routings, by an earlier run
  double seconds_before_ = 0;
  std::uint64_t together_ = 0;
  std::map<std::uint64_t, ShardRecord> brought_;  // by their first place, from `together_` on
  std::vector<double> pace_;                      // routings a second, of each rank
  int ready_ = 1;                                 // processes that have read the same
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace reeve::studies
