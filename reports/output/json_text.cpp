#include "reports/output/json_text.hpp"

#include <utility>

namespace reeve::reports {

// Strings have no line ends of their own in them: JSON escapes these.
void ObjectText::append_indented(const Json& json, std::string_view indent) {
  const std::string printed = json.dump(2, ' ', false, Json::error_handler_t::replace);
  std::string_view rest = printed;
  for (std::size_t end = rest.find('\n'); end != std::string_view::npos; end = rest.find('\n')) {
    text_ += rest.substr(0, end + 1);
    text_ += indent;
    rest.remove_prefix(end + 1);
  }
  text_ += rest;
}

void ObjectText::begin_member(std::string_view key) {
  text_ += text_.empty() ? "{\n  " : ",\n  ";
  text_ += Json(key).dump(-1, ' ', false, Json::error_handler_t::replace);
  text_ += ": ";
}

void ObjectText::add(std::string_view key, const Json& value) {
  begin_member(key);
  append_indented(value, "  ");
}

void ObjectText::add_members(const Json& object) {
  for (const auto& [key, value] : object.items()) add(key, value);
}

// A text that grows by doubling is copied and takes up to twice its size.
void ObjectText::make_room(std::size_t entries, std::size_t begin, std::size_t done) {
  constexpr std::size_t told_from = 64;
  if (done != told_from || entries <= done) return;
  const std::size_t of_one = (text_.size() - begin) / done + 1;
  text_.reserve(text_.size() + of_one * 17 / 16 * (entries - done) + text_.size() - begin);
}

std::string ObjectText::text() && { return text_.empty() ? "{}\n" : std::move(text_) + "\n}\n"; }

}  // namespace reeve::reports
