// The end of an exploration whose search was done in shards.
#pragma once

#include <string>
#include <vector>

#include "reports/exploration/shard_file.hpp"

namespace reeve::cli {

// What `explore` with the arguments of the shards would print and write without --shard. `here` are
// arguments besides: where to, how many threads, in which format.
int explore_merged(const std::vector<ShardFile>& shards, const std::vector<std::string>& here);

}  // namespace reeve::cli
