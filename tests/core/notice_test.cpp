// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/notice.h"

#include <gtest/gtest.h>

namespace loopmend {
namespace {

TEST(Notice, IsASentenceWithItsFigures) {
  EXPECT_EQ(message_of({NoticeCode::crease, {50.2, 12}}).english(), "a crease of 50° along 12 edges of the seam");
  EXPECT_EQ(message_of({NoticeCode::folded_edges, {1}}).english(), "1 edge is folded by more than 150°");
  EXPECT_EQ(message_of({NoticeCode::crosses_surface, {3}}).english(), "crosses the surface or itself in 3 places");
  EXPECT_EQ(message_of({NoticeCode::dome_over_flat_loop, {0.4213}}).english(),
            "a dome 0.42 diameters high over a flat loop");
  EXPECT_STREQ(to_string(NoticeCode::crease), "crease");
}

}  // namespace
}  // namespace loopmend
