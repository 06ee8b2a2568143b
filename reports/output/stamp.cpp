#include "reports/output/stamp.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <string_view>

namespace reeve::reports {
namespace {

constexpr std::size_t id_size = 16;

bool is_id(std::string_view text) {
  return text.size() == id_size &&
         text.find_first_not_of("0123456789abcdef") == std::string_view::npos;
}

bool is_comment(std::string_view record) { return record.starts_with('#'); }

// Takes a record, or a comment line, off the text. A record goes on where a line ends in quotes.
std::string_view next_record(std::string_view& csv) {
  bool in_quotes = false;
  std::size_t end = 0;
  for (; end < csv.size() && (in_quotes || csv[end] != '\n'); ++end) {
    if (csv[end] == '"' && !is_comment(csv)) in_quotes = !in_quotes;
  }
  const std::string_view record = csv.substr(0, end);
  csv.remove_prefix(std::min(end + 1, csv.size()));
  return record;
}

std::string_view last_field(std::string_view record) {
  return record.substr(record.rfind(',') == std::string_view::npos ? 0 : record.rfind(',') + 1);
}

std::string stamped_csv(const std::string& csv, const Stamp& stamp) {
  const auto lines = static_cast<std::size_t>(std::ranges::count(csv, '\n'));
  std::string stamped;
  stamped.reserve(csv.size() + (lines + 1) * (stamp.id.size() + 1));
  std::string_view rest = csv;
  bool in_header = true;
  while (!rest.empty()) {
    const std::string_view record = next_record(rest);
    stamped += record;
    if (!is_comment(record)) {
      stamped += ',';
      stamped += in_header ? stamp.kind : stamp.id;
      in_header = false;
    }
    stamped += '\n';
  }
  return stamped;
}

std::string_view id_in_csv(std::string_view csv, const std::string& kind) {
  std::string_view header = next_record(csv);
  while (is_comment(header)) header = next_record(csv);
  return last_field(header) == kind ? last_field(next_record(csv)) : "";
}

std::string comment_start(const std::string& kind) { return "<!-- " + kind + " "; }

std::string_view id_in_markup(std::string_view markup, const std::string& kind) {
  const std::string start = comment_start(kind);
  const std::size_t begin = markup.rfind(start);
  if (begin == std::string_view::npos) return "";
  return markup.substr(begin + start.size(), id_size);
}

std::string id_in_json(const std::string& text, const std::string& kind) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_object() || !json.contains(kind)) return "";
  return json[kind].is_string() ? json[kind].get<std::string>() : "";
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

std::string print_stamped(Json json) {
  Json timeless = json;
  timeless.erase("seconds");
  json[result_kind] = hash_of(timeless);
  return print(json);
}

Stamp result_stamp(const std::string& printed) {
  return {result_kind, id_in_json(printed, result_kind)};
}

std::string stamped(const std::filesystem::path& name, std::string text, const Stamp& stamp) {
  const std::filesystem::path extension = name.extension();
  if (extension == ".csv") return stamped_csv(text, stamp);
  if (extension != ".html" && extension != ".svg") return text;
  text += comment_start(stamp.kind) + stamp.id + " -->\n";
  return text;
}

std::string id_in(const std::filesystem::path& name, const std::string& text,
                  const std::string& kind) {
  const std::filesystem::path extension = name.extension();
  if (extension == ".json") return id_in_json(text, kind);
  const std::string_view id =
      extension == ".csv" ? id_in_csv(text, kind) : id_in_markup(text, kind);
  return is_id(id) ? std::string(id) : "";
}

}  // namespace reeve::reports
