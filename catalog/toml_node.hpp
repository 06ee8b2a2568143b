// A TOML file as plain values that know where they stand, so that whoever reads them can name file,
// line, column, key and value of what is wrong. toml_node.cpp is the only file that names toml++.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"

namespace reeve::catalog {

enum class TomlKind : std::uint8_t { boolean, integer, floating, string, date, array, table };

// Line and column in the text, both from 1.
struct TomlPosition {
  std::uint32_t line = 1;
  std::uint32_t column = 1;
};

class TomlNode {
 public:
  TomlKind kind = TomlKind::table;
  std::shared_ptr<const std::string> file;
  std::string key;                 // the last part of the name; empty in an array
  std::string name;                // "finger.2.tip_mu", "table.tension[3]"; empty for the file
  TomlPosition key_at;             // place of the key, or of an array's item
  TomlPosition at;                 // place of the value
  double number = 0;               // integer, floating; boolean: 0 or 1
  std::string content;             // string
  std::vector<TomlNode> children;  // array, table; in the order of the file

  bool is_number() const { return kind == TomlKind::integer || kind == TomlKind::floating; }

  // These three require a table.
  const TomlNode* find(std::string_view key) const;
  const TomlNode& require(std::string_view key, std::string_view expected) const;
  void allow_only(const std::vector<std::string_view>& keys) const;

  // Each throws InputError if the value has another type.
  const std::vector<TomlNode>& tables() const;  // an array of tables
  const std::vector<TomlNode>& items() const;   // an array
  const TomlNode& table() const;
  const std::string& text() const;
  int integer(int low, int high) const;
  bool truth() const;
  // An integer is a number, too.
  double finite_number() const;
  double number_from_zero() const;                       // finite, not negative
  double number_between(double low, double high) const;  // both included

  // "file:line:column: name = value: expected …"
  [[noreturn]] void fail_expected(std::string_view expected) const;
  // The fault at "file:line:column", of the key or of the value.
  [[noreturn]] void fail_at_key(const InputFault& fault) const;
  [[noreturn]] void fail_at_value(const InputFault& fault) const;
};

// Throws InputError for a file that cannot be read, is larger than 1 MiB, or is not TOML.
TomlNode read_toml(const std::filesystem::path& path);
// `name` stands for the file in messages.
TomlNode parse_toml(const std::string& text, const std::string& name);

// The text in quotes, as a key or a value.
std::string toml_text(std::string_view text);

// "# text" and a line end, whatever the text: what TOML does not allow in a comment becomes '?'.
std::string toml_comment(std::string text);

}  // namespace reeve::catalog
