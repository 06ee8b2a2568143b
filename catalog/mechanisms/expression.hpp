// Arithmetic in data files, such as "exp(-mu_t*pi)" or "100*T1/(2*T_M)": what a publication prints
// as a formula, and what is to be made of computed tensions.
//
//   sum      = product { ("+" | "-") product }
//   product  = factor { ("*" | "/") factor }
//   factor   = "-" factor | power
//   power    = atom [ "^" factor ]
//   atom     = number | name | function "(" sum { "," sum } ")" | "(" sum ")"
//   function = exp | ln | sqrt | atan | floor, of one; min | max, of one or more
//
// So -x^2 is -(x^2), and 2^3^2 is 2^(3^2). Numbers are decimal, without a sign or an exponent.
// Nothing else is run: no assignment, no loop, no name that is not given.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "numerics/floors.hpp"

namespace reeve::catalog {

using NamedValues = std::map<std::string, double, std::less<>>;

class Expression {
 public:
  const std::string& text() const { return text_; }
  // Throws InputError that names the first name that is not among `values`. What has no value
  // (0/0, the root of a negative number) is not a number.
  double evaluate(const NamedValues& values) const;

 private:
  friend class ExpressionParser;

  enum class Operation : std::uint8_t {
    number,
    name,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    exp,
    ln,
    sqrt,
    atan,
    floor,
    min,
    max,
  };
  // Steps follow in the order of a stack machine.
  struct Step {
    Operation operation = Operation::number;
    double number = 0;
    std::string name = {};
    std::size_t column = 1;
    std::size_t arguments = 0;  // min, max
  };

  static double apply(Operation operation, double a, double b);
  void work_off(const Step& step, std::vector<double>& stack) const;

  std::string text_;
  std::vector<Step> steps_;
};

// Throws InputError with the text, the column (from 1), what stands there and what was expected.
Expression parse_expression(std::string_view text);

}  // namespace reeve::catalog
