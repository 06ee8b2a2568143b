#include "reports/exploration/stored_shards.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace reeve::reports {
namespace {

Json parsed(const std::string& text, const std::string& name, const std::string& key) {
  Json json = Json::parse(text, nullptr, false);
  if (!json.is_discarded()) return json;
  throw InputError({.where = name,
                    .what = fmt::format("its '{}' cannot be understood", key),
                    .expected = "what explore stores",
                    .form = InputForm::unknown});
}

}  // namespace

std::vector<std::string> stored_arguments(const Description& description, const std::string& name) {
  std::vector<std::string> arguments;
  for (const Json& argument : parsed(description.arguments, name, "arguments")) {
    arguments.push_back(argument.is_string() ? argument.get<std::string>() : argument.dump());
  }
  return arguments;
}

std::vector<ShardFile> shard_files(const StoreReader& store, const std::string& name) {
  const Description& description = store.description();
  ShardFile of_all;
  of_all.name = name;
  of_all.whole = description.exploration;
  of_all.version = description.version;
  of_all.arguments = stored_arguments(description, name);
  for (const StoredSetting& setting : description.settings) {
    of_all.settings[setting.key] = parsed(setting.value, name, setting.key);
  }
  std::vector<ShardFile> files;
  for (StoredShard& stored : store.shards()) {
    ShardFile file = of_all;
    file.shard = stored.shard;
    file.record = std::move(stored.record);
    file.record.origin = name;
    file.partial = file.record.generated != file.record.total;
    files.push_back(std::move(file));
  }
  return files;
}

}  // namespace reeve::reports
