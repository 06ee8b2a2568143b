#include "reports/output/number_texts.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "reports/output/csv_field.hpp"
#include "reports/output/json.hpp"

namespace reeve {
namespace {

using reports::NumberTexts;

// Of any size, of ten decimals as objectives are, and some that are printed otherwise.
std::vector<double> many_numbers() {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<double> numbers{0,
                              -0.0,
                              1,
                              12,
                              -3.5,
                              1e15,
                              1e16,
                              1e-5,
                              1e22,
                              5e-324,
                              std::numeric_limits<double>::max(),
                              std::numeric_limits<double>::infinity(),
                              std::numeric_limits<double>::quiet_NaN()};
  for (int i = 0; i < 20'000; ++i) {
    numbers.push_back(std::bit_cast<double>(random()));
    numbers.push_back(std::round(share(random) * 1e10) / 1e10);
  }
  return numbers;
}

TEST(NumberTexts, AreThoseOfJson) {
  NumberTexts texts(reports::print_json_number);
  for (const double number : many_numbers()) {
    for (int twice = 0; twice < 2; ++twice) {
      ASSERT_EQ(texts.text(number), reports::number(number).dump());
    }
  }
}

TEST(NumberTexts, AreThoseOfCsv) {
  NumberTexts texts(reports::print_csv_number);
  for (const double number : many_numbers()) {
    for (int twice = 0; twice < 2; ++twice) {
      ASSERT_EQ(texts.text(number), reports::csv_number(number));
    }
  }
}

}  // namespace
}  // namespace reeve
