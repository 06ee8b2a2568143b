// The published routings TR1 … TR7, in order.
#pragma once

#include <string>
#include <vector>

namespace reeve::testing {

inline const std::vector<std::string>& published_words() {
  static const std::vector<std::string> words{"M-1-T-2-F", "M-1-T-2-M", "F-1-P-2-F", "M-1-P-2-F",
                                              "M-1-P-2-M", "1-T-2-P-1", "1-P-2-P-1"};
  return words;
}

}  // namespace reeve::testing
