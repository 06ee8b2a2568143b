#include "pages/shell/template.hpp"

#include <fmt/format.h>
#include <kainjow/mustache.hpp>

#include <stdexcept>

#include "pages/shell/asset_table.hpp"

namespace reeve::pages {
namespace {

using kainjow::mustache::data;
using kainjow::mustache::mustache;

data to_data(const Json& json) {
  switch (json.type()) {
    case Json::value_t::object: {
      data object(data::type::object);
      for (const auto& [key, value] : json.items()) object.set(key, to_data(value));
      return object;
    }
    case Json::value_t::array: {
      data list(data::type::list);
      for (const Json& value : json) list.push_back(to_data(value));
      return list;
    }
    case Json::value_t::string: {
      const auto& text = json.get_ref<const std::string&>();
      // An empty text counts as missing in {{#key}}, as everybody expects who writes a template.
      return text.empty() ? data(data::type::bool_false) : data(text);
    }
    case Json::value_t::boolean:
      return json.get<bool>();
    case Json::value_t::null:
      return {data::type::bool_false};
    default:
      return json.dump();
  }
}

}  // namespace

std::string render(std::string_view name, const Json& values) {
  mustache filled{std::string(asset(name))};
  if (!filled.is_valid()) {
    throw std::runtime_error(fmt::format("template {}: {}", name, filled.error_message()));
  }
  // Into a text and not through the library's stream, which, without memory, ends in the middle.
  std::string text;
  filled.render(to_data(values), [&text](const std::string& piece) { text += piece; });
  return text;
}

std::string script_json(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char c : text) {
    if (c == '<') {
      safe += "\\u003c";
    } else {
      safe += c;
    }
  }
  return safe;
}

}  // namespace reeve::pages
