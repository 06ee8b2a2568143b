// Description of the exploration in its store, written and read back.
#pragma once

#include <string>
#include <vector>

#include "reports/exploration/shard_file.hpp"
#include "store/description.hpp"
#include "store/store_reader.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

// Describes a planned report. The arguments are those of the command, without destination and
// shard.
Description store_description(const ExploreReport& planned,
                              const std::vector<std::string>& arguments);

// The shards that a store holds, as those of folders (shard_file.hpp). The name is for messages.
std::vector<ShardFile> shard_files(const StoreReader& store, const std::string& name);

// The options that the exploration was asked for with. Throws InputError that begins with the name.
std::vector<std::string> stored_arguments(const Description& description, const std::string& name);

}  // namespace reeve::reports
