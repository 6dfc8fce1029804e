// SPDX-License-Identifier: GPL-3.0-or-later
// As engine_messages.h, of files: "PATH: PROBLEM (PLACE). CURE", without the path and the colon.
#pragma once

namespace loopmend::test {

inline constexpr const char* file_messages[] = {
    // io/file_content.cpp, gzip.cpp, read_mesh.cpp
    "there is no such file. Check the spelling and the folder.",
    "no permission to read this file. Change its permissions, or read a copy.",
    "cannot be read: Input/output error.",
    "is a folder, not a file. Choose a file inside it.",
    "is not a regular file. Copy its content to a file first.",
    "this is a Git LFS pointer, not the mesh itself. Run `git lfs pull` in its repository to fetch the mesh.",
    "the text is encoded as UTF-16 (byte 0). Save it as UTF-8 or plain ASCII.",
    "the file is empty (0 bytes). Export or copy the mesh again.",
    "does not begin with \"solid\" as text STL files do, and is not binary (byte 0). The file is damaged or is "
    "something else "
    "under this name.",
    "does not begin with \"ply\" as every PLY file does (byte 0). The file is damaged or is something else under this "
    "name.",
    "does not begin with \"OFF\" as OFF files do (byte 0). The file is damaged or is something else under this name.",
    "does not begin as 3MF files do (byte 0). The file is damaged or is something else under this name.",
    "this is not a mesh format that Loopmend knows. It reads PLY, STL, OBJ, OFF, glTF and 3MF files.",
    "holds no points and no faces. Loopmend needs a surface: export the mesh together with its faces.",
    "holds points but no faces (812 points). Loopmend needs a surface: export the mesh together with its faces.",
    "more than 715827882 triangles. Reduce it first.",
    "the mesh is too large for the memory of this computer. Close other programs, or reduce it.",
    "the mesh is too large for this program. Reduce it first.",
    "the compressed file is damaged (byte 4711). Copy or compress it again.",
    "the compressed file is incomplete (byte 4711). Copy or compress it again.",
    "something else follows the compressed mesh (byte 4711). Copy or compress it again.",
    "the unpacked mesh would take more than half of this computer's memory. Reduce it first.",
    // io/parse_errors.cpp and what the readers of text give it
    "vertex 3 has a coordinate that is not a finite number (line 5). Remove or repair that vertex in the program the "
    "file "
    "comes from.",
    "face 3 names vertex 9, but there are 8, from 0 on (line 5). The file is damaged or incomplete; export or copy it "
    "again.",
    "face 3 names vertex -9, but there are 8 before it (line 5). The file is damaged or incomplete; export or copy it "
    "again.",
    "face 3 names vertex 0, but OBJ counts from 1 (line 5). The file is damaged or incomplete; export or copy it "
    "again.",
    "face 3 names vertex 9, but there are 8 (line 5). The file is damaged or incomplete; export or copy it again.",
    "a coordinate is missing (line 5). The file is damaged or incomplete; export or copy it again.",
    "\"1,5\" stands where a coordinate should be (line 5). Numbers are written with a point, not a comma.",
    "\"abc\" stands where a vertex index should be (line 5). Correct that place, or export the mesh again.",
    "\"abc\" stands where a count of elements should be (line 5). Correct that place, or export the mesh again.",
    "\"abc\" stands where the number of vertices should be (line 1). Correct that place, or export the mesh again.",
    "\"abc\" stands where the number of faces should be (line 1). Correct that place, or export the mesh again.",
    "\"abc\" stands where \"facet\" or \"endsolid\" should be (line 5). Correct that place, or export the mesh again.",
    "the file ends too early, in vertex 7 of 20 (line 9). It is incomplete; export or copy it again.",
    "the file ends too early, in face 7 of 20 (line 9). It is incomplete; export or copy it again.",
    "\"abc\" stands where a number should be (line 5). Correct that place, or export the mesh again.",
    "\"abc\" stands where a whole number should be (line 5). Correct that place, or export the mesh again.",
    "\"abc\" stands where a colour should be (line 5). Correct that place, or export the mesh again.",
    "\"abc\" stands where the number of edges should be (line 1). Correct that place, or export the mesh again.",
    "\"abc\" stands where the number of a face's corners should be (line 5). Correct that place, or export the mesh "
    "again.",
    "the file ends too early, in a list of 3 items (line 9). It is incomplete; export or copy it again.",
    "the file ends too early, in facet 7 (line 9). It is incomplete; export or copy it again.",
    "the file ends too early, in the header: there is no \"end_header\" (line 9). It is incomplete; export or copy it "
    "again.",
    "the file ends too early, in the header of a binary STL file (byte 60). It is incomplete; export or copy it again.",
    "announces 900000 vertices, more than a file of 120 bytes can hold (line 3). The file is damaged or incomplete; "
    "export "
    "or copy it again.",
    "announces 900000 faces, more than a file of 120 bytes can hold (line 3). The file is damaged or incomplete; "
    "export or "
    "copy it again.",
    "announces 900000 rows of \"strip\", more than a file of 120 bytes can hold (line 3). The file is damaged or "
    "incomplete; "
    "export or copy it again.",
    "announces 12 triangles, which take 684 bytes, but the file has 600 (byte 80). It is incomplete or damaged; export "
    "or "
    "copy it again.",
    "announces 12 triangles, but 40 more bytes follow them (byte 80). The count and the data do not belong together; "
    "export "
    "the mesh again.",
    "there is more data than the header announces (line 30). The header and the data do not belong together; export "
    "the mesh "
    "again.",
    "more than 2147483647 vertices (line 3). The file is damaged or incomplete; export or copy it again.",
    "vertex 3 does not have 3 coordinates (or 6 with a colour) (line 5). Correct that line, or export the mesh again.",
    "vertex 3 has a wrong number of values (line 5). Correct that line, or export the mesh again.",
    "\"7\" is more than this line should hold (line 5). Correct that line, or export the mesh again.",
    "\"abc\" is not a statement of an OBJ file (line 5). The file is damaged or is something else under this name.",
    "\"abc\" is not a word of a PLY header (line 5). The file is damaged or is something else under this name.",
    "unknown PLY format \"abc\" (line 2).",
    "unknown PLY version \"2.0\" (line 2).",
    "unknown PLY type \"abc\" (line 4).",
    "a second format line (line 3).",
    "a second element \"vertex\" (line 3).",
    "a second property \"x\" (line 3).",
    "a property before any element (line 3).",
    "a property without a name (line 3).",
    "a list counted by a fraction (line 3).",
    "the header has no format line (line 9).",
    "the header announces no element \"vertex\". This PLY file holds something else than a mesh.",
    "the vertices have no coordinates x, y and z (line 3). Export the mesh with vertex positions.",
    "the faces' vertex indices are not a list of whole numbers (line 7).",
    "the faces have no list vertex_indices (line 7). Export the mesh with polygon faces.",
    "binary OFF is not supported (line 1). Save it as text OFF, or as PLY.",
    "vertices with other than 3 coordinates are not supported (line 1). Export the mesh as plain OFF.",
    // io/gltf_document.cpp, gltf_nodes.cpp, gltf_materials.cpp, parse_gltf.cpp
    "version \"1.0\" of glTF (asset). Loopmend reads glTF 2; export it again as such.",
    "version 1 of GLB (byte 4). Loopmend reads version 2; export it again as such.",
    "the JSON text is nested more than 64 deep.",
    "the JSON text of this glTF file is damaged (byte 12 of the text).",
    "the JSON text of this glTF file is no object.",
    "a number in the JSON text of this glTF file is too large.",
    "\"asset\" is missing, which every glTF file has.",
    "the file ends too early, in the header of the GLB file. It is incomplete; export or copy it again.",
    "the file ends too early, in a GLB file of 900 bytes (byte 600). It is incomplete; export or copy it again.",
    "chunk 1 says 900 bytes, but there are 600 (byte 20).",
    "the first chunk of the GLB file is no JSON (byte 12).",
    "the GLB file has no JSON chunk (byte 12).",
    "the mesh is compressed with \"KHR_draco_mesh_compression\", which Loopmend does not know (extensionsRequired). "
    "Export it "
    "without mesh compression.",
    "needs the extension \"EXT_x\", which Loopmend does not know (extensionsRequired). Export it without.",
    "\"nodes\" is no array (scene 0).",
    "\"mesh\" is no whole number from 0 on (node 4).",
    "names element 9 of \"accessors\", but there are 3, from 0 on (mesh 0, primitive 1).",
    "element 2 of \"nodes\" is no object (node 1).",
    "something else stands where a number should be (node 1).",
    "\"byteLength\" is missing (buffer 0).",
    "the buffer \"a.bin\" cannot be read (buffer 0). Put the buffer beside the file, "
    "or export one .glb file.",
    "\"../a.bin\" is outside the folder of the file, where nothing is read (buffer 0). Put the buffer beside the file, "
    "or "
    "export one .glb file.",
    "has neither a \"uri\" nor a binary chunk (buffer 0). If the mesh is compressed, export it without compression.",
    "announces 900 bytes, but there are 600 (buffer 0).",
    "bytes 12 to 90 of a buffer of 60 (buffer view 1).",
    "\"count\" or \"componentType\" is missing (accessor 1).",
    "\"buffer\" or \"byteLength\" is missing (buffer view 1).",
    "\"count\", \"indices\" or \"values\" is missing (accessor 1, sparse).",
    "has no data (accessor 1). If the mesh is compressed (Draco, meshopt), export it without compression.",
    "is of an unknown type (accessor 1).",
    "its elements of 12 bytes stand 4 bytes apart (accessor 1).",
    "announces 900 (at byte 12 of 60) elements, more than a file of 600 bytes can hold (accessor 1).",
    "its indices are no unsigned numbers (accessor 1, sparse).",
    "replaces element 9, but there are 3, from 0 on (accessor 1, sparse).",
    "the data URI is not of base64 (buffer 0).",
    "the data URI is damaged (buffer 0).",
    "names a node that is not there, 12 (scene 0).",
    "the nodes go round in circles (nodes).",
    "is reached twice: the nodes of glTF are a tree (node 1).",
    "\"matrix\" has 12 numbers (node 1).",
    "\"rotation\" is none (node 1).",
    "the transforms of its nodes are too large (mesh 0).",
    "is no object (mesh 0, primitive 1).",
    "\"pbrMetallicRoughness\" is no object (material 2).",
    "a picture is no object (picture 0).",
    "has the unknown mode 9 (mesh 0, primitive 1).",
    "has no POSITION (mesh 0, primitive 1).",
    "NORMAL has 2 numbers each (mesh 0, primitive 1).",
    "NORMAL has 9 elements for 8 positions (mesh 0, primitive 1).",
    "7 corners, which are not three for each triangle (mesh 0, primitive 1).",
    "the same triangles are shown again and again, in all more than 900000 (mesh 0, primitive 1). Export it with fewer "
    "instances.",
    // io/package_model.cpp, parse_3mf.cpp, xml_events.cpp, zip_archive.cpp
    "the XML is damaged: 42 (line 12 of 3D/3dmodel.model). The file is damaged or incomplete; export or copy it again.",
    "the XML is nested more than 64 deep (line 12 of a.model).",
    "the XML has a document type, which 3MF forbids (line 1 of a.model).",
    "an element of the XML has no end (line 1 of a.model).",
    "the part holds no model (line 1 of a.model).",
    "\"objectid\" is missing (line 1 of a.model).",
    "\"abc\" stands where \"id\" should be (line 1 of a.model).",
    "a material stands outside \"basematerials\" (line 1 of a.model).",
    "a colour stands outside \"colorgroup\" (line 1 of a.model).",
    "\"abc\" is no colour (line 1 of a.model).",
    "\"abc\" is no unit of 3MF (line 1 of a.model).",
    "there are two objects 3 (line 1 of a.model).",
    "a vertex, triangle or component stands outside an object (line 1 of a.model).",
    "\"abc\" stands where a number of a transform should be (line 1 of a.model).",
    "a transform has 11 numbers, not 12 (line 1 of a.model).",
    "its parts have different units, inch and meter (a.model). Export it again.",
    "objects are made of one another more than 64 deep (object 3 of a.model).",
    "more than 100000 objects (object 3 of a.model). Export it with fewer copies.",
    "names an object that is not there (object 3 of a.model).",
    "the same triangles are there again and again, in all more than 900000 (object 3 of a.model). Export it with fewer "
    "copies.",
    "names member 4 of property group 1, which has 3 (object 3 of a.model).",
    "this is a ZIP archive without a 3MF model, not a mesh file (byte 0). Unpack it, and open what is in it.",
    "the ZIP archive is damaged or incomplete (42). Copy or download it again.",
    "a part of the archive is missing (entry \"a\"). The file is incomplete; export or copy it again.",
    "an entry cannot be unpacked: 42 (entry \"a\"). Export it without encryption.",
    "an entry is damaged: 42 (entry \"a\"). Copy or download it again.",
    "an entry becomes more than 1000 times as large as the file when it is unpacked (entry \"a\"). This is no mesh but "
    "a "
    "trap; do not open it.",
    // io/picture_file.cpp, appearance/scan_colors.cpp, export/write_scan.cpp
    "a picture of 20000 by 20000 pixels. Save the picture again as PNG or JPEG.",
    "the picture is damaged: 42. Save the picture again as PNG or JPEG.",
    "the picture cannot be read: it is larger than 16384 pixels a side. Save the picture again as PNG or JPEG.",
    "this is neither PNG nor JPEG. Save the picture again as PNG or JPEG.",
    "The picture 2 of the scan cannot be used: there are no data.",
    "The picture 2 of the scan cannot be used: \"x:y\" is not beside the file.",
    "The picture 2 of the scan cannot be used: \"x:y\" names no file.",
    "A picture of the scan's texture cannot be used: /tmp/a.png: this is neither PNG nor JPEG. Save the picture again "
    "as PNG "
    "or JPEG.",
    "The scan's material file cannot be used: /tmp/a.mtl: there is no such file. Check the spelling and the folder.",
    "The file ../a.png is outside the scan's folder and was not copied.",
    "The file a.png cannot be read and was not copied.",
    "The picture a.png is not there, and not in the output.",
    "12 new triangles have no texture: their patch cannot be laid out in a plane, or the picture would be too large.",
    "another file of this name is there already, which the scan's a.png would replace. Choose another folder for the "
    "output, "
    "or --materials reference.",
    // io/atomic_file.cpp, write_mesh.cpp, write_gltf.cpp, write_3mf.cpp
    "cannot be written: No space left on device. Make room on the disk, or choose another place.",
    "cannot be written: File too large. The file would be larger than is allowed here; choose another place.",
    "cannot be written in this folder: Permission denied. Choose a folder in which you may write.",
    "cannot be written in this folder: Read-only file system. This disk can only be read; choose another place.",
    "cannot be written: No such file or directory. Create the folder first, or choose another one.",
    "cannot be written: Not a directory. Create the folder first, or choose another one.",
    "cannot be written: File name too long. Choose a shorter name.",
    "cannot be replaced: Input/output error. Choose another place.",
    "the file is write-protected: Permission denied. Save under another name.",
    "is a folder, not a file. Choose a file name inside it.",
    "is not a regular file. Choose another name.",
    "is not a file name. Choose a file name.",
    "cannot be made a folder: a file is there. Choose another name.",
    "the coordinates are too large for binary STL. Save as PLY, or scale the mesh down.",
    "the coordinates are too large for glTF. Save as PLY, or scale the mesh down.",
    "the mesh takes more than the 4 GB of a GLB file. Save as PLY.",
    "the name has no extension. Choose a name that ends in .ply, .stl, .obj, .off, .glb, .gltf or .3mf, compressed "
    ".ply.gz and "
    "so on.",
    "unknown format \".abc\". Choose a name that ends in .ply, .stl, .obj, .off, .glb, .gltf or .3mf, compressed "
    ".ply.gz and "
    "so on.",
    "the archive cannot be written: libzip failed",
    "the picture cannot be written: 42",
    "this machine could not draw a picture of 20000x20000 pixels. Try a smaller --size.",
    // document/session.cpp, packed_session.cpp, jobs/fill_controller_files.cpp
    "this is not a session of Loopmend. Choose a file that Loopmend saved.",
    "this session is of another version of Loopmend. Open it with the version that saved it.",
    "a patch belongs to no scan. Open the scan itself instead; the session file is damaged.",
    "the loops of a patch are not complete. Open the scan itself instead; the session file is damaged.",
    "a unit of length is not known. Open the scan itself instead; the session file is damaged.",
    "there is more in the file than there should be. Open the scan itself instead; the session file is damaged.",
    "the file ends too early. Open the scan itself instead; the session file is damaged.",
    "the number of scans is out of range. Open the scan itself instead; the session file is damaged.",
    "the scan in the session cannot be unpacked. Open the scan itself instead; the session file is damaged.",
    "a patch belongs to a hole that does not exist. Open the scan itself instead; the session file is damaged.",
    "a patch names a vertex that its scan does not have. Open the scan itself instead; the session file is damaged.",
    "this file has changed since the session was saved. Put the old file back to restore the session, or open the new "
    "one by "
    "itself.",
    "cannot be written. Make room for temporary files.",
    "a.gltf has its numbers in files beside it: export it as GLB, or save the session without scans",
    "a.ply is larger than 1 GB: save the session without scans, and keep the file beside it",
    "x. Check the path and its permissions.",
    // count_not_kept(), whose list labels::not_kept() writes
    "primitives of points and lines",
    "primitives with morph targets",
    "vertex attributes \"_A\"",
    "further colours at one place",
    "further colours at one vertex",
    "transforms of nodes, which are applied",
    "transforms of objects, which are applied",
    "meshes that the scene does not show",
    "pictures of materials",
    "pictures of materials at further texture coordinates",
    "keyword in lower case",
    "strip properties \"x\"",
    "face properties \"x\"",
    "elements \"x\"",
    "textures of 3MF",
    "mixed materials",
    "beam lattices",
    "metadata",
    "unit (inch)",
    "vertices without a place that no face uses, now at the origin",
    "remarks between the facets",
    "words after \"endloop\" or \"endfacet\"",
    "count of triangles that is 0: taken from the file's size",
    "bytes after the last triangle, left out",
    "no build: every object is taken",
    "faces with properties of other kinds",
    "further parts of the archive",
    "comments that begin with //",
    "unknown statements",
    "texture coordinates that are no numbers",
    "normals that are no numbers",
    "numbers of texture coordinates that are not there",
    "numbers of normals that are not there",
    "points in parameter space",
    "free-form curves and surfaces",
    "faces of fewer than three corners, left out",
};

}  // namespace loopmend::test
