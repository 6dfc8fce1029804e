// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/labels.h"

#include <gtest/gtest.h>

namespace loopmend::test {
namespace {

SeamReport seam(double angle_deg, double jump) {
  SeamReport report;
  report.g1_rms_deg = angle_deg;
  report.h_jump_rms = jump;
  report.h_jump_rms_times_diameter = 10 * jump;
  return report;
}

bool praises(const SeamReport& before, const SeamReport& now) {
  return labels::seam_sentence(before, now, PatchStatus::converged, Grade::good)
      .contains(QStringLiteral("times smaller"));
}

TEST(SeamSentence, PraisesASmallerJumpOfCurvature) {
  EXPECT_TRUE(praises(seam(20, 100), seam(0.5, 2)));
  EXPECT_FALSE(praises(seam(20, 2), seam(0.5, 100)));
}

TEST(SeamSentence, GivesNoDigitsOfAJumpThatIsAsGoodAsGone) {
  const QString text = labels::seam_sentence(seam(20, 100), seam(0, 1e-4), PatchStatus::converged, Grade::good);
  EXPECT_TRUE(text.contains(QStringLiteral("over 1,000 times smaller"))) << text.toStdString();
}

TEST(SeamSentence, DoesNotPraiseABadPatch) {
  const QString text = labels::seam_sentence(seam(20, 100), seam(0.5, 2), PatchStatus::converged, Grade::bad);
  EXPECT_FALSE(text.contains(QStringLiteral("times smaller")));
}

TEST(SeamSentence, DoesNotPraiseASharpCreaseNorOneThatGrew) {
  EXPECT_FALSE(praises(seam(66.8, 104), seam(63.7, 8)));
  EXPECT_FALSE(praises(seam(10, 100), seam(14, 2)));
  EXPECT_TRUE(praises(seam(14, 100), seam(10, 2)));
}

}  // namespace
}  // namespace loopmend::test
