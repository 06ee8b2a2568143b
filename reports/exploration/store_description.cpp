#include "reports/exploration/store_description.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/json.hpp"

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

Description store_description(const ExploreReport& planned,
                              const std::vector<std::string>& arguments) {
  Description description{
      whole_exploration_id(planned), version_json(), Json(arguments).dump(), {}};
  Json settings = explore_settings(planned);
  settings.erase("shard");
  if (settings["model"].is_object()) settings["model"].erase("unconverged");
  for (const auto& [key, value] : settings.items()) {
    description.settings.push_back(
        {key, value.dump(-1, ' ', false, Json::error_handler_t::replace)});
  }
  std::ranges::sort(description.settings, {}, &StoredSetting::key);
  description.known = planned.reference_names;
  for (const Constraint& constraint : planned.options.constraints) {
    description.limits.push_back(constraint.text);
  }
  return description;
}

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
