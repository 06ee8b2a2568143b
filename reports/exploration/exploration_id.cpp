#include "reports/exploration/exploration_id.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

#include "core/notation.hpp"
#include "reports/results/explore_report.hpp"

namespace reeve::reports {
namespace {

constexpr const char* stamp_heading = "exploration";
constexpr std::string_view stamp_comment = "<!-- exploration ";
constexpr std::size_t id_size = 16;

bool is_id(std::string_view text) {
  return text.size() == id_size &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

std::string_view first_line(std::string_view& text) {
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

std::string_view last_field(std::string_view line) {
  return line.substr(line.rfind(',') == std::string_view::npos ? 0 : line.rfind(',') + 1);
}

}  // namespace

std::string hash_of(const Json& json) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const char character : json.dump(-1, ' ', false, Json::error_handler_t::replace)) {
    hash ^= static_cast<unsigned char>(character);
    hash *= 0x100000001b3U;
  }
  return fmt::format("{:016x}", hash);
}

std::string whole_exploration_id(const ExploreReport& report) {
  Json asked = explore_settings(report);
  asked["shard"] = "1/1";
  // Counted on the way, not asked.
  if (asked["model"].is_object()) asked["model"].erase("unconverged");
  Json known = Json::array();
  for (std::size_t i = 0; i < report.options.references.size(); ++i) {
    known.push_back({report.reference_names[i], to_word(report.options.references[i])});
  }
  return hash_of({asked, known, version_json()});
}

std::string exploration_id(const ExploreReport& report) {
  std::string whole = whole_exploration_id(report);
  const Shard& shard = report.options.shard;
  const ExploreResult& result = report.result;
  if (shard.count == 1 && !result.partial && !report.draws_stopped) return whole;
  return hash_of(
      {whole, shard.index, shard.count, result.partial, result.generated, report.draws_stopped});
}

std::string stamped_csv(const std::string& csv, const std::string& id) {
  const auto lines = static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n'));
  std::string stamped;
  stamped.reserve(csv.size() + (lines + 1) * (id.size() + 1));
  std::string_view rest = csv;
  bool in_header = true;
  while (!rest.empty()) {
    const std::string_view line = first_line(rest);
    stamped += line;
    if (!line.starts_with('#')) {
      stamped += ',';
      stamped += in_header ? stamp_heading : id;
      in_header = false;
    }
    stamped += '\n';
  }
  return stamped;
}

std::string stamp_of_csv(const std::string& csv) {
  std::string_view rest = csv;
  std::string_view line = first_line(rest);
  while (line.starts_with('#')) line = first_line(rest);
  if (last_field(line) != stamp_heading) return "";
  const std::string_view id = last_field(first_line(rest));
  return is_id(id) ? std::string(id) : "";
}

std::string stamped_markup(const std::string& markup, const std::string& id) {
  return markup + std::string(stamp_comment) + id + " -->\n";
}

std::string stamp_of_markup(const std::string& markup) {
  const std::size_t begin = markup.rfind(stamp_comment);
  if (begin == std::string::npos) return "";
  const std::string id = markup.substr(begin + stamp_comment.size(), id_size);
  return is_id(id) ? id : "";
}

}  // namespace reeve::reports
