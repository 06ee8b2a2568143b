#include "catalog/mechanisms/expression.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

#include "core/error.hpp"

namespace reeve::catalog {
namespace {

[[noreturn]] void fail_in(const std::string& text, std::size_t column, const std::string& found,
                          const std::string& expected) {
  throw InputError({.where = fmt::format("expression '{}', column {}", text, column),
                    .what = "found",
                    .value = found,
                    .expected = expected});
}

}  // namespace

class ExpressionParser {
 public:
  explicit ExpressionParser(std::string_view text) { expression_.text_ = text; }

  Expression run() {
    sum();
    if (peek() != '\0') fail_here("an operator, or the end");
    return std::move(expression_);
  }

 private:
  using Operation = Expression::Operation;

  // It calls itself for every parenthesis, sign and power.
  static constexpr int max_depth = 50;

  static bool is_digit(char c) { return c >= '0' && c <= '9'; }
  static bool is_letter(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_';
  }

  const std::string& text() const { return expression_.text_; }

  void skip_spaces() {
    while (at_ < text().size() && text()[at_] == ' ') ++at_;
  }

  char peek() {
    skip_spaces();
    return at_ < text().size() ? text()[at_] : '\0';
  }

  bool take(char wanted) {
    if (peek() != wanted) return false;
    ++at_;
    return true;
  }

  [[noreturn]] void fail_here(const std::string& expected) {
    const char next = peek();
    fail_in(text(), at_ + 1, next == '\0' ? "" : std::string(1, next), expected);
  }

  void push(Operation operation) { expression_.steps_.push_back({.operation = operation}); }

  void sum() {
    product();
    for (;;) {
      if (take('+')) {
        product();
        push(Operation::add);
      } else if (take('-')) {
        product();
        push(Operation::subtract);
      } else {
        return;
      }
    }
  }

  void product() {
    factor();
    for (;;) {
      if (take('*')) {
        factor();
        push(Operation::multiply);
      } else if (take('/')) {
        factor();
        push(Operation::divide);
      } else {
        return;
      }
    }
  }

  void factor() {
    if (++depth_ > max_depth) fail_here("less nesting");
    if (take('-')) {
      factor();
      push(Operation::negate);
    } else {
      atom();
      if (take('^')) {
        factor();
        push(Operation::power);
      }
    }
    --depth_;
  }

  void atom() {
    const char next = peek();
    if (take('(')) {
      sum();
      if (!take(')')) fail_here("an operator, or ')'");
    } else if (is_digit(next)) {
      number();
    } else if (is_letter(next)) {
      name();
    } else {
      fail_here("a number, a name or '('");
    }
  }

  void digits() {
    while (at_ < text().size() && is_digit(text()[at_])) ++at_;
  }

  void number() {
    const std::size_t begin = at_;
    digits();
    if (at_ < text().size() && text()[at_] == '.') {
      ++at_;
      if (at_ == text().size() || !is_digit(text()[at_])) fail_here("a digit after the point");
      digits();
    }
    const std::string written = text().substr(begin, at_ - begin);
    expression_.steps_.push_back(
        {.operation = Operation::number, .number = std::strtod(written.c_str(), nullptr)});
  }

  void name() {
    const std::size_t begin = at_;
    while (at_ < text().size() && (is_letter(text()[at_]) || is_digit(text()[at_]))) ++at_;
    const std::string name = text().substr(begin, at_ - begin);
    if (peek() == '(') {
      function(name, begin + 1);
    } else {
      expression_.steps_.push_back(
          {.operation = Operation::name, .name = name, .column = begin + 1});
    }
  }

  void function(const std::string& name, std::size_t column) {
    const std::map<std::string, Operation> functions{
        {"exp", Operation::exp},   {"ln", Operation::ln},       {"sqrt", Operation::sqrt},
        {"atan", Operation::atan}, {"floor", Operation::floor}, {"min", Operation::min},
        {"max", Operation::max}};
    const auto found = functions.find(name);
    if (found == functions.end()) {
      fail_in(text(), column, name, "one of exp, ln, sqrt, atan, floor, min, max before '('");
    }
    const bool many = found->second == Operation::min || found->second == Operation::max;
    take('(');
    std::size_t arguments = 1;
    sum();
    while (many && take(',')) {
      sum();
      ++arguments;
    }
    if (!take(')')) fail_here(many ? "an operator, ',' or ')'" : "an operator, or ')'");
    expression_.steps_.push_back({.operation = found->second, .arguments = arguments});
  }

  Expression expression_;
  std::size_t at_ = 0;
  int depth_ = 0;
};

double Expression::apply(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::power:
      return std::pow(a, b);
    case Operation::min:
      return std::min(a, b);
    case Operation::max:
      return std::max(a, b);
    case Operation::negate:
      return -b;
    case Operation::exp:
      return std::exp(b);
    case Operation::ln:
      return std::log(b);
    case Operation::sqrt:
      return std::sqrt(b);
    case Operation::atan:
      return std::atan(b);
    default:
      return std::floor(b);
  }
}

void Expression::work_off(const Step& step, std::vector<double>& stack) const {
  const auto take = [&stack] {
    const double top = stack.back();
    stack.pop_back();
    return top;
  };
  const bool one = step.operation == Operation::negate ||
                   (step.operation >= Operation::exp && step.operation <= Operation::floor);
  // min and max take one comparison less than arguments.
  const std::size_t times = step.operation >= Operation::min ? step.arguments - 1 : 1;
  for (std::size_t i = 0; i < times; ++i) {
    const double b = take();
    const double a = one ? 0 : take();
    stack.push_back(apply(step.operation, a, b));
  }
}

double Expression::evaluate(const NamedValues& values) const {
  std::vector<double> stack;
  for (const Step& step : steps_) {
    if (step.operation == Operation::number) {
      stack.push_back(step.number);
    } else if (step.operation == Operation::name) {
      const auto found = values.find(step.name);
      if (found == values.end()) {
        std::string known;
        for (const auto& [name, value] : values) known += (known.empty() ? "" : ", ") + name;
        fail_in(text_, step.column, step.name, "one of " + known);
      }
      stack.push_back(found->second);
    } else {
      work_off(step, stack);
    }
  }
  return stack.back();
}

Expression parse_expression(std::string_view text) { return ExpressionParser(text).run(); }

}  // namespace reeve::catalog
