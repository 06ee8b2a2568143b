#include "reports/exploration/explored_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.hpp"
#include "core/input_file.hpp"
#include "reports/output/stamp.hpp"

namespace reeve::reports {
namespace {

constexpr std::size_t most_bytes = std::size_t{1} << 30;

constexpr const char* whole_folder = "the folder of an exploration that was written to its end";

std::optional<std::string> text_of(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) return std::nullopt;
  return read_input(file, most_bytes, "a file of an exploration");
}

// A table without rows has none.
bool may_lack_stamp(const std::filesystem::path& file, const std::string& text) {
  return file.extension() == ".csv" && std::ranges::count(text, '\n') < 2;
}

}  // namespace

std::string summary_of_one_exploration(const std::filesystem::path& folder) {
  const std::optional<std::string> summary = text_of(folder / "summary.json");
  if (!summary) {
    throw InputError({.where = folder.string(),
                      .what = "there is no summary.json, which is written last",
                      .expected = whole_folder,
                      .form = InputForm::unknown});
  }
  const std::string id = id_in("summary.json", *summary, exploration_kind);
  for (const char* name :
       {"designs.csv", "pareto.csv", "sample.csv", "tradeoff.csv", "shard.json", "index.html"}) {
    const std::optional<std::string> text = text_of(folder / name);
    if (!text || id_in(name, *text, exploration_kind) == id) continue;
    if (may_lack_stamp(name, *text)) continue;
    throw InputError({.where = folder.string(),
                      .what = fmt::format("{} and summary.json are of two explorations", name),
                      .expected = whole_folder,
                      .form = InputForm::unknown});
  }
  return *summary;
}

}  // namespace reeve::reports
