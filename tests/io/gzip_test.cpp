// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gzip.h"

#include "io/write_mesh.h"
#include "io_test_support.h"
#include "samples/analytic_surfaces.h"

#include <sstream>

namespace loopmend {
namespace {

std::string packed(std::string_view bytes) {
  std::ostringstream stream;
  GzipWriter gzip(stream);
  gzip.write(bytes);
  gzip.finish();
  return stream.str();
}

class Gzip : public ReadTest {};

TEST_F(Gzip, EveryFormatGoesThroughIt) {
  const TriangleSoup soup = make_icosphere(4);
  for (const char* name : {"a.ply", "a.stl", "a.obj", "a.off", "a.glb", "a.gltf"}) {
    write_mesh(folder_ / name, soup);
    const std::string gz = std::string(name) + ".gz";
    write_mesh(folder_ / gz, soup);
    EXPECT_LT(read_bytes(folder_ / gz).size(), read_bytes(folder_ / name).size());
    EXPECT_EQ(gunzip("x", read_bytes(folder_ / gz)), read_bytes(folder_ / name));
    EXPECT_EQ(read_mesh(folder_ / gz).soup.points, read_mesh(folder_ / name).soup.points);
    std::filesystem::copy_file(folder_ / gz, folder_ / (std::string("renamed_") + name));
    EXPECT_EQ(read_mesh(folder_ / (std::string("renamed_") + name)).soup.triangles.size(), soup.triangles.size());
  }
  EXPECT_THROW(write_mesh(folder_ / "a.gz", soup), WriteError);
}

/// `cat a.gz b.gz` is a file, too, and so is one with padding.
TEST_F(Gzip, MembersFollowEachOther) {
  EXPECT_EQ(gunzip("x", packed("one ") + packed("two") + std::string(7, '\0')), "one two");
  const std::string large(5'000'000, 'a');
  EXPECT_EQ(gunzip("x", packed(large)), large);
  EXPECT_EQ(gunzip("x", packed("")), "");
}

TEST_F(Gzip, RefusesWhatIsDamaged) {
  std::string bytes = packed("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  for (std::size_t size = 3; size < bytes.size(); ++size)
    expect_refused(bytes.substr(0, size), "a.off", {"compressed", "byte"});
  expect_refused(bytes + "more", "a.off", {"something else follows"});
  bytes[bytes.size() - 6] = static_cast<char>(bytes[bytes.size() - 6] ^ 1);  // the checksum
  expect_refused(bytes, "a.off", {"damaged"});
}

}  // namespace
}  // namespace loopmend
