// SPDX-License-Identifier: GPL-3.0-or-later
// No command overwrites what it reads or writes; what it writes appears together; and what it says about that is so.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include <fstream>
#include <map>

namespace loopmend {
namespace {

using test::loopmend_program;
using test::Outcome;
using test::text_of;
using testing::HasSubstr;

class Files : public test::ProgramTest {
 protected:
  Files() {
    write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; }));
    write_mesh(work / "poly.off", make_dodecahedron());
    std::filesystem::create_hard_link(work / "scan.ply", work / "hard.ply");
    std::filesystem::create_symlink("scan.ply", work / "soft.ply");
    std::filesystem::create_symlink("new.ply", work / "dangling.ply");
    std::ofstream(work / "region.ply") << "0 1 2\n";
    before_ = all_files();
  }

  /// Everything in the folder, with its content.
  std::map<std::string, std::string> all_files() const {
    std::map<std::string, std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(work.folder()))
      if (!std::filesystem::exists(entry))
        files[entry.path()] = "dangling";
      else if (entry.is_regular_file())
        files[entry.path()] = text_of(entry.path());
    return files;
  }

  /// `%` stands for the folder.
  Outcome run(std::string words) const {
    for (std::size_t at; (at = words.find('%')) != std::string::npos;) words.replace(at, 1, work.folder().string());
    return loopmend_program(words);
  }

  void expect_nothing_done(const std::string& words, int code, const std::string& reason) {
    const Outcome outcome = run(words);
    EXPECT_EQ(outcome.code, code) << words << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(reason)) << words;
    EXPECT_EQ(all_files(), before_) << words;
  }

  std::map<std::string, std::string> before_;
};

TEST_F(Files, NoCommandOverwritesWhatItReads) {
  for (const char* name : {"%/scan.ply", "%/./scan.ply", "%/hard.ply", "%/soft.ply"}) {
    const std::string out = std::string(name) + " ";
    for (const std::string& words :
         {"fill %/scan.ply -o " + out, "render %/scan.ply -o " + out, "render %/scan.ply --film " + out,
          "render %/poly.off %/scan.ply -o " + out, "info %/scan.ply --json " + out,
          "fill %/scan.ply -o %/out.ply --report " + out, "evolve %/scan.ply --where 'z>0.5' -o " + out,
          "evolve %/scan.ply --where 'z>0.5' -o %/out.ply --report " + out,
          "evolve %/poly.off --region %/scan.ply -o " + out, "interpolate %/scan.ply --open -o " + out,
          "interpolate %/poly.off --fixed %/scan.ply -o %/out.ply --report " + out,
          "blend %/scan.ply %/poly.off -o " + out, "blend %/poly.off %/scan.ply -o %/out.ply --report " + out,
          "compare %/scan.ply -o %/flows --report " + out})
      expect_nothing_done(words, 2, "would overwrite");
  }
}

TEST_F(Files, NoOutputOverwritesAnother) {
  for (const char* report : {"%/out.ply", "%/./out.ply"})
    expect_nothing_done(std::string("fill %/scan.ply -o %/out.ply --report ") + report, 2, "would overwrite -o");
  expect_nothing_done("fill %/scan.ply -o %/new.ply --report %/dangling.ply", 2, "would overwrite -o");
  expect_nothing_done("evolve %/scan.ply --where 'z>0.5' -o %/new.ply --report %/dangling.ply", 2, "would overwrite");
  expect_nothing_done("compare %/scan.ply -o %/flows --report %/flows/table.csv", 2, "would overwrite");
}

TEST_F(Files, ComparisonsNeverOverwriteTheirInput) {
  std::filesystem::create_directory(work / "flows");
  std::filesystem::copy_file(work / "scan.ply", work / "flows/start.ply");
  before_ = all_files();
  expect_nothing_done("compare %/flows/start.ply -o %/flows", 2, "would overwrite the input");
}

TEST_F(Files, APictureNeedsThePicturesExtension) {
  expect_nothing_done("render %/scan.ply -o %/out.ply", 4, "ends in .png");
  expect_nothing_done("render %/scan.ply -o %/out", 4, "ends in .png");
  expect_nothing_done("render %/scan.ply --film %/out.png", 4, "ends in .gif");
}

TEST_F(Files, AReportThatCannotBeWrittenKeepsTheOldMesh) {
  // The report of a hundred loops is larger than this mesh: a limit between the two lets only the mesh through.
  std::vector<TriangleSoup> parts;
  for (int k = 0; k < 40; ++k) {
    TriangleSoup part = make_icosphere(0);
    part.triangles.pop_back();
    for (Vec3& p : part.points) p += Vec3(5 * k, 0, 0);
    parts.push_back(part);
  }
  write_mesh(work / "many.ply", joined(parts));
  const auto blocks = 2 * (std::filesystem::file_size(work / "many.ply") + 8192) / 1024;
  std::ofstream(work / "out.ply") << "old mesh";
  std::ofstream(work / "report.json") << "old report";
  before_ = all_files();
  const std::string command = "ulimit -f " + std::to_string(blocks) + "; " + LOOPMEND_PROGRAM + " fill " +
                              path("many.ply") + "-o " + path("out.ply") + "--flow none --quiet --report " +
                              path("report.json") + "2>&1 | cat >" + path("said");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_THAT(text_of(work / "said"), HasSubstr("report.json: cannot be written"));
  EXPECT_THAT(text_of(work / "said"), HasSubstr("Nothing was written."));
  std::filesystem::remove(work / "said");
  EXPECT_EQ(all_files(), before_);
}

TEST_F(Files, AFullStandardOutputNamesTheFilesThatStand) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "/dev/full is not here";
  const std::string command = std::string(LOOPMEND_PROGRAM) + " fill " + path("scan.ply") + "-o " + path("out.ply") +
                              "--flow none --report - >/dev/full 2>" + path("said");
  EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 4);
  EXPECT_THAT(text_of(work / "said"), HasSubstr((work / "out.ply").string() + " was written."));
  EXPECT_EQ(read_mesh(work / "out.ply").report.format, "PLY");
}

TEST_F(Files, WhatCannotBeWrittenIsSaidToHaveChangedNothing) {
  expect_nothing_done("fill %/scan.ply -o /proc/out.ply", 4, "Nothing was written.");
  expect_nothing_done("compare %/scan.ply -o %/scan.ply/flows", 4, "Nothing was written.");
}

TEST_F(Files, CancellingTellsWhatStands) {
  // The report goes to a pipe that is not read: the mesh stands by then, and the signal comes while the program waits.
  const std::string script = "mkfifo " + path("pipe") + "; " + "sleep 60 <" + path("pipe") + "& reader=$!; " +
                             LOOPMEND_PROGRAM + " fill " + path("many.ply") + "-o " + path("out.ply") +
                             "--flow none --report - >" + path("pipe") + "2>" + path("said") +
                             "& program=$!; for k in $(seq 300); do [ -e " + path("out.ply") +
                             "] && break; sleep 0.1; done; sleep 0.3; kill -TERM $program; wait $program; echo $? >" +
                             path("code") + "; kill $reader";
  std::vector<TriangleSoup> parts;  // its report is larger than a pipe holds
  for (int k = 0; k < 80; ++k) {
    TriangleSoup part = make_icosphere(0);
    part.triangles.pop_back();
    for (Vec3& p : part.points) p += Vec3(5 * k, 0, 0);
    parts.push_back(part);
  }
  write_mesh(work / "many.ply", joined(parts));
  EXPECT_EQ(std::system(script.c_str()), 0);
  EXPECT_EQ(text_of(work / "code"), "143\n");
  EXPECT_THAT(text_of(work / "said"),
              HasSubstr("cancelled by SIGTERM after " + (work / "out.ply").string() + " was written"));
}

TEST_F(Files, CancellingBeforeAnythingStandsSaysSo) {
  write_mesh(work / "big.ply", cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0; }));
  const std::string script = std::string(LOOPMEND_PROGRAM) + " compare " + path("big.ply") + "-o " + path("new/flows") +
                             "2>" + path("said") + "& program=$!; for k in $(seq 300); do [ -e " + path("new/flows") +
                             "] && break; sleep 0.1; done; kill -TERM $program; wait $program; echo $? >" +
                             path("code");
  EXPECT_EQ(std::system(script.c_str()), 0);
  EXPECT_EQ(text_of(work / "code"), "143\n");
  EXPECT_THAT(text_of(work / "said"), HasSubstr("cancelled by SIGTERM; nothing was written"));
  EXPECT_FALSE(std::filesystem::exists(work / "new"));
}

}  // namespace
}  // namespace loopmend
