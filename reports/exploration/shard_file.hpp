// shard.json: what `explore --shard` leaves beside its other files, so that `merge` can put shards
// together to the bytes of the whole.
#pragma once

#include <string>
#include <vector>

#include "reports/output/json.hpp"
#include "search/explore.hpp"
#include "studies/exploration_study.hpp"

namespace reeve::reports {

struct ShardFile {
  std::string name;   // for messages
  std::string whole;  // id of the exploration that it is a part of
  Shard shard;
  bool partial = false;
  std::vector<std::string> arguments;  // arguments of `explore`, without destination and shard
  Json settings;
  std::string version;
  ShardRecord record;
};

// Returns the file of a report that holds its record.
std::string shard_json(const ExploreReport& report, const std::vector<std::string>& arguments);

// The record alone, and back; the numbers are the same to the last bit.
std::string record_json(const ShardRecord& record);
ShardRecord read_record_json(const std::string& text);

// Throws InputError that begins with the name.
ShardFile read_shard_json(const std::string& text, const std::string& name);
// Reads the shard without checking its digest.
ShardFile shard_file_of(const std::string& text, const std::string& name);

// Throws InputError unless these are the shards of one exploration, each once and to its end.
void require_all_shards(const std::vector<ShardFile>& shards);

// … and of the exploration that was planned now from the arguments: names what differs.
void require_same_exploration(const ShardFile& shard, const ExploreReport& planned);

}  // namespace reeve::reports
