// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/single_precision.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>

namespace loopmend {
namespace {

/// FLT_DIG: six digits survive in a float.
TEST(SinglePrecision, SixDigitsAreNoMoreThanAFloatSays) {
  for (const double value : {0.1, -0.0378297, 123456.0, 1.17550e-38, 3.40282e38, 6e-17, 9.99999, 0.0, -1e10})
    EXPECT_TRUE(float_says_all(value)) << value;
}

TEST(SinglePrecision, MoreDigitsAre) {
  for (const double value : {3.14159265358979, 16777217.0, 0.123456789012, 1e39, -100.00000001, 1e-46})
    EXPECT_FALSE(float_says_all(value)) << value;
}

/// FLT_DECIMAL_DIG: nine digits name a float; whoever wrote them, or more of it, lost nothing.
TEST(SinglePrecision, FloatsWrittenWithNineToTwelveDigitsAreNoMore) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> exponents(-30, 30);
  for (int k = 0; k < 20000; ++k) {
    const float value = std::exp2(exponents(random)) * (k % 2 ? 1.F : -1.F);
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), "%.*g", 9 + k % 4, static_cast<double>(value));
    EXPECT_TRUE(float_says_all(std::strtod(text.data(), nullptr))) << text.data();
  }
}

/// By the definition: the float, written with as many digits.
TEST(SinglePrecision, SevenAndEightDigitsAreMoreWhereTheFloatReadsOtherwise) {
  std::mt19937 random(2);
  std::uniform_int_distribution<int> numbers(1000000, 99999999);
  int all = 0, more = 0;
  for (int k = 0; k < 20000; ++k) {
    const int number = numbers(random);
    std::array<char, 64> text{}, of_float{};
    const int digits = number < 10000000 ? 7 : 8;
    std::snprintf(text.data(), text.size(), "%d", number);
    const double value = std::strtod((std::string("0.") + text.data()).c_str(), nullptr);
    if (number % 10 == 0) continue;
    std::snprintf(of_float.data(), of_float.size(), "%.*f", digits, as_float(value));
    const bool same = std::string(of_float.data()) == std::string("0.") + text.data();
    EXPECT_EQ(float_says_all(value), same) << text.data();
    ++(same ? all : more);
  }
  EXPECT_GT(all, 1000);
  EXPECT_GT(more, 1000);
}

TEST(SinglePrecision, RoundingCountsPointsAndLeavesWhatIsNoFloat) {
  Points points{{0.1, 0.2, 0.3}, {3.14159265358979, 2.71828182845905, 0}, {1, 2, 3}};
  const FloatRounding rounding = round_to_floats(points);
  EXPECT_EQ(rounding.longer, 1U);
  EXPECT_TRUE(rounding.in_range);
  EXPECT_EQ(points[1], Vec3(3.14159265358979F, 2.71828182845905F, 0));
  Points large{{0.1, 0, 0}, {1e39, 0, 0}};
  EXPECT_FALSE(round_to_floats(large).in_range);
  EXPECT_EQ(large[0].x(), 0.1);
}

}  // namespace
}  // namespace loopmend
