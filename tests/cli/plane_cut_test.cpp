// SPDX-License-Identifier: GPL-3.0-or-later
// A scan cut by a plane before it is filled: messages, report and marks.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/scan_attributes.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

namespace loopmend {
namespace {

using test::Outcome;
using testing::AllOf;
using testing::HasSubstr;
using json = nlohmann::json;

class PlaneCutCommand : public test::ProgramTest {
 protected:
  Outcome fill(const std::string& options) {
    write_mesh(work / "a.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }), Encoding::ascii);
    return test::loopmend_program("fill " + path("a.ply") + "-o " + path("out.ply") + options);
  }
};

TEST_F(PlaneCutCommand, IsCountedAndMarked) {
  const Outcome run = fill("--cut-plane=0,0,-0.2,0,0,-1 --flow none --check --mark --report " + path("r.json"));
  EXPECT_EQ(run.code, 0) << run.err;
  EXPECT_THAT(run.out, AllOf(HasSubstr("Cut by the plane:"), HasSubstr("1 curve of the section was closed by"),
                             HasSubstr("Ready to print: yes")));
  const json report = json::parse(test::text_of(work / "r.json"));
  const json& cut = report["prepared"]["plane_cut"];
  EXPECT_EQ(cut["closed_curves"], 1);
  EXPECT_EQ(cut["open_curves"], 0);
  EXPECT_GT(cut["removed_faces"], 1000);
  const TriangleSoup soup = read_mesh(work / "out.ply").soup;
  const AttributeColumn* patch = find_column(soup.attributes->faces, "patch");
  ASSERT_TRUE(patch);
  std::size_t flat = 0, others = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    bool is_flat = true;
    for (int v : soup.triangles[f]) is_flat = is_flat && soup.points[v].z() == -0.2;
    EXPECT_TRUE(!is_flat || patch->value(f) == 1);
    flat += is_flat;
    others += !is_flat && patch->value(f) == 1;
  }
  EXPECT_EQ(cut["new_faces"], flat);
  EXPECT_GT(others, 0U) << "the patch of the hole";
}

TEST_F(PlaneCutCommand, IsRefusedWithThePlaceAndTheCure) {
  EXPECT_THAT(fill("--cut-plane=0,0,3,0,0,1").err,
              AllOf(HasSubstr("a.ply: the cutting plane misses the surface"), HasSubstr("choose a point between")));
  EXPECT_THAT(fill("--cut-plane=0,0,3,0,0,-1").err, HasSubstr("would remove the whole surface"));
  for (const char* wrong : {"0,0,3,0,0", "0,0,3,0,0,x", "0,0,3,0,0,1,", "1"}) {
    const Outcome run = fill(std::string("--cut-plane=") + wrong);
    EXPECT_EQ(run.code, 2) << wrong;
    EXPECT_THAT(run.err, HasSubstr("six numbers")) << wrong;
  }
  EXPECT_THAT(fill("--cut-plane=0,0,0,0,0,0").err, HasSubstr("a normal that is not 0"));
  EXPECT_THAT(fill("--cut-plane=0,0,0,0,0,1 --at-vertex 3").err, HasSubstr("--cut-plane renumbers the vertices"));
}

}  // namespace
}  // namespace loopmend
