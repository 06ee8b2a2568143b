#include <array>
#include <cctype>
#include <string_view>

#include "reports/document/document_latex.hpp"

namespace reeve::reports {
namespace {

struct Replacement {
  std::string_view text;
  std::string_view latex;
};

// The first that fits counts. Two dashes would become one longer one, and a bracket behind \\ an
// option of it.
constexpr std::array replacements{
    Replacement{"->", "$\\to$"},
    Replacement{"--", "-{}-"},
    Replacement{"\\", "\\textbackslash{}"},
    Replacement{"_", "\\_"},
    Replacement{"%", "\\%"},
    Replacement{"&", "\\&"},
    Replacement{"#", "\\#"},
    Replacement{"$", "\\$"},
    Replacement{"{", "\\{"},
    Replacement{"}", "\\}"},
    Replacement{"~", "\\textasciitilde{}"},
    Replacement{"^", "\\textasciicircum{}"},
    Replacement{"<=", "$\\leq$"},
    Replacement{">=", "$\\geq$"},
    Replacement{"<", "\\textless{}"},
    Replacement{">", "\\textgreater{}"},
    Replacement{"|", "\\textbar{}"},
    Replacement{"\"", "''"},
    Replacement{"[", "{[}"},
    Replacement{"]", "{]}"},
    Replacement{"*", "{*}"},
    Replacement{"–", "--"},
    Replacement{"—", "---"},
    Replacement{"−", "$-$"},
    Replacement{"…", "\\ldots{}"},
    Replacement{"·", "$\\cdot$"},
    Replacement{"±", "$\\pm$"},
    Replacement{"×", "$\\times$"},
    Replacement{"°", "$^{\\circ}$"},
    Replacement{"≤", "$\\leq$"},
    Replacement{"≥", "$\\geq$"},
    Replacement{"Σ", "$\\Sigma$"},
    Replacement{"µ", "$\\mu$"},  // the micro sign
    Replacement{"μ", "$\\mu$"},  // the Greek letter
    Replacement{"β", "$\\beta$"},
    Replacement{"γ", "$\\gamma$"},
    Replacement{"δ", "$\\delta$"},
    Replacement{"η", "$\\eta$"},
    Replacement{"θ", "$\\theta$"},
    Replacement{"φ", "$\\varphi$"},
    Replacement{"ϑ", "$\\vartheta$"},
};

const Replacement* replacement_at(const std::string& text, std::size_t at) {
  for (const Replacement& replacement : replacements) {
    if (text.compare(at, replacement.text.size(), replacement.text) == 0) return &replacement;
  }
  return nullptr;
}

bool is_minus(const std::string& text, std::size_t at) {
  if (text[at] != '-' || at + 1 == text.size()) return false;
  const bool before_number = std::isdigit(static_cast<unsigned char>(text[at + 1])) != 0;
  return before_number && (at == 0 || text[at - 1] == ' ' || text[at - 1] == '(');
}

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

std::string latex_escaped(const std::string& text) {
  std::string result;
  for (std::size_t at = 0; at < text.size();) {
    const Replacement* replacement = replacement_at(text, at);
    if (replacement != nullptr) {
      result += replacement->latex;
      at += replacement->text.size();
      continue;
    }
    if (is_minus(text, at)) {
      result += "$-$";
    } else {
      result += static_cast<unsigned char>(text[at]) < ' ' ? ' ' : text[at];
    }
    ++at;
  }
  return result;
}

double latex_width_pt(const std::string& text) {
  double width = 0;
  for (const char c : text) width += of_ten_pt(c);
  return footnotesize * width;
}

}  // namespace reeve::reports
