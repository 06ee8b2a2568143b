// The end of an exploration whose search was done in shards.
#pragma once

#include <string>
#include <vector>

#include "cli/outputs.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/exploration/shard_file.hpp"
#include "studies/study_supervision.hpp"

namespace reeve::cli {

// Returns the result of `explore` with the arguments of the shards, but without --shard.
ExploreReport merged_exploration(const std::vector<ShardFile>& shards,
                                 const std::vector<std::string>& here,
                                 const StudySupervision& supervision);

// Its files, into the folder of --out, which is among `here`. The arguments are the shards', and
// `places` what these were read from.
void write_merged(const ExploreReport& report, const std::vector<std::string>& arguments,
                  const std::vector<std::string>& here, const std::vector<InputFile>& places);

// Prints and writes the output of `explore` with the arguments of the shards, but without --shard.
// `here` are arguments besides: where to, how many threads, in which format.
int explore_merged(const std::vector<ShardFile>& shards, const std::vector<std::string>& here,
                   const std::vector<InputFile>& places);

}  // namespace reeve::cli
