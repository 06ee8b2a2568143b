// XML by the element, with the numbers and points of MJCF.
#pragma once

#include <tinyxml2.h>

#include <string>
#include <utility>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::reports {

class MjcfText {
 public:
  using Attributes = std::vector<std::pair<const char*, std::string>>;

  void open(const char* name, const Attributes& attributes = {});
  void close() { xml_.CloseElement(); }
  void leaf(const char* name, const Attributes& attributes);
  void comment(const std::string& text) { xml_.PushComment(text.c_str()); }
  std::string text() const { return xml_.CStr(); }

  static std::string number(double value);
  static std::string point(double x_m, double y_m = 0);

 private:
  tinyxml2::XMLPrinter xml_;
};

}  // namespace reeve::reports
