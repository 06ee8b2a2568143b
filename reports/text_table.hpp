// Tables for people: columns aligned, numbers to the right.
#pragma once

#include <string>
#include <vector>

namespace reeve {

class TextTable {
 public:
  // A column whose heading begins with '<' is aligned to the left.
  explicit TextTable(const std::vector<std::string>& headings);

  void add(std::vector<std::string> cells);
  std::string text() const;

 private:
  std::vector<bool> left_;
  std::vector<std::vector<std::string>> rows_;
};

// A number with this many decimals; "-" if it is none.
std::string fixed(double value, int decimals = 3);

}  // namespace reeve
