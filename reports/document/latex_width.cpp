#include <array>
#include <cctype>

#include "reports/document/document_latex.hpp"

namespace reeve::reports {
namespace {

// Widths in cmr10, pt: a … z, A … Z; digits and characters not listed here are 5 and 7.78 wide.
constexpr std::array small_letters{5.00, 5.56, 4.44, 5.56, 4.44, 3.06, 5.00, 5.56, 2.78,
                                   3.06, 5.28, 2.78, 8.33, 5.56, 5.00, 5.56, 5.28, 3.92,
                                   3.94, 3.89, 5.56, 5.28, 7.22, 5.28, 5.28, 4.44};
constexpr std::array great_letters{7.50, 7.08, 7.22, 7.64, 6.81,  6.53, 7.85, 7.50, 3.61,
                                   5.14, 7.78, 6.25, 9.17, 7.50,  7.78, 6.81, 7.78, 7.36,
                                   5.56, 7.22, 7.50, 7.50, 10.28, 7.50, 7.50, 6.11};
constexpr double digit = 5.00;
constexpr double other_width = 7.78;
constexpr double percent_sign = 8.33;
// cmr8 is somewhat wider than cmr10 made smaller.
constexpr double footnotesize = 0.85;

double of_ten_pt(char c) {
  const auto byte = static_cast<unsigned char>(c);
  if (byte >= 0x80)
    return (byte & 0xC0) == 0x80 ? 0 : other_width;  // a code point by its first byte
  if (std::islower(byte) != 0) return small_letters[static_cast<std::size_t>(c - 'a')];
  if (std::isupper(byte) != 0) return great_letters[static_cast<std::size_t>(c - 'A')];
  if (std::isdigit(byte) != 0 || c == '/' || c == '_') return digit;
  if (c == ' ' || c == '-') return 3.33;
  if (c == '.' || c == ',' || c == ':') return 2.78;
  if (c == '(' || c == ')') return 3.89;
  return c == '%' ? percent_sign : other_width;
}

}  // namespace

double latex_width_pt(const std::string& text) {
  double width = 0;
  for (const char c : text) width += of_ten_pt(c);
  return footnotesize * width;
}

}  // namespace reeve::reports
