// The shards that a store holds, as those of folders (shard_file.hpp).
#pragma once

#include <string>
#include <vector>

#include "reports/exploration/shard_file.hpp"
#include "store/store_reader.hpp"

namespace reeve::reports {

// The name is for messages.
std::vector<ShardFile> shard_files(const StoreReader& store, const std::string& name);

// The options that the exploration was asked for with. Throws InputError that begins with the name.
std::vector<std::string> stored_arguments(const Description& description, const std::string& name);

}  // namespace reeve::reports
