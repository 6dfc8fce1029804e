// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/zip_archive.h"

#include "core/error.h"
#include "io/text_cursor.h"

#include <zip.h>

#include <array>
#include <optional>

namespace loopmend {

namespace {

constexpr std::size_t piece_size = 1 << 16;
/// Text of coordinates is packed to a fifth; deflate packs a thousandfold what is always the same.
constexpr zip_uint64_t most_ratio = 200;
constexpr zip_uint64_t harmless_size = 1 << 24;

std::string_view without_slash(std::string_view name) { return name.substr(0, 1) == "/" ? name.substr(1) : name; }

}  // namespace

struct ZipArchive::State {
  zip_t* zip = nullptr;

  std::optional<zip_uint64_t> find(std::string_view name) const {
    const zip_int64_t index = zip_name_locate(zip, std::string(without_slash(name)).c_str(), ZIP_FL_NOCASE);
    if (index < 0) return {};
    return static_cast<zip_uint64_t>(index);
  }
};

ZipArchive::ZipArchive(const FileContent& file) : file_(file), state_(std::make_unique<State>()) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(file.bytes.data(), file.bytes.size(), 0, &error);
  if (source) state_->zip = zip_open_from_source(source, ZIP_RDONLY, &error);
  if (state_->zip) return;
  const std::string why = zip_error_strerror(&error);
  if (source) zip_source_free(source);
  zip_error_fini(&error);
  throw ReadError(file.path, say("the ZIP archive is damaged or incomplete (%1)", why), {},
                  say("Copy or download it again."));
}

ZipArchive::~ZipArchive() {
  if (state_->zip) zip_discard(state_->zip);
}

bool ZipArchive::has(std::string_view name) const { return state_->find(name).has_value(); }

std::vector<std::string> ZipArchive::names() const {
  std::vector<std::string> result;
  const zip_int64_t count = zip_get_num_entries(state_->zip, 0);
  for (zip_int64_t k = 0; k < count; ++k)
    if (const char* name = zip_get_name(state_->zip, static_cast<zip_uint64_t>(k), 0)) result.emplace_back(name);
  return result;
}

void ZipArchive::read(std::string_view name, const std::function<void(std::string_view)>& piece) const {
  const Message place = say("entry %1", in_quotes(name));
  const auto fail = [&](const Message& problem, const Message& cure) {
    throw ReadError(file_.path, problem, place, cure);
  };
  const std::optional<zip_uint64_t> index = state_->find(name);
  if (!index) fail(say("a part of the archive is missing"), say("The file is incomplete; export or copy it again."));
  struct Closing {
    zip_file_t* file;
    ~Closing() {
      if (file) zip_fclose(file);
    }
  } entry{zip_fopen_index(state_->zip, *index, 0)};
  if (!entry.file)
    fail(say("an entry cannot be unpacked: %1", std::string(zip_strerror(state_->zip))),
         say("Export it without encryption."));
  std::array<char, piece_size> buffer{};
  zip_uint64_t size = 0;
  for (;;) {
    const zip_int64_t count = zip_fread(entry.file, buffer.data(), buffer.size());
    if (count < 0)
      fail(say("an entry is damaged: %1", std::string(zip_file_strerror(entry.file))),
           say("Copy or download it again."));
    if (count == 0) return;
    size += static_cast<zip_uint64_t>(count);
    if (size > harmless_size && size / most_ratio > file_.bytes.size())
      fail(say("an entry becomes more than %1 times as large as the file when it is unpacked", most_ratio),
           say("This is no mesh but a trap; do not open it."));
    piece(std::string_view(buffer.data(), static_cast<std::size_t>(count)));
  }
}

std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& entries) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* target = zip_source_buffer_create(nullptr, 0, 0, &error);
  zip_t* zip = target ? zip_open_from_source(target, ZIP_CREATE | ZIP_TRUNCATE, &error) : nullptr;
  const auto require = [](bool holds) {
    if (!holds) throw Error(say("the archive cannot be written: libzip failed"));
  };
  require(zip != nullptr);
  zip_source_keep(target);
  bool fine = true;
  for (const auto& [name, content] : entries) {
    zip_source_t* source = zip_source_buffer(zip, content.data(), content.size(), 0);
    const zip_int64_t index = zip_file_add(zip, name.c_str(), source, ZIP_FL_ENC_UTF_8);
    if (index < 0 && source) zip_source_free(source);
    constexpr zip_uint16_t no_time = 0, first_day = 0x21;  // 1 January 1980
    fine =
        fine && index >= 0 && zip_file_set_dostime(zip, static_cast<zip_uint64_t>(index), no_time, first_day, 0) == 0;
  }
  if (!fine || zip_close(zip) != 0) {
    zip_discard(zip);
    zip_source_free(target);
    require(false);
  }
  std::string bytes;
  zip_stat_t status;
  fine = zip_source_stat(target, &status) == 0 && (status.valid & ZIP_STAT_SIZE) != 0 && zip_source_open(target) == 0;
  if (fine) {
    bytes.resize(static_cast<std::size_t>(status.size));
    fine = zip_source_read(target, bytes.data(), bytes.size()) == static_cast<zip_int64_t>(bytes.size());
    zip_source_close(target);
  }
  zip_source_free(target);
  require(fine);
  return bytes;
}

}  // namespace loopmend
