#include "reports/output/csv_field.hpp"

#include <fmt/format.h>

#include <cmath>

namespace reeve::reports {

std::string csv_field(const std::string& text) {
  const bool looks_like_a_comment = text.starts_with('#');
  if (!looks_like_a_comment && text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + '"';
}

std::string csv_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "";
}

}  // namespace reeve::reports
