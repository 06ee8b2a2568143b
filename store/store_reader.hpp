// A store, read: by those that rank or merge what it keeps. It may be written meanwhile, and is
// then as it was at the last save before it was opened.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "search/explore.hpp"
#include "store/description.hpp"
#include "store/exploration_store.hpp"

namespace reeve::store {

struct StoredShard {
  Shard shard;
  ShardRecord record;
};

class StoreReader {
 public:
  // Throws InputError if it is no store.
  explicit StoreReader(std::filesystem::path file);
  ~StoreReader();
  StoreReader(const StoreReader&) = delete;
  StoreReader& operator=(const StoreReader&) = delete;

  const std::filesystem::path& file() const { return file_; }
  const Description& description() const { return description_; }
  Keep keep() const { return keep_; }
  // Returns the shards that have begun, at least one. These functions throw InputError that names
  // the file if it is damaged, or explore has not saved in it yet.
  std::vector<StoredShard> shards() const;
  // Every design that was kept with its objectives, in the order of the places.
  void for_each_design(const std::function<void(const EvaluatedDesign&)>& visit) const;
  // Every design of the archives, and every one of the trade-offs, of which some are in both.
  void for_each_archived(const std::function<void(const ArchivedDesign&)>& visit) const;
  void for_each_step(const std::function<void(const Design&)>& visit) const;

 private:
  struct Connection;

  std::filesystem::path file_;
  std::unique_ptr<Connection> connection_;
  Description description_;
  Keep keep_ = Keep::best;
};

}  // namespace reeve::store
