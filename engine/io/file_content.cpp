// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/file_content.h"

#include "core/error.h"
#include "core/path_text.h"
#include "io/gzip.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

namespace loopmend {

namespace {

[[noreturn]] void fail_open(const std::filesystem::path& path, int reason) {
  if (reason == ENOENT || reason == ENOTDIR) {
    throw ReadError(path, say("there is no such file"), {}, say("Check the spelling and the folder."));
  }
  if (reason == EACCES || reason == EPERM) {
    throw ReadError(path, say("no permission to read this file"), {}, say("Change its permissions, or read a copy."));
  }
  throw ReadError(path, say("cannot be read: %1", std::generic_category().message(reason)), {}, {});
}

/// Before it is opened: to open a pipe would wait for ever.
void require_regular_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(path, error);
  if (!std::filesystem::exists(status)) fail_open(path, error.default_error_condition().value());
  if (std::filesystem::is_directory(status))
    throw ReadError(path, say("is a folder, not a file"), {}, say("Choose a file inside it."));
  if (!std::filesystem::is_regular_file(status))
    throw ReadError(path, say("is not a regular file"), {}, say("Copy its content to a file first."));
}

bool starts_with(std::string_view text, std::string_view prefix) { return text.substr(0, prefix.size()) == prefix; }

bool looks_like_utf16(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (starts_with(bytes, "\xFF\xFE"sv) || starts_with(bytes, "\xFE\xFF"sv)) return true;
  // Without a mark: ASCII text has a zero in every second place.
  const std::size_t count = std::min<std::size_t>(bytes.size() / 2, 32);
  if (count < 4) return false;
  const auto is_text = [](char c) { return (c >= ' ' && c <= '~') || c == '\n' || c == '\r' || c == '\t'; };
  bool low_first = true;
  bool high_first = true;
  for (std::size_t i = 0; i < count; ++i) {
    low_first = low_first && is_text(bytes[2 * i]) && bytes[2 * i + 1] == '\0';
    high_first = high_first && bytes[2 * i] == '\0' && is_text(bytes[2 * i + 1]);
  }
  return low_first || high_first;
}

/// @throws Error for content that is certainly no mesh; the message names the remedy.
void refuse_known_strangers(const FileContent& file) {
  using namespace std::string_view_literals;
  const std::string_view bytes = file.bytes;
  if (starts_with(bytes, "version https://git-lfs.github.com/"sv)) {
    throw ReadError(file.path, say("this is a Git LFS pointer, not the mesh itself"), {},
                    say("Run `git lfs pull` in its repository to fetch the mesh."));
  }
  if (looks_like_utf16(bytes)) {
    throw ReadError(file.path, say("the text is encoded as UTF-16"), say("byte 0"),
                    say("Save it as UTF-8 or plain ASCII."));
  }
}

/// The first token after comments and blank lines; empty if there is none.
std::string_view first_token(std::string_view text) {
  TextCursor cursor(text);
  while (cursor.next_line()) {
    const std::string_view token = cursor.next_token();
    if (!token.empty() && token.front() != '#') return token;
  }
  return {};
}

bool fits_binary_stl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, sizeof count);  // little endian, as every machine we build for
  return bytes.size() == 84 + std::uint64_t{50} * count;
}

bool looks_binary(std::string_view bytes) { return bytes.substr(0, 1024).find('\0') != std::string_view::npos; }

/// "solid" opens every text STL and some binary ones; only the text goes on with words.
bool looks_like_ascii_stl(std::string_view text, std::string_view first) {
  return equals_ignoring_case(first, "solid") && !looks_binary(without_end_mark(text));
}

bool is_off_keyword(std::string_view given) {
  const std::string token = upper_off_keyword(given);
  const std::size_t at = token.find("OFF");
  if (at == std::string_view::npos || at > 5) return false;
  const auto among = [](std::string_view part, std::string_view allowed) {
    return part.find_first_not_of(allowed) == std::string_view::npos;
  };
  // "OFF8" is what a lost line break makes of "OFF" and the number of vertices.
  const std::string_view all = token;
  return among(all.substr(0, at), "STCN4n") && among(all.substr(at + 3), "0123456789");
}

/// XML, perhaps after its declaration, or the legacy format.
bool is_polydata(std::string_view text) {
  return starts_with(text, "# vtk DataFile") || text.substr(0, 1024).find("<VTKFile") != std::string_view::npos;
}

bool is_obj_keyword(std::string_view token) {
  constexpr std::array<std::string_view, 14> words = {"v", "vn", "vt", "vp", "f",      "o",      "g",
                                                      "s", "l",  "p",  "mg", "mtllib", "usemtl", "cstype"};
  return std::find(words.begin(), words.end(), token) != words.end();
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path_text(without_gzip_name(path).extension());
  for (char& c : extension) c = ascii_lower(c);
  return extension;
}

std::string_view mesh_text(const FileContent& file) {
  std::string_view text = file.bytes;
  if (starts_with(text, "\xEF\xBB\xBF")) text.remove_prefix(3);
  return text;
}

FileContent load_bytes(const std::filesystem::path& path) {
  require_regular_file(path);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) fail_open(path, errno);
  // Of what is open: another file may stand there by now.
  const std::streamoff size = stream.seekg(0, std::ios::end).tellg();
  if (size < 0 || !stream.seekg(0)) fail_open(path, errno);

  FileContent file{path, {}};
  file.bytes.resize(static_cast<std::size_t>(size));
  stream.read(file.bytes.data(), static_cast<std::streamsize>(file.bytes.size()));
  if (stream.bad()) fail_open(path, errno);
  file.bytes.resize(static_cast<std::size_t>(stream.gcount()));  // it may have shrunk: judged like any other file
  if (file.bytes.empty())
    throw ReadError(path, say("the file is empty (0 bytes)"), {}, say("Export or copy the mesh again."));
  return file;
}

FileContent load_file(const std::filesystem::path& path) {
  FileContent file = load_bytes(path);
  if (is_gzip(file.bytes) && !fits_binary_stl(file.bytes)) file.bytes = gunzip(path, file.bytes);
  return file;
}

namespace {

[[noreturn]] void refuse_beginning(const FileContent& file, const Message& what) {
  throw ReadError(file.path, what, say("byte 0"), say("The file is damaged or is something else under this name."));
}

/// Of a file whose first word does not tell it.
MeshFormat format_by_extension(const FileContent& file, std::string_view text, std::string_view first) {
  const std::string extension = lower_extension(file.path);
  if (extension == ".stl" && !is_obj_keyword(first)) {
    if (looks_binary(text)) return MeshFormat::stl_binary;
    refuse_beginning(file, say("does not begin with \"solid\" as text STL files do, and is not binary"));
  }
  if (extension == ".off" && !first.empty() && first.find_first_not_of("0123456789") == std::string_view::npos)
    return MeshFormat::off;  // the keyword is optional in this format
  if (extension == ".obj" || is_obj_keyword(first)) return MeshFormat::obj;
  if (extension == ".ply") refuse_beginning(file, say("does not begin with \"ply\" as every PLY file does"));
  if (extension == ".3mf") refuse_beginning(file, say("does not begin as 3MF files do"));
  if (extension == ".glb" || extension == ".gltf") refuse_beginning(file, say("does not begin as glTF files do"));
  if (extension == ".vtp" || extension == ".vtk") refuse_beginning(file, say("does not begin as VTK files do"));
  if (extension == ".off") refuse_beginning(file, say("does not begin with \"OFF\" as OFF files do"));
  throw ReadError(file.path, say("this is not a mesh format that Loopmend knows"), {},
                  say("It reads PLY, STL, OBJ, OFF, glTF and 3MF files, and VTK's polydata."));
}

}  // namespace

MeshFormat detect_format(const FileContent& file) {
  if (fits_binary_stl(file.bytes)) return MeshFormat::stl_binary;  // first: its title may hold anything
  refuse_known_strangers(file);
  const std::string_view text = mesh_text(file);
  if (starts_with(text, "PK\x03\x04")) return MeshFormat::three_mf;
  if (starts_with(text, "glTF")) return MeshFormat::gltf;
  if (is_polydata(text)) return MeshFormat::polydata;
  const std::string_view first = first_token(text.substr(0, 65536));
  if (!first.empty() && first.front() == '{') return MeshFormat::gltf;
  if (first == "ply") return MeshFormat::ply;
  if (looks_like_ascii_stl(text, first)) return MeshFormat::stl_ascii;
  if (is_off_keyword(first)) return MeshFormat::off;
  return format_by_extension(file, text, first);
}

}  // namespace loopmend
