// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/message.h"

#include "core/error.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace loopmend {
namespace {

TEST(Message, PlacesTakeTheirArgumentsInAnyOrder) {
  EXPECT_EQ(say("%2 of %1, %1 again", "a", 7).english(), "7 of a, a again");
  EXPECT_EQ(say("rms %1 (%2)", 0.0123456789, 1.5e-5).english(), "rms 0.0123457 (1.5e-05)");
}

TEST(Message, AnArgumentIsNoText) {
  EXPECT_EQ(say("%1 and %2", "%2", "50%1").english(), "%2 and 50%1");
  EXPECT_EQ(say("5 % of %1, %2", 8).english(), "5 % of 8, %2") << "a place without an argument stays";
  EXPECT_EQ(say("%1", "a\nb\tc\x7f").english(), "a?b?c?");
}

TEST(Message, JoinedKeepsTheFirstCode) {
  const Message first = say("one").with_code("a"), second = say("two").with_code("b");
  EXPECT_EQ(joined(first, "; ", second).english(), "one; two");
  EXPECT_EQ(joined(first, "; ", second).code, "a");
  EXPECT_EQ(joined(say("one"), "; ", second).code, "b");
  EXPECT_EQ(joined(first, "; ", {}), first);
  EXPECT_EQ(joined({}, "; ", second), second);
  EXPECT_TRUE(joined({}, "; ", {}).empty());
}

TEST(Message, OfAnExceptionIsWhatItSays) {
  const ReadError error("/a.ply", say("the file ends too early"), say("line %1", 3), say("Export it again."));
  EXPECT_EQ(message_of(error).english(), "/a.ply: the file ends too early (line 3). Export it again.");
  EXPECT_STREQ(error.what(), message_of(error).english().c_str());
  EXPECT_EQ(message_of(std::runtime_error("100%1")).english(), "100%1");
}

}  // namespace
}  // namespace loopmend
