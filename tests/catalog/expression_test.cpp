#include "catalog/mechanisms/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "tests/support/input_error.hpp"

namespace reeve {
namespace {

double value_of(const std::string& text, const NamedValues& names = {}) {
  return parse_expression(text).evaluate(names);
}

std::string expression_error(const std::string& text, const NamedValues& names = {}) {
  return testing::message_of<InputError>([&] { value_of(text, names); });
}

TEST(Expression, BindsPowersBeforeSignsBeforeProductsBeforeSums) {
  EXPECT_EQ(value_of("1 + 2*3"), 7);
  EXPECT_EQ(value_of("(1 + 2)*3"), 9);
  EXPECT_EQ(value_of("-2^2"), -4);
  EXPECT_EQ(value_of("2*-3"), -6);
  EXPECT_EQ(value_of("2^-1"), 0.5);
  EXPECT_EQ(value_of("6/2*3"), 9);
}

TEST(Expression, GroupsDifferencesAndQuotientsFromTheLeftAndPowersFromTheRight) {
  EXPECT_EQ(value_of("10 - 4 - 3"), 3);
  EXPECT_EQ(value_of("24/4/2"), 3);
  EXPECT_EQ(value_of("2^3^2"), 512);
}

TEST(Expression, ReadsDecimalsAndSpacesAnywhere) {
  EXPECT_EQ(value_of(" 0.25 "), 0.25);
  EXPECT_EQ(value_of("1+2"), 3);
  EXPECT_EQ(value_of("max ( 1 , 2 )"), 2);
}

TEST(Expression, KnowsTheFunctionsOfCapstansAndOfPrintedDigits) {
  EXPECT_DOUBLE_EQ(value_of("exp(1)"), std::numbers::e);
  EXPECT_DOUBLE_EQ(value_of("ln(exp(3))"), 3);
  EXPECT_EQ(value_of("sqrt(16)"), 4);
  EXPECT_DOUBLE_EQ(value_of("4*atan(1)"), std::numbers::pi);
  EXPECT_EQ(value_of("floor(2.7)"), 2);
  EXPECT_EQ(value_of("floor(-2.7)"), -3);
  EXPECT_EQ(value_of("min(3, 1, 2)"), 1);
  EXPECT_EQ(value_of("max(3, 5, 4)"), 5);
  EXPECT_EQ(value_of("min(1, 3, 2)"), 1);
  EXPECT_EQ(value_of("max(5, 3, 4)"), 5);
  EXPECT_EQ(value_of("max(7)"), 7);
  EXPECT_EQ(value_of("1 + max(1, 2*3) - min(4, 2)"), 5);
}

TEST(Expression, TakesTheValuesOfNames) {
  const NamedValues names{{"T1", 3}, {"T_M", 2}, {"mu_b", 0.5}};
  EXPECT_EQ(value_of("T1/T_M", names), 1.5);
  EXPECT_EQ(value_of("mu_b*T1^2", names), 4.5);
}

TEST(Expression, HasNoNumberWhereArithmeticHasNone) {
  EXPECT_TRUE(std::isnan(value_of("0/0")));
  EXPECT_TRUE(std::isnan(value_of("ln(-1)")));
  EXPECT_TRUE(std::isinf(value_of("1/0")));
}

TEST(BadExpression, IsNamedWithTheColumnAndWhatWasExpected) {
  EXPECT_EQ(expression_error(""),
            "expression '', column 1: found '': expected a number, a name or '('");
  EXPECT_EQ(expression_error("1 + "),
            "expression '1 + ', column 5: found '': expected a number, a name or '('");
  EXPECT_EQ(expression_error("1 2"),
            "expression '1 2', column 3: found '2': expected an operator, or the end");
  EXPECT_EQ(expression_error("(1"),
            "expression '(1', column 3: found '': expected an operator, or ')'");
  EXPECT_EQ(expression_error("2*(1,2)"),
            "expression '2*(1,2)', column 5: found ',': expected an operator, or ')'");
  EXPECT_EQ(expression_error("min(1;2)"),
            "expression 'min(1;2)', column 6: found ';': expected an operator, ',' or ')'");
  EXPECT_EQ(expression_error("1 + sin(2)"),
            "expression '1 + sin(2)', column 5: found 'sin': expected one of exp, ln, sqrt, atan, "
            "floor, min, max before '('");
  EXPECT_EQ(expression_error("3."),
            "expression '3.', column 3: found '': expected a digit after the point");
  EXPECT_EQ(expression_error("exp(1, 2)"),
            "expression 'exp(1, 2)', column 6: found ',': expected an operator, or ')'");
  EXPECT_EQ(expression_error("1)"),
            "expression '1)', column 2: found ')': expected an operator, or the end");
}

TEST(BadExpression, NamesAnUnknownNameAndTheKnownOnes) {
  EXPECT_EQ(expression_error("T1 + T9", {{"T1", 1}, {"T2", 1}}),
            "expression 'T1 + T9', column 6: found 'T9': expected one of T1, T2");
}

TEST(BadExpression, IsRefusedBeforeItsNestingCouldHurt) {
  const std::string deep(100000, '(');
  EXPECT_NE(expression_error(deep).find("column 51: found '(': expected less nesting"),
            std::string::npos);
  const std::string signs(100000, '-');
  EXPECT_NE(expression_error(signs + "1").find("expected less nesting"), std::string::npos);
  EXPECT_EQ(value_of(std::string(40, '(') + "1" + std::string(40, ')')), 1);
}

TEST(Expression, OfAnyLengthIsWorkedOffWithoutNesting) {
  std::string text = "1";
  for (int i = 0; i < 1000; ++i) text += "+1";
  EXPECT_EQ(value_of(text), 1001);
}

}  // namespace
}  // namespace reeve
