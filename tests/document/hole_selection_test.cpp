// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/hole_selection.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

struct Watched {
  Watched() {
    QObject::connect(&selection, &HoleSelection::selection_changed, [this] { ++selected; });
    QObject::connect(&selection, &HoleSelection::hover_changed, [this] { ++hovered; });
  }
  HoleSelection selection;
  int selected = 0, hovered = 0;
};

TEST(HoleSelection, TogglesAndSaysSoOnce) {
  Watched w;
  w.selection.select({3, 1});
  EXPECT_EQ(w.selected, 1);
  w.selection.select({1, 3});
  EXPECT_EQ(w.selected, 1) << "the same loops";
  w.selection.toggle(3);
  w.selection.toggle(7);
  EXPECT_EQ(w.selection.selected(), (std::set<int>{1, 7}));
  EXPECT_EQ(w.selected, 3);
  EXPECT_EQ(w.hovered, 0);
}

TEST(HoleSelection, HoversOverOneLoopAtATime) {
  Watched w;
  EXPECT_EQ(w.selection.hovered(), no_loop);
  w.selection.hover(2);
  w.selection.hover(2);
  EXPECT_EQ(w.hovered, 1);
  w.selection.select({2});
  w.selection.clear();
  EXPECT_EQ(w.selection.hovered(), no_loop);
  EXPECT_TRUE(w.selection.selected().empty());
  EXPECT_EQ(w.hovered, 2);
  EXPECT_EQ(w.selected, 2);
  w.selection.clear();
  EXPECT_EQ(w.selected + w.hovered, 4) << "nothing left to clear";
}

}  // namespace
}  // namespace loopmend::test
