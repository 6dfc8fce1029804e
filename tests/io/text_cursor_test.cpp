// SPDX-License-Identifier: GPL-3.0-or-later
// Lines, tokens and numbers of mesh text.
#include "io/text_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <sstream>
#include <string>

namespace loopmend {
namespace {

TEST(ParseDouble, AcceptsWhatMeshFilesWrite) {
  EXPECT_EQ(parse_double("1"), 1.0);
  EXPECT_EQ(parse_double("+1.5"), 1.5);
  EXPECT_EQ(parse_double("-.8e-1"), -0.08);
  EXPECT_EQ(parse_double("2."), 2.0);
  EXPECT_EQ(parse_double("3E4"), 3e4);
  EXPECT_TRUE(std::signbit(*parse_double("-0")));
}

TEST(ParseDouble, RefusesWhatIsNotWhollyANumber) {
  for (const char* token : {"", "+", "-", "+-1", "1x", "1,5", "0x10", "e5", ".", "3.1+e2", " 1", "1 "}) {
    EXPECT_FALSE(parse_double(token)) << token;
  }
}

TEST(ParseDouble, TooLargeIsInfiniteAndTooSmallIsZero) {
  EXPECT_EQ(parse_double("1e999"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("-1e999"), -std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("1e-999"), 0.0);
  EXPECT_EQ(parse_double("4.9406564584124654e-324"), std::numeric_limits<double>::denorm_min());
  EXPECT_TRUE(std::isnan(*parse_double("nan")));
  EXPECT_TRUE(std::isinf(*parse_double("-Inf")));
}

TEST(ParseDouble, KnowsWhatOldVisualCppWrites) {
  for (const char* token : {"1.#QNAN", "-1.#IND", "1.#IND00", "1.#SNAN0"})
    EXPECT_TRUE(parse_double(token) && std::isnan(*parse_double(token))) << token;
  EXPECT_EQ(parse_double("1.#INF"), std::numeric_limits<double>::infinity());
  EXPECT_EQ(parse_double("-1.#INF00"), -std::numeric_limits<double>::infinity());
  for (const char* token : {"1.#", "1.#IN", "1.#INFx", "2.#INF", "#INF", "1.#ind"})
    EXPECT_FALSE(parse_double(token)) << token;
}

TEST(ParseDouble, AgreesWithStrtodToTheLastBit) {
  std::mt19937_64 random(7);
  for (int i = 0; i < 20000; ++i) {
    std::ostringstream stream;
    stream << random() % 1000000 << '.' << random() << 'e' << static_cast<int>(random() % 600) - 300;
    const std::string text = stream.str();
    ASSERT_EQ(parse_double(text), std::strtod(text.c_str(), nullptr)) << text;
  }
}

TEST(ParseInteger, RefusesFractionsAndOverflow) {
  EXPECT_EQ(parse_integer("-12"), -12);
  EXPECT_EQ(parse_integer("+12"), 12);
  for (const char* token : {"", "1.0", "1e3", "99999999999999999999", "0x1", "--1"}) {
    EXPECT_FALSE(parse_integer(token)) << token;
  }
}

/// "1.#QNAN" was read as 1 and a comment: a place that is none became one.
TEST(TextCursor, TheMarkWithinANumberIsNoComment) {
  TextCursor cursor("v 1.#QNAN -1.#IND#a 1.#INF\n1.#1 x", '#');
  ASSERT_TRUE(cursor.next_line());
  for (const char* token : {"v", "1.#QNAN", "-1.#IND", ""}) EXPECT_EQ(cursor.next_token(), token);
  ASSERT_TRUE(cursor.next_line());
  for (const char* token : {"1.", ""}) EXPECT_EQ(cursor.next_token(), token);
}

TEST(TextCursor, EndsBeforeTheMarksOfOldPrograms) {
  for (const std::string& text :
       {std::string("a"), std::string("a\0", 2), std::string("a\x1A\x1A"), std::string("a\x1A\0", 3)})
    EXPECT_EQ(without_end_mark(text), "a");
  EXPECT_EQ(without_end_mark(std::string_view("a\0\0", 3)).size(), 2U) << "what a crash leaves";
  TextCursor cursor(std::string_view("a\n\0", 3));
  EXPECT_TRUE(cursor.next_line());
  EXPECT_FALSE(cursor.next_line());
}

TEST(TextCursor, KnowsAllLineEnds) {
  TextCursor cursor("a\nb\r\nc\rd");
  std::string tokens;
  while (cursor.next_line()) {
    tokens += cursor.next_token();
    tokens += std::to_string(cursor.line_number());
  }
  EXPECT_EQ(tokens, "a1b2c3d4");
  EXPECT_FALSE(cursor.next_line());
  EXPECT_TRUE(cursor.next_token_across_lines().empty());
}

TEST(TextCursor, LeavesCommentsOut) {
  TextCursor cursor("1 2# three\n#\n 4", '#');
  EXPECT_EQ(cursor.next_token_across_lines(), "1");
  EXPECT_EQ(cursor.next_token_across_lines(), "2");
  EXPECT_EQ(cursor.next_token_across_lines(), "4");
  EXPECT_EQ(cursor.place().english(), "line 3");
}

TEST(InQuotes, ShortensAndHidesUnprintableBytes) {
  EXPECT_EQ(in_quotes(std::string_view("a\0b", 3)), "\"a?b\"");
  EXPECT_EQ(in_quotes(std::string(100, 'x')).size(), 45U);
}

}  // namespace
}  // namespace loopmend
