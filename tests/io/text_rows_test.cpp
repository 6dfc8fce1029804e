// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_rows.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace loopmend {
namespace {

TEST(TextRows, ManyLinesComeInTheirPlaces) {
  constexpr std::size_t rows = 60000;  // several blocks
  std::string text;
  for (std::size_t r = 0; r < rows; ++r) text += std::to_string(r) + (r % 3 == 0 ? "\t 0.5 \r\n" : " 0.5\n");
  const std::size_t size = text.size();
  std::vector<double> first(rows + 1, -1);
  const auto keep = [&](std::size_t row, const double* numbers) {
    first[row] = numbers[0];
    return numbers[1] == 0.5;
  };
  for (const std::string& rest : {std::string(), std::string("3 0 1 2\n"), std::string(2'000'000, '\n')})
    EXPECT_EQ(read_rows(text + rest, rows, 2, keep), size);
  for (std::size_t r = 0; r < rows; ++r) ASSERT_EQ(first[r], static_cast<double>(r));
  EXPECT_EQ(first[rows], -1);
}

TEST(TextRows, WhatIsOutOfTheCommonIsNotRead) {
  const auto take = [](std::size_t, const double*) { return true; };
  EXPECT_EQ(read_rows("1 2\n3 4", 2, 2, take), 7U);  // without a line break at the end
  EXPECT_EQ(read_rows("1 2\n+3 -4e2\n", 2, 2, take), 12U);
  for (const char* text :
       {"1 2\n", "1 2\n3\n4\n", "1 2\n3 4 5\n", "1 2\n\n3 4\n", "1 2\r3 4\n", "1 2\n3 x\n", "", "1 2\n3 4\v\n"})
    EXPECT_FALSE(read_rows(text, 2, 2, take)) << text;
  EXPECT_FALSE(read_rows("1 2\n3 4\n", 2, 2, KeepRow([](std::size_t row, const double*) { return row == 0; })));
  EXPECT_EQ(read_rows("v 1 2\nv 3 4\n", 2, 2, take, "v "), 12U);
  EXPECT_FALSE(read_rows("v 1 2\nvn 3 4\n", 2, 2, take, "v "));
  EXPECT_EQ(count_rows("v 1\nv 2\nvt 3\nv 4\n", "v "), 2U);
  EXPECT_EQ(count_rows("v 1\nv 2", "v "), 2U);
  EXPECT_EQ(count_rows("", "v "), 0U);
  const auto take_integers = [](std::size_t, const std::int64_t*) { return true; };
  EXPECT_EQ(read_rows("3 0 1 2\n", 1, 4, KeepIntegers(take_integers)), 8U);
  EXPECT_FALSE(read_rows("3 0 1 2.0\n", 1, 4, KeepIntegers(take_integers)));
}

}  // namespace
}  // namespace loopmend
