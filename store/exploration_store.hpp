// A store: one exploration in an SQLite file, as far as it came.
//
// All that changes between two saves is one transaction, so that whatever ends the process (a kill,
// a power cut, a full disk) leaves what the last save left. A write-ahead log lets others read
// meanwhile; a second writer is refused, since the next transaction begins where the last one ends.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>

#include "search/exploration_part.hpp"
#include "search/explore.hpp"
#include "store/description.hpp"

namespace reeve::store {

enum class Keep : std::uint8_t { best, all };

class ExplorationStore {
 public:
  // Made where there is none. Throws InputError if it is of another exploration, of other numbers
  // of shards, keeps otherwise than asked for, or is damaged.
  ExplorationStore(std::filesystem::path file, Description asked, Shard shard,
                   std::optional<Keep> keep);
  ~ExplorationStore();
  ExplorationStore(const ExplorationStore&) = delete;
  ExplorationStore& operator=(const ExplorationStore&) = delete;

  Keep keep() const { return keep_; }
  // Returns the earlier state of this shard; nothing if it has not begun.
  std::optional<ShardRecord> record() const;

  // The design is in the file after the next save. Both throw InputError if the file cannot be
  // written.
  void add(const EvaluatedDesign& design);
  void save(ExplorationPart& so_far);

  std::uint64_t added_since_save() const { return added_since_save_; }

 private:
  struct Connection;

  bool is_there_and_same(std::optional<Keep> keep);
  void require_keep(Keep asked) const;
  void require_record(const std::optional<ShardRecord>& record) const;
  void require_there() const;

  std::filesystem::path file_;
  Description asked_;
  Shard shard_;
  Keep keep_ = Keep::best;
  std::uint64_t added_since_save_ = 0;
  std::uint64_t added_digest_ = 0;  // digest of these designs
  std::unique_ptr<Connection> connection_;
};

}  // namespace reeve::store
