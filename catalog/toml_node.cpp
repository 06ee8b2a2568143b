#include "catalog/toml_node.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>

#include "core/input_file.hpp"
#include "core/nearest_name.hpp"

namespace reeve::catalog {
namespace {

// A thousand times any real file; a wrong path (a recording, a device) is refused, not swallowed.
constexpr std::size_t max_file_size = std::size_t{1} << 20;

// A dotted key opens a table at every dot, and toml++ walks them by recursion without a limit: a
// line of a million dots would overflow the stack.
constexpr std::size_t max_line_length = 4096;
constexpr int max_depth = 8;

// A message has one line, whatever stands in the file.
std::string one_line(std::string text) {
  std::replace_if(
      text.begin(), text.end(), [](char c) { return c >= 0 && c < ' '; }, '?');
  return text;
}

[[noreturn]] void fail(const TomlNode& node, TomlPosition at, const InputFault& fault) {
  const InputError placed =
      InputError(fault).at(fmt::format("{}:{}:{}", *node.file, at.line, at.column));
  throw InputError(changed(placed.fault(), one_line));
}

std::string read_file(const std::filesystem::path& path) {
  std::string text = read_input(path, max_file_size, "a TOML file");
  if (text.size() > max_file_size) {
    throw InputError({.where = path.string(),
                      .what = "is larger than 1 MiB",
                      .expected = "a TOML file of some lines"});
  }
  return text;
}

void require_short_lines(const TomlNode& root, std::string_view text) {
  std::uint32_t line = 1;
  for (std::size_t begin = 0; begin < text.size(); ++line) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    if (end - begin > max_line_length) {
      fail(root, {line, 1},
           {.what = fmt::format("the line has {} characters", end - begin),
            .expected = fmt::format("at most {}", max_line_length)});
    }
    begin = end + 1;
  }
}

TomlPosition position(const toml::source_region& region) {
  return {std::max<std::uint32_t>(region.begin.line, 1),
          std::max<std::uint32_t>(region.begin.column, 1)};
}

TomlKind kind_of(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::boolean:
      return TomlKind::boolean;
    case toml::node_type::integer:
      return TomlKind::integer;
    case toml::node_type::floating_point:
      return TomlKind::floating;
    case toml::node_type::string:
      return TomlKind::string;
    case toml::node_type::array:
      return TomlKind::array;
    case toml::node_type::table:
      return TomlKind::table;
    default:
      return TomlKind::date;
  }
}

bool stands_before(const TomlNode& a, const TomlNode& b) {
  return a.key_at.line != b.key_at.line ? a.key_at.line < b.key_at.line
                                        : a.key_at.column < b.key_at.column;
}

TomlNode convert(const toml::node& from, const TomlNode& parent, TomlNode to, int depth);

void convert_array(const toml::array& from, TomlNode& to, int depth) {
  for (const toml::node& item : from) {
    TomlNode child;
    child.name = fmt::format("{}[{}]", to.name, to.children.size() + 1);
    child.key_at = position(item.source());
    to.children.push_back(convert(item, to, std::move(child), depth + 1));
  }
}

void convert_table(const toml::table& from, TomlNode& to, int depth) {
  for (const auto& [key, value] : from) {
    TomlNode child;
    child.key = key.str();
    child.name = to.name.empty() ? child.key : to.name + "." + child.key;
    child.key_at = position(key.source());
    to.children.push_back(convert(value, to, std::move(child), depth + 1));
  }
  std::stable_sort(to.children.begin(), to.children.end(), stands_before);
}

TomlNode convert(const toml::node& from, const TomlNode& parent, TomlNode to, int depth) {
  to.kind = kind_of(from);
  to.file = parent.file;
  to.at = position(from.source());
  if (depth > max_depth) fail(to, to.key_at, {.expected = "no tables or arrays as deep as this"});
  if (to.kind == TomlKind::array) convert_array(*from.as_array(), to, depth);
  if (to.kind == TomlKind::table) convert_table(*from.as_table(), to, depth);
  if (to.kind == TomlKind::string) to.content = from.as_string()->get();
  if (to.kind == TomlKind::boolean) to.number = from.as_boolean()->get() ? 1 : 0;
  if (to.kind == TomlKind::integer) to.number = static_cast<double>(from.as_integer()->get());
  // Less than nothing at all is nothing: with a sign, it would be written as another file.
  if (to.kind == TomlKind::floating) to.number = from.as_floating_point()->get() + 0.0;
  return to;
}

// Never cuts a UTF-8 character in two.
std::string shortened(const std::string& text) {
  constexpr std::size_t longest = 60;
  if (text.size() <= longest) return text;
  std::size_t end = longest;
  while (end > 0 && (text[end] & '\xC0') == '\x80') --end;
  return text.substr(0, end) + "…";
}

std::string shown(const TomlNode& node) {
  switch (node.kind) {
    case TomlKind::boolean:
      return node.number != 0 ? "true" : "false";
    case TomlKind::integer:
    case TomlKind::floating:
      return fmt::format("{}", node.number);
    case TomlKind::string:
      return fmt::format("\"{}\"", shortened(node.content));
    case TomlKind::date:
      return "(a date or time)";
    case TomlKind::array:
      return "(an array)";
    case TomlKind::table:
      return "(a table)";
  }
  return "";
}

}  // namespace

const TomlNode* TomlNode::find(std::string_view wanted) const {
  const auto found = std::ranges::find(children, wanted, &TomlNode::key);
  return found == children.end() ? nullptr : &*found;
}

const TomlNode& TomlNode::require(std::string_view wanted, std::string_view expected) const {
  if (const TomlNode* found = find(wanted)) return *found;
  const std::string where = name.empty() ? "" : fmt::format(" in '{}'", name);
  fail_at_key({.what = fmt::format("missing key '{}'{}", wanted, where),
               .expected = std::string(expected)});
}

void TomlNode::allow_only(const std::vector<std::string_view>& keys) const {
  for (const TomlNode& child : children) {
    if (std::ranges::find(keys, child.key) != keys.end()) continue;
    child.fail_at_key(
        {.what = "unknown key",
         .value = shortened(child.name),
         .expected = fmt::format("one of {}{}", fmt::join(keys, ", "),
                                 did_you_mean(child.key, {keys.begin(), keys.end()}))});
  }
}

const std::vector<TomlNode>& TomlNode::items() const {
  if (kind != TomlKind::array) fail_expected("an array");
  return children;
}

const std::vector<TomlNode>& TomlNode::tables() const {
  if (kind != TomlKind::array) fail_expected(fmt::format("tables headed [[{}]]", name));
  for (const TomlNode& child : children) child.table();
  return children;
}

const TomlNode& TomlNode::table() const {
  if (kind != TomlKind::table) fail_expected("a table");
  return *this;
}

const std::string& TomlNode::text() const {
  if (kind != TomlKind::string || content.empty()) fail_expected("a text in quotes, not empty");
  return content;
}

int TomlNode::integer(int low, int high) const {
  if (kind != TomlKind::integer || number < low || number > high) {
    fail_expected(fmt::format("a whole number from {} to {}", low, high));
  }
  return static_cast<int>(number);
}

bool TomlNode::truth() const {
  if (kind != TomlKind::boolean) fail_expected("true or false");
  return number != 0;
}

double TomlNode::finite_number() const {
  if (!is_number() || !std::isfinite(number)) fail_expected("a finite number");
  return number;
}

double TomlNode::number_from_zero() const {
  if (!is_number() || !std::isfinite(number) || number < 0) {
    fail_expected("a finite number, not negative");
  }
  return number;
}

double TomlNode::number_between(double low, double high) const {
  if (!is_number() || !(number >= low && number <= high)) {
    fail_expected(fmt::format("a number from {} to {}", low, high));
  }
  return number;
}

void TomlNode::fail_expected(std::string_view expected) const {
  fail_at_value({.what = name,
                 .value = shown(*this),
                 .expected = std::string(expected),
                 .form = InputForm::equals});
}

void TomlNode::fail_at_key(const InputFault& fault) const { fail(*this, key_at, fault); }

void TomlNode::fail_at_value(const InputFault& fault) const { fail(*this, at, fault); }

namespace {

// toml++ reads numbers by a stream, which keeps to itself that there was no memory for it. What is
// wrong with a text is wrong the second time, too.
toml::table parsed_table(const std::string& text) {
  try {
    return toml::parse(text);
  } catch (const toml::parse_error&) {
    return toml::parse(text);
  }
}

}  // namespace

TomlNode read_toml(const std::filesystem::path& path) {
  return parse_toml(read_file(path), path.string());
}

TomlNode parse_toml(const std::string& text, const std::string& name) {
  TomlNode root;
  root.file = std::make_shared<const std::string>(name);
  require_short_lines(root, text);
  try {
    convert_table(parsed_table(text), root, 0);
  } catch (const toml::parse_error& error) {
    fail(root, position(error.source()),
         {.what = fmt::format("not valid TOML: {}", error.description())});
  }
  return root;
}

std::string toml_text(std::string_view text) {
  std::string result = "\"";
  for (const char c : text) {
    const auto code = static_cast<unsigned char>(c);
    if (code < 0x20 || code == 0x7F) {
      result += fmt::format("\\u{:04X}", code);
      continue;
    }
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + '"';
}

std::string toml_comment(std::string text) {
  constexpr std::size_t longest = max_line_length - 2;
  if (text.size() > longest) text = text.substr(0, longest - 1) + "?";
  const auto no_text = [](char c) { return (c >= 0 && c < ' ' && c != '\t') || c == '\x7F'; };
  std::replace_if(text.begin(), text.end(), no_text, '?');
  try {
    const toml::table comment_alone = toml::parse("# " + text);
  } catch (const toml::parse_error&) {  // not UTF-8
    std::replace_if(
        text.begin(), text.end(), [](char c) { return c < 0; }, '?');
  }
  return "# " + text + "\n";
}

}  // namespace reeve::catalog
