// A text with a mistake, and the message that names it.
#pragma once

#include <string>

namespace reeve::testing {

struct Mistake {
  std::string text;
  std::string message;
};

}  // namespace reeve::testing
