// SPDX-License-Identifier: GPL-3.0-or-later
// OFF as Geomview, CGAL, MeshLab and old benchmarks write it.
#include "exporter_variants.h"

namespace loopmend {
namespace exporters_off {

const std::string counts = "4 2 5\n";
const std::string places = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string faces = "3 0 1 2\n3 0 2 3\n";
const std::string plain = "OFF\n" + counts + places + faces;

std::string keyword(const std::string& word, const std::string& extras) {
  return word + "\n" + counts + around_lines(places, "", " " + extras) + faces;
}

std::string face_colors(const std::string& first, const std::string& second) {
  return "OFF\n" + counts + places + "3 0 1 2" + first + "\n3 0 2 3" + second + "\n";
}

std::vector<Variant> heads() {
  const char* lower = "keyword in lower case (1)";
  return {
      {"plain", "a.off", plain},
      {"counts on the first line", "a.off", replaced_once(plain, "OFF\n", "OFF ")},
      {"counts without a blank: ModelNet", "a.off", replaced_once(plain, "OFF\n", "OFF")},
      {"no count of edges", "a.off", replaced_once(plain, "4 2 5", "4 2")},
      {"count of edges 0", "a.off", replaced_once(plain, "4 2 5", "4 2 0")},
      {"counts on three lines", "a.off", replaced_once(plain, "4 2 5", "4\n2")},
      {"no keyword", "a.off", counts + places + faces},
      {"off", "a.off", replaced_once(plain, "OFF", "off"), lower},
      {"COFF", "a.off", keyword("COFF", "255 128 0 255")},
      {"COFF without alpha", "a.off", keyword("COFF", "255 128 0")},
      {"COFF of fractions", "a.off", keyword("COFF", "1.0 0.5 0.25 1.0")},
      {"OFF with colours of vertices", "a.off", keyword("OFF", "0.5 0.5 0.5 1")},
      {"NOFF", "a.off", keyword("NOFF", "0 0 1")},
      {"NCOFF", "a.off", keyword("NCOFF", "0 0 1 255 0 0 255")},
      {"CNOFF", "a.off", keyword("CNOFF", "0 0 1 255 0 0 255")},
      {"STOFF", "a.off", keyword("STOFF", "0.25 0.75")},
      {"STCNOFF", "a.off", keyword("STCNOFF", "0 0 1 255 0 0 255 0.25 0.75")},
      {"coff", "a.off", keyword("coff", "255 128 0"), lower},
      {"name of another format", "a.obj", plain},
      {"no name of a file", "a", plain},
  };
}

std::vector<Variant> bodies() {
  return {
      {"comments: Geomview", "a.off",
       "# made by hand\nOFF # a square\n" + counts + "# places\n" + places + "# faces\n" + faces},
      {"comment after each line", "a.off", replaced(plain, "\n", " # here\n")},
      {"comment between keyword and counts", "a.off", replaced_once(plain, "OFF\n", "OFF\n# a\n\n# b\n")},
      {"blank lines between", "a.off", replaced(plain, "\n", "\n\n")},
      {"blanks before each line", "a.off", around_lines(plain, "  ", "")},
      {"blanks after each line: CGAL", "a.off", around_lines(plain, "", " ")},
      {"two blanks after the count of corners: CGAL", "a.off", replaced(plain, "3 0", "3  0")},
      {"tabs", "a.off", replaced(plain, " ", "\t")},
      {"lines of Windows", "a.off", replaced(plain, "\n", "\r\n")},
      {"lines of the old Mac", "a.off", replaced(plain, "\n", "\r")},
      {"byte order mark", "a.off", "\xEF\xBB\xBF" + plain},
      {"no line end at the end", "a.off", plain.substr(0, plain.size() - 1)},
      {"zero after the text", "a.off", plain + std::string(1, '\0')},
      {"end of file of DOS", "a.off", plain + "\x1A"},
      {"numbers of C", "a.off", replaced_once(replaced_once(plain, "1 1 0", "1.0e+00 1. -0.0"), "0 1 0", ".0 +1 0E-5")},
      {"colour of faces by a number", "a.off", face_colors(" 7", " 3")},
      {"colour of faces, bytes", "a.off", face_colors(" 255 128 0", " 1 2 3")},
      {"colour of faces, bytes with alpha", "a.off", face_colors(" 255 128 0 255", " 1 2 3 4")},
      {"colour of faces, fractions", "a.off", face_colors(" 1.0 0.5 0.0", " 0.1 0.2 0.3")},
      {"colour of faces, fractions with alpha", "a.off", face_colors(" 1.0 0.5 0.0 1.0", " 0.1 0.2 0.3 0.4")},
      {"colour of one face", "a.off", face_colors(" 255 0 0", "")},
      {"colours of faces with an empty last one", "a.off", face_colors(" 255 0 0 ", "  ")},
      {"quads", "a.off", "OFF\n4 1 4\n" + places + "4 0 1 2 3\n"},
      {"a face of two corners",
       "a.off",
       replaced_once(plain, "3 0 2 3", "2 0 2"),
       "faces of fewer than three corners, left out (1)",
       4,
       1,
       {0, 0, 0.5}},
      {"place that no face uses", "a.off",
       replaced_once(replaced_once(plain, "4 2", "5 2"), "3 0 1 2", "nan NAN -nan\n3 0 1 2"),
       "vertices without a place that no face uses, now at the origin (1)", 5},
      {"place that no face uses, as old Visual C++ writes it", "a.off",
       replaced_once(replaced_once(plain, "4 2", "5 2"), "3 0 1 2", "1.#QNAN 0 -1.#IND\n3 0 1 2"),
       "vertices without a place that no face uses, now at the origin (1)", 5},
  };
}

std::vector<Refusal> refusals() {
  const std::string damaged = "The file is damaged or incomplete; export or copy it again.";
  const std::string line = "Correct that line, or export the mesh again.";
  return {
      {"binary: Geomview", "a.off", replaced_once(plain, "OFF", "OFF BINARY"),
       "binary OFF is not supported (line 1). Save it as text OFF, or as PLY."},
      {"four coordinates", "a.off", keyword("4OFF", "1"),
       "vertices with other than 3 coordinates are not supported (line 1). Export the mesh as plain OFF."},
      {"n coordinates", "a.off", "nOFF\n3\n" + counts + places + faces,
       "vertices with other than 3 coordinates are not supported (line 1). Export the mesh as plain OFF."},
      {"normals that the keyword names are missing", "a.off", keyword("NOFF", ""),
       "vertex 0 has a wrong number of values (line 3). " + line},
      {"corners from 1", "a.off", "OFF\n" + counts + places + "3 1 2 3\n3 1 3 4\n",
       "face 1 names vertex 4, but there are 4, from 0 on (line 8). " + damaged},
      {"fewer faces than announced", "a.off", replaced_once(plain, "4 2", "4 3"),
       "the file ends too early, in face 2 of 3 (line 8). It is incomplete; export or copy it again."},
      {"more faces than announced", "a.off", replaced_once(plain, "4 2", "4 1"),
       "there is more data than the header announces (line 8). The header and the data do not belong together; export "
       "the mesh again."},
      {"colour of five numbers", "a.off", face_colors(" 1 2 3 4 5", ""),
       "\"5\" is more than this line should hold (line 7). " + line},
      {"place that a face uses", "a.off", replaced_once(plain, "1 1 0", "1 1 1.#INF"),
       "vertex 2 has a coordinate that is not a finite number (line 5). Remove or repair that vertex in the program "
       "the "
       "file comes from."},
      {"points alone", "a.off", "OFF\n4 0 0\n" + places,
       "holds points but no faces (4 points). Loopmend needs a surface: export the mesh together with its faces."},
  };
}

class ExportersOff : public ExporterTest {};

TEST_F(ExportersOff, KeywordsAndCounts) { expect_read(heads()); }
TEST_F(ExportersOff, LinesAndColors) { expect_read(bodies()); }
TEST_F(ExportersOff, AreRefusedWithTheReason) { expect_refusals(refusals()); }

}  // namespace exporters_off
}  // namespace loopmend
