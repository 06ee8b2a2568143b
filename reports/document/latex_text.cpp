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

}  // namespace reeve::reports
