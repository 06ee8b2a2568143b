#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "fuzz/fuzzed.hpp"
#include "store/store_reader.hpp"

namespace reeve::fuzz {
namespace {

// SQLite wants a file that it can lock; /dev/shm is none of a disk.
const std::filesystem::path& file() {
  static const std::filesystem::path name =
      "/dev/shm/reeve-fuzz-" + std::to_string(getpid()) + ".db";
  return name;
}

// What SQLite leaves beside it goes, too.
void remove_file() {
  for (const char* suffix : {"", "-wal", "-shm", "-journal"}) {
    std::filesystem::remove(file().string() + suffix);
  }
}

}  // namespace

void store(std::string_view bytes) {
  remove_file();
  std::ofstream(file(), std::ios::binary) << bytes;
  or_refused([&] {
    const reeve::store::StoreReader reader(file());
    for (const reeve::store::StoredShard& shard : reader.shards()) {
      require(shard.record.generated <= shard.record.total, "a shard is no more than whole");
    }
    reader.for_each_design([](const search::EvaluatedDesign&) {});
    reader.for_each_archived([](const search::ArchivedDesign&) {});
    reader.for_each_step([](const search::Design&) {});
  });
  remove_file();
}

}  // namespace reeve::fuzz
