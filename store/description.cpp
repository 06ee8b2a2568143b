#include "store/description.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace reeve::store {
namespace {

constexpr std::size_t longest_shown = 60;  // characters of a value; a hardware is longer

std::string shown(const StoredSetting& there, const StoredSetting& asked) {
  if (there.value.size() > longest_shown || asked.value.size() > longest_shown) return there.key;
  return fmt::format("{} ({}, and not {})", there.key, there.value, asked.value);
}

StoredSetting setting(const Description& description, const std::string& key) {
  const auto found = std::ranges::find(description.settings, key, &StoredSetting::key);
  return found == description.settings.end() ? StoredSetting{key, "nothing"} : *found;
}

}  // namespace

std::optional<std::string> difference(const Description& there, const Description& asked) {
  if (there.exploration == asked.exploration) return std::nullopt;
  std::string keys;
  const auto add = [&](const StoredSetting& old, const StoredSetting& now) {
    if (old == now) return;
    keys += (keys.empty() ? "" : ", ") + shown(old, now);
  };
  for (const StoredSetting& old : there.settings) add(old, setting(asked, old.key));
  for (const StoredSetting& now : asked.settings) {
    const StoredSetting old = setting(there, now.key);
    if (old.value == "nothing") add(old, now);
  }
  if (!keys.empty()) return "other settings: " + keys;
  if (there.version != asked.version) {
    return fmt::format("another version of reeve: {}, and not {}", there.version, asked.version);
  }
  return "another catalogue";
}

}  // namespace reeve::store
