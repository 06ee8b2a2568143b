#include "reports/mujoco/mjcf_text.hpp"

#include <fmt/format.h>

namespace reeve::reports {

void MjcfText::open(const char* name, const Attributes& attributes) {
  xml_.OpenElement(name);
  for (const auto& [key, value] : attributes) xml_.PushAttribute(key, value.c_str());
}

void MjcfText::leaf(const char* name, const Attributes& attributes) {
  open(name, attributes);
  close();
}

std::string MjcfText::number(double value) { return fmt::format("{:.9g}", value); }

std::string MjcfText::point(double x_m, double y_m) {
  return number(x_m) + " " + number(y_m) + " 0";
}

}  // namespace reeve::reports
