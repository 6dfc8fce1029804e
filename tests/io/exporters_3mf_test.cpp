// SPDX-License-Identifier: GPL-3.0-or-later
// 3MF as slicers and CAD programs write it.
#include "exporter_variants.h"
#include "io/zip_archive.h"

#include <gmock/gmock.h>
#include <zlib.h>

#include <cstdint>
#include <utility>

namespace loopmend {
namespace exporters_3mf {

using Entries = std::vector<std::pair<std::string, std::string>>;

const std::string xml = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n";
const std::string core = "http://schemas.microsoft.com/3dmanufacturing/core/2015/02";
const std::string types = xml +
                          "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\"><Default "
                          "Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/>"
                          "</Types>";
const std::string relations =
    xml +
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\"><Relationship "
    "Target=\"/3D/3dmodel.model\" Id=\"rel0\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/>"
    "</Relationships>";
const std::string mesh =
    "<mesh><vertices><vertex x=\"0\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"0\" z=\"0\"/><vertex x=\"1\" y=\"1\" "
    "z=\"0\"/>"
    "<vertex x=\"0\" y=\"1\" z=\"0\"/></vertices><triangles><triangle v1=\"0\" v2=\"1\" v3=\"2\"/><triangle v1=\"0\" "
    "v2=\"2\" v3=\"3\"/></triangles></mesh>";
const std::string object = "<object id=\"1\" type=\"model\">" + mesh + "</object>";
const std::string item = "<item objectid=\"1\"/>";

std::string model(const std::string& resources = object, const std::string& build = item,
                  const std::string& attributes = "unit=\"millimeter\" xml:lang=\"en-US\"") {
  return xml + "<model " + attributes + " xmlns=\"" + core + "\"><resources>" + resources + "</resources><build>" +
         build + "</build></model>";
}

/// The archive as zip_archive makes it, deflated.
std::string package(const std::string& text, const Entries& more = {}) {
  Entries entries = {{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", text}};
  entries.insert(entries.end(), more.begin(), more.end());
  return zip_archive(entries);
}

enum class Sizes { before, after };

/// An archive whose entries are stored as they are, with their size before them or after.
std::string stored(const Entries& entries, Sizes sizes) {
  std::string bytes, directory;
  const auto put = [](std::string& to, std::uint32_t value, int size) {
    for (int k = 0; k < size; ++k) to += static_cast<char>(value >> (8 * k));
  };
  for (const auto& [name, content] : entries) {
    const auto sum = static_cast<std::uint32_t>(
        ::crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(content.size())));
    const auto size = static_cast<std::uint32_t>(content.size());
    const auto fields = [&, name_size = static_cast<std::uint32_t>(name.size())](std::string& to, bool is_known) {
      put(to, 20, 2);                             // version
      put(to, sizes == Sizes::after ? 8 : 0, 2);  // flags
      put(to, 0, 2);                              // stored
      put(to, 0x00210000, 4);                     // time
      for (const std::uint32_t x : {sum, size, size}) put(to, is_known ? x : 0, 4);
      put(to, name_size, 2);
      put(to, 0, 2);
    };
    const auto at = static_cast<std::uint32_t>(bytes.size());
    bytes += "PK\x03\x04";
    fields(bytes, sizes == Sizes::before);
    bytes += name + content;
    if (sizes == Sizes::after) {
      bytes += "PK\x07\x08";
      for (const std::uint32_t x : {sum, size, size}) put(bytes, x, 4);
    }
    directory += "PK\x01\x02";
    put(directory, 20, 2);
    fields(directory, true);
    for (const int width : {2, 2, 2, 4}) put(directory, 0, width);
    put(directory, at, 4);
    directory += name;
  }
  const auto count = static_cast<std::uint32_t>(entries.size());
  std::string end = "PK\x05\x06";
  for (const std::uint32_t x : {0U, 0U, count, count}) put(end, x, 2);
  put(end, static_cast<std::uint32_t>(directory.size()), 4);
  put(end, static_cast<std::uint32_t>(bytes.size()), 4);
  put(end, 0, 2);
  return bytes + directory + end;
}

/// Every element of the model with a prefix.
std::string prefixed(std::string text, const std::string& prefix) {
  text = replaced(replaced(text, "<", "<" + prefix + ":"), "<" + prefix + ":/", "</" + prefix + ":");
  return replaced(replaced(text, "<" + prefix + ":?", "<?"), "xmlns=", "xmlns:" + prefix + "=");
}

std::vector<Variant> archives() {
  const Entries entries = {{"[Content_Types].xml", types}, {"_rels/.rels", relations}, {"3D/3dmodel.model", model()}};
  const Entries production = {{"3D/Objects/part.model", model("<object id=\"7\">" + mesh + "</object>", "")}};
  return {
      {"plain", "a.3mf", package(model())},
      {"stored", "a.3mf", stored(entries, Sizes::before)},
      {"stored, sizes after the entries: streaming writers", "a.3mf", stored(entries, Sizes::after)},
      {"the model first", "a.3mf", zip_archive({entries[2], entries[1], entries[0]})},
      {"no relations", "a.3mf", zip_archive({entries[0], entries[2]})},
      {"no content types", "a.3mf", zip_archive({entries[1], entries[2]})},
      {"the model under another name", "a.3mf",
       zip_archive({{"_rels/.rels", replaced_once(relations, "3dmodel.model", "My Part.model")},
                    {"3D/My Part.model", model()}})},
      {"target without the slash", "a.3mf",
       zip_archive({{"_rels/.rels", replaced_once(relations, "/3D", "3D")}, entries[2]})},
      {"name in other letters", "a.3mf", zip_archive({entries[1], {"3d/3DModel.model", model()}})},
      {"folders, picture, settings of a slicer", "a.3mf",
       package(model(), {{"Metadata/thumbnail.png", "no png"}, {"Metadata/Slic3r_PE.config", "; a = 1"}, {"3D/", ""}})},
      {"thumbnail in the relations", "a.3mf",
       zip_archive({{"_rels/.rels", replaced_once(relations, "<Relationship Target",
                                                  "<Relationship Target=\"/Metadata/thumbnail.png\" Id=\"r1\" "
                                                  "Type=\"http://schemas.openxmlformats.org/package/2006/relationships/"
                                                  "metadata/thumbnail\"/><Relationship Target")},
                    entries[2]})},
      {"production: Bambu Studio", "a.3mf",
       package(
           xml + "<model unit=\"millimeter\" xmlns=\"" + core +
               "\" xmlns:p=\"http://schemas.microsoft.com/3dmanufacturing/production/2015/06\" "
               "requiredextensions=\"p\"><resources><object id=\"1\" p:UUID=\"00000001\" type=\"model\"><components>"
               "<component p:path=\"/3D/Objects/part.model\" objectid=\"7\" p:UUID=\"2\" transform=\"1 0 0 0 1 0 0 "
               "0 1 5 5 5\"/></components></object></resources><build p:UUID=\"3\"><item objectid=\"1\" "
               "p:UUID=\"4\" printable=\"1\"/></build></model>",
           production)},
      {"name of another format", "a.zip", package(model())},
      {"no name of a file", "a", package(model())},
  };
}

std::vector<Variant> models() {
  const std::string other = replaced_once(object, "id=\"1\"", "id=\"2\"");
  const auto units = [](const std::string& unit) { return package(model(object, item, "unit=\"" + unit + "\"")); };
  const std::string moved = "<item objectid=\"1\" transform=\"2 0 0 0 2 0 0 0 2 10 20 30\"/>";
  return {
      {"micron", "a.3mf", units("micron")},
      {"inch", "a.3mf", units("inch")},
      {"no unit", "a.3mf", package(model(object, item, ""))},
      {"prefix of the core namespace", "a.3mf", package(prefixed(model(), "m"))},
      {"two prefixes of slicers", "a.3mf",
       package(model(object, item,
                     "unit=\"millimeter\" xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\" "
                     "xmlns:BambuStudio=\"http://schemas.bambulab.com/package/2021\""))},
      {"indented", "a.3mf", package(replaced(model(), "><", ">\n   <"))},
      {"lines of Windows, tabs", "a.3mf", package(replaced(model(), "><", ">\r\n\t<"))},
      {"byte order mark", "a.3mf", package("\xEF\xBB\xBF" + model())},
      {"no XML declaration", "a.3mf", package(model().substr(xml.size()))},
      {"comments and apostrophes", "a.3mf",
       package(replaced_once(replaced(model(), "\"", "'"), "<build>", "<!-- here --><build>"))},
      {"elements with an end of their own", "a.3mf",
       package(replaced(replaced(model(), "z=\"0\"/>", "z=\"0\"></vertex>"), "<triangles>", "<triangles >"))},
      {"exponents", "a.3mf", package(replaced(model(), "x=\"1\"", "x=\"1.0E+00\""))},
      {"metadata", "a.3mf",
       package(replaced_once(model(), "<resources>",
                             "<metadata name=\"Title\">a &amp; b</metadata><metadata name=\"Application\">x</metadata>"
                             "<metadata name=\"slic3rpe:Version3mf\" type=\"xs:string\">1</metadata><resources>"))},
      {"metadata of objects and items", "a.3mf",
       package(model(
           replaced_once(object, "<mesh>", "<metadatagroup><metadata name=\"a\">b</metadata></metadatagroup><mesh>"),
           "<item objectid=\"1\" partnumber=\"p\"/>"))},
      {"name, part number, thumbnail", "a.3mf",
       package(model(replaced_once(object, "id", "name=\"A &lt;b&gt;\" partnumber=\"3\" thumbnail=\"/t.png\" id")))},
      {"an item that is moved and scaled", "a.3mf", package(model(object, moved)), "", 4, 2, {0, 0, 4}},
      {"an item that is mirrored", "a.3mf",
       package(model(object, "<item objectid=\"1\" transform=\"-1 0 0 0 1 0 0 0 1 0 0 0\"/>"))},
      {"two items of one object", "a.3mf", package(model(object, item + moved)), "", 8, 4, {0, 0, 5}},
      {"several objects",
       "a.3mf",
       package(model(object + other, item + "<item objectid=\"2\"/>")),
       "",
       8,
       4,
       {0, 0, 2}},
      {"an object that no item names", "a.3mf", package(model(object + other))},
      {"components",
       "a.3mf",
       package(model(object + "<object id=\"9\"><components><component objectid=\"1\"/><component objectid=\"1\" "
                              "transform=\"1 0 0 0 1 0 0 0 1 3 0 0\"/></components></object>",
                     "<item objectid=\"9\"/>")),
       "",
       8,
       4,
       {0, 0, 2}},
      {"components of components",
       "a.3mf",
       package(model(object +
                         "<object id=\"8\"><components><component objectid=\"1\" transform=\"2 0 0 0 1 0 0 0 1 0 0 "
                         "0\"/></components></object><object id=\"9\"><components><component objectid=\"8\" "
                         "transform=\"1 0 0 0 3 0 0 0 1 0 0 0\"/></components></object>",
                     "<item objectid=\"9\"/>")),
       "",
       4,
       2,
       {0, 0, 6}},
      {"no build", "a.3mf", package(replaced_once(model(), "<build>" + item + "</build>", "")),
       "no build: every object is taken (1)"},
      {"an empty build", "a.3mf", package(model(object, "")), "no build: every object is taken (1)"},
      {"materials", "a.3mf",
       package(model("<basematerials id=\"5\"><base name=\"PLA\" displaycolor=\"#FF8000\"/><base name=\"\" "
                     "displaycolor=\"#00000080\"/></basematerials>" +
                     replaced_once(replaced_once(object, "id=\"1\"", "id=\"1\" pid=\"5\" pindex=\"0\""), "v3=\"2\"",
                                   "v3=\"2\" pid=\"5\" p1=\"1\"")))},
      {"material without a colour", "a.3mf",
       package(model("<basematerials id=\"5\"><base name=\"PLA\"/></basematerials>" + object))},
      {"colours of corners", "a.3mf",
       package(model(
           "<m:colorgroup id=\"5\"><m:color color=\"#FF0000\"/><m:color color=\"#00ff00ff\"/></m:colorgroup>" +
               replaced_once(object, "v3=\"2\"", "v3=\"2\" pid=\"5\" p1=\"0\" p2=\"1\" p3=\"0\""),
           item, "unit=\"millimeter\" xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\""))},
      {"painting of a slicer", "a.3mf",
       package(replaced_once(
           model(object, item, "unit=\"millimeter\" xmlns:slic3rpe=\"http://schemas.slic3r.org/3mf/2017/06\""),
           "v3=\"2\"", "v3=\"2\" slic3rpe:custom_supports=\"4\" paint_color=\"8\""))},
      {"a support beside the part", "a.3mf", package(model(object + replaced_once(other, "\"model\"", "\"support\"")))},
  };
}

std::vector<Refusal> refusals() {
  const std::string damaged = "The file is damaged or incomplete; export or copy it again.";
  return {
      {"another archive", "a.3mf", zip_archive({{"readme.txt", "hello"}}),
       "this is a ZIP archive without a 3MF model, not a mesh file (byte 0). Unpack it, and open what is in it."},
      {"an extension that must be known", "a.3mf",
       package(model(object, item, "xmlns:b=\"http://schemas.example.org/beams\" requiredextensions=\"b\"")),
       "needs the extension \"http://schemas.example.org/beams\", which Loopmend does not know (line 2 of "
       "3d/3dmodel.model). "
       "Export it without."},
      {"an item of no object", "a.3mf", package(model(object, "<item objectid=\"3\"/>")),
       "names an object that is not there (object 3 of 3d/3dmodel.model). " + damaged},
      {"a vertex that is not there", "a.3mf", package(replaced_once(model(), "v3=\"2\"", "v3=\"4\"")),
       "face 0 names vertex 4, but there are 4, from 0 on (line 2 of 3d/3dmodel.model). " + damaged},
      {"decimal commas", "a.3mf", package(replaced_once(model(), "x=\"1\"", "x=\"1,0\"")),
       "\"1,0\" stands where a coordinate should be (line 2 of 3d/3dmodel.model). " + damaged},
      {"place that is none", "a.3mf", package(replaced_once(model(), "x=\"1\"", "x=\"NaN\"")),
       "\"NaN\" stands where a coordinate should be (line 2 of 3d/3dmodel.model). " + damaged},
      {"no triangles", "a.3mf", package(model("<object id=\"1\"><mesh><vertices/><triangles/></mesh></object>")),
       "holds no points and no faces. Loopmend needs a surface: export the mesh together with its faces."},
      {"a unit of its own", "a.3mf", package(model(object, item, "unit=\"mm\"")),
       "\"mm\" is no unit of 3MF (line 2 of 3d/3dmodel.model). " + damaged},
      {"an object of itself", "a.3mf",
       package(model("<object id=\"1\"><components><component objectid=\"1\"/></components></object>")),
       "objects are made of one another more than 64 deep (object 1 of 3d/3dmodel.model). " + damaged},
  };
}

class Exporters3mf : public ExporterTest {};

TEST_F(Exporters3mf, Archives) { expect_read(archives()); }
TEST_F(Exporters3mf, Models) { expect_read(models()); }
TEST_F(Exporters3mf, AreRefusedWithTheReason) { expect_refusals(refusals()); }

/// The reason between is libzip's, and differs from one version to the next.
TEST_F(Exporters3mf, AreRefusedWhereTheyAreCutOff) {
  const std::string whole = package(model());
  try {
    read(whole.substr(0, whole.size() / 2), "a.3mf");
    ADD_FAILURE() << "was read";
  } catch (const ReadError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("the ZIP archive is damaged or incomplete ("));
    EXPECT_THAT(error.what(), testing::EndsWith("). Copy or download it again."));
  }
}

}  // namespace exporters_3mf
}  // namespace loopmend
