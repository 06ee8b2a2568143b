#include "reports/exploration/shard_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "reports/exploration/explore_report.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::reports {
namespace {

std::string text_of(const Shard& shard) { return fmt::format("{}/{}", shard.index, shard.count); }

// Bounds may be infinite, which JSON has no number for.
Json bound_json(const std::optional<double>& bound) {
  if (!bound) return nullptr;
  if (std::isfinite(*bound)) return *bound;
  return *bound > 0 ? "inf" : "-inf";
}

std::optional<double> bound_of(const Json& json) {
  if (json.is_null()) return std::nullopt;
  if (!json.is_string()) return json.get<double>();
  const double infinity = std::numeric_limits<double>::infinity();
  return json.get<std::string>() == "inf" ? infinity : -infinity;
}

Json nearest_pair_json(const Nearest& nearest) {
  return {{"below", bound_json(nearest.below)}, {"above", bound_json(nearest.above)}};
}

Nearest nearest_pair_of(const Json& json) {
  return {bound_of(json.at("above")), bound_of(json.at("below"))};
}

Json reach_json(const ConstraintReach& reach) {
  return {{"met_by_any", reach.met},
          {"nearest", nearest_pair_json(reach.of_all)},
          {"nearest_with_the_others_met", nearest_pair_json(reach.of_those_that_meet_the_others)}};
}

Json reference_json(const ReferenceCount& reference) {
  return {{"dominated_by", reference.dominated_by},
          {"generated", reference.generated},
          {"rejected_by", reference.rejected_by ? Json(*reference.rejected_by) : Json(nullptr)}};
}

void add_record(Json& json, const ShardRecord& record) {
  json["total"] = record.total;
  json["generated"] = record.generated;
  json["evaluated"] = record.evaluated;
  json["without_tensions"] = {{"count", record.without_tensions.count},
                              {"example", record.without_tensions.example}};
  json["unconverged"] = record.unconverged;
  json["seconds"] = record.seconds;
  json["constraint_failures"] = record.constraint_failures;
  json["reaches"] = list_json(record.reaches, reach_json);
  json["known"] = list_json(record.references, reference_json);
  json["kept"] = Json::array();
  json["equals_left_out"] = Json::object();
  for (const ArchivedWord& archived : record.archive) {
    json["kept"].push_back(archived.word);
    if (archived.equals_left_out > 0) {
      json["equals_left_out"][archived.word] = archived.equals_left_out;
    }
  }
  json["tradeoff"] = record.steps;
  json["sample"] = Json::object();
  json["sample"]["places"] = Json::array();
  json["sample"]["routings"] = Json::array();
  for (const SampledWord& sampled : record.sample) {
    json["sample"]["places"].push_back(sampled.place);
    json["sample"]["routings"].push_back(sampled.word);
  }
}

void read_counts(const Json& json, ShardRecord& record) {
  json.at("total").get_to(record.total);
  json.at("generated").get_to(record.generated);
  json.at("evaluated").get_to(record.evaluated);
  json.at("without_tensions").at("count").get_to(record.without_tensions.count);
  json.at("without_tensions").at("example").get_to(record.without_tensions.example);
  json.at("unconverged").get_to(record.unconverged);
  json.at("seconds").get_to(record.seconds);
  json.at("constraint_failures").get_to(record.constraint_failures);
  for (const Json& reach : json.at("reaches")) {
    record.reaches.push_back({reach.at("met_by_any").get<bool>(),
                              nearest_pair_of(reach.at("nearest")),
                              nearest_pair_of(reach.at("nearest_with_the_others_met"))});
  }
  for (const Json& reference : json.at("known")) {
    const Json& rejected_by = reference.at("rejected_by");
    record.references.push_back(
        {reference.at("dominated_by").get<std::uint64_t>(), reference.at("generated").get<bool>(),
         rejected_by.is_null() ? std::nullopt : std::optional(rejected_by.get<std::size_t>())});
  }
}

void read_designs(const Json& json, ShardRecord& record) {
  const Json& left_out = json.at("equals_left_out");
  for (const Json& word : json.at("kept")) {
    const auto routing = word.get<std::string>();
    record.archive.push_back({routing, left_out.value(routing, std::uint64_t{0})});
  }
  json.at("tradeoff").get_to(record.steps);
  const Json& places = json.at("sample").at("places");
  const Json& routings = json.at("sample").at("routings");
  for (std::size_t i = 0; i < routings.size(); ++i) {
    record.sample.push_back({places.at(i).get<std::uint64_t>(), routings.at(i).get<std::string>()});
  }
}

// But for the seconds, which differ from run to run.
std::string digest_of(Json shard) {
  shard.erase("seconds");
  shard.erase("digest");
  return hash_of(shard);
}

// No digest holds them.
void require_seconds(double seconds) {
  if (seconds >= 0) return;
  throw InputError({.what = "seconds",
                    .value = fmt::format("{}", seconds),
                    .expected = "a number that is not negative"});
}

void require_intact(const Json& json, const std::string& name) {
  const std::string digest = digest_of(json);
  if (!json.contains("digest")) {
    throw InputError({.where = name,
                      .what = "it has no digest, so that it cannot be told whether it is whole",
                      .expected = "what this version of explore writes for a shard",
                      .form = InputForm::unknown});
  }
  if (json["digest"] == digest) return;
  throw InputError({.where = name,
                    .what = fmt::format("it was changed or damaged: its digest is {}, and that of "
                                        "its content {}",
                                        json["digest"].dump(), digest),
                    .expected = "what explore wrote for a shard",
                    .form = InputForm::unknown});
}

// Returns the keys in which the settings differ, without those that differ between shards.
std::string differing_keys(Json a, Json b) {
  for (Json* settings : {&a, &b}) {
    settings->erase("shard");
    if ((*settings)["model"].is_object()) (*settings)["model"].erase("unconverged");
  }
  std::string keys;
  for (const auto& [key, value] : a.items()) {
    if (!b.contains(key) || b[key] != value) keys += (keys.empty() ? "" : ", ") + key;
  }
  return keys;
}

std::string difference(const ShardFile& shard, const Json& settings, const std::string& program) {
  const std::string keys = differing_keys(settings, shard.settings);
  if (!keys.empty()) return "other settings: " + keys;
  if (shard.version != program) {
    return fmt::format("another version of reeve, {} and not {}", shard.version, program);
  }
  return "another catalogue";
}

}  // namespace

std::string shard_json(const ExploreReport& report, const std::vector<std::string>& arguments) {
  Json json{{"exploration", exploration_id(report)},
            {"whole", whole_exploration_id(report)},
            {"shard", text_of(report.options.shard)},
            {"partial", report.result.partial},
            {"arguments", arguments}};
  add_record(json, *report.result.record);
  json["settings"] = explore_settings(report);
  json["version"] = version_json();
  json["digest"] = digest_of(json);
  return print(json);
}

std::string record_json(const ShardRecord& record) {
  Json json;
  add_record(json, record);
  return json.dump();
}

ShardRecord read_record_json(const std::string& text) {
  const Json json = Json::parse(text);
  ShardRecord record;
  read_counts(json, record);
  read_designs(json, record);
  return record;
}

ShardFile read_shard_json(const std::string& text, const std::string& name) {
  ShardFile file = shard_file_of(text, name);
  require_intact(Json::parse(text), name);
  return file;
}

ShardFile shard_file_of(const std::string& text, const std::string& name) {
  ShardFile file;
  file.name = name;
  try {
    const Json json = Json::parse(text);
    json.at("whole").get_to(file.whole);
    file.shard = parse_shard(json.at("shard").get<std::string>());
    json.at("partial").get_to(file.partial);
    json.at("arguments").get_to(file.arguments);
    file.settings = json.at("settings");
    json.at("version").get_to(file.version);
    read_counts(json, file.record);
    read_designs(json, file.record);
    require_seconds(file.record.seconds);
    file.record.origin = name;
  } catch (const Json::exception& error) {
    throw InputError({.where = name,
                      .what = fmt::format("it cannot be understood ({})", error.what()),
                      .expected = "what explore writes for a shard",
                      .form = InputForm::unknown});
  } catch (const InputError& error) {
    throw error.at(name);
  }
  return file;
}

void require_all_shards(const std::vector<ShardFile>& shards) {
  const ShardFile& first = shards.front();
  std::map<std::uint64_t, const ShardFile*> by_index;
  for (const ShardFile& file : shards) {
    if (file.whole != first.whole) {
      throw InputError({.where = file.name,
                        .what = fmt::format("it is of another exploration than {}: {}", first.name,
                                            difference(file, first.settings, first.version))});
    }
    if (file.shard.count != first.shard.count) {
      throw InputError({.where = file.name,
                        .what = fmt::format("it is shard {}, and {} is shard {}",
                                            text_of(file.shard), first.name, text_of(first.shard)),
                        .expected = "shards of as many",
                        .form = InputForm::unknown});
    }
    if (file.partial || file.record.generated != file.record.total) {
      throw InputError(
          {.where = file.name,
           .what = fmt::format("shard {} was stopped after {} of {} routings", text_of(file.shard),
                               file.record.generated, file.record.total),
           .expected = "one that was explored to its end",
           .form = InputForm::unknown});
    }
    const auto [there, is_new] = by_index.emplace(file.shard.index, &file);
    if (!is_new) {
      throw InputError({.where = file.name,
                        .what = fmt::format("shard {} is there twice, also as {}",
                                            text_of(file.shard), there->second->name)});
    }
  }
  std::string missing;
  for (std::uint64_t i = 1; i <= first.shard.count && missing.size() < 60; ++i) {
    if (!by_index.contains(i)) {
      missing += (missing.empty() ? "" : ", ") + text_of({i, first.shard.count});
    }
  }
  if (missing.empty()) return;
  const std::uint64_t count = first.shard.count - by_index.size();
  throw InputError({.what = count == 1 ? fmt::format("shard {} is missing", missing)
                                       : fmt::format("{} shards are missing: {}{}", count, missing,
                                                     missing.size() < 60 ? "" : ", …")});
}

void require_same_exploration(const ShardFile& shard, const ExploreReport& planned) {
  const std::string whole = whole_exploration_id(planned);
  if (whole != shard.whole) {
    throw InputError(
        {.where = shard.name,
         .what = fmt::format("it was made by {}",
                             difference(shard, explore_settings(planned), version_json()))});
  }
  const ShardRecord& record = shard.record;
  if (record.references.size() == planned.options.references.size() &&
      record.constraint_failures.size() == planned.options.constraints.size() &&
      record.reaches.size() == planned.options.constraints.size()) {
    return;
  }
  throw InputError({.where = shard.name,
                    .what = "its counts are not those of its settings",
                    .form = InputForm::unknown});
}

}  // namespace reeve::reports
