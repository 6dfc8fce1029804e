// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/atomic_file.h"

#include "core/error.h"
#include "core/path_text.h"
#include "io/system_files.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <random>
#include <streambuf>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace loopmend {

namespace {

/// Paths of temporary files and of what became of them, where an exit path can read them without a lock and without
/// memory of its own.
constexpr std::size_t longest_path = 4096;

struct KnownFile {
  enum State : int {
    unused,
    being_named,
    unfinished,  ///< the temporary file may be there, the target is as it was
    in_transit,  ///< is being renamed: whether the temporary file is still there shows how far that got
    in_place,    ///< stands under its target's name
    folder       ///< `path` is a new folder, wanted for a file that does not stand in it yet
  };
  std::atomic<int> state{unused};
  std::array<char, longest_path> path{};
  std::array<char, longest_path> target{};
};

// The one global of the engine: a signal cannot be handed an argument. Only pages in use take memory.
std::array<KnownFile, 128> known_files;
static_assert(std::atomic<int>::is_always_lock_free);

/// Keeps one path in the list while it lives, if need be in place of a file that is written. With a path too long, or all others
/// unfinished, it does nothing.
class Registration {
 public:
  Registration(const std::string& path, const std::string& target, KnownFile::State state = KnownFile::unfinished) {
    if (path.size() >= longest_path || target.size() >= longest_path) return;
    file_ = taken(KnownFile::unused);
    if (file_ == nullptr) file_ = taken(KnownFile::in_place);
    if (file_ == nullptr) return;
    std::memcpy(file_->path.data(), path.c_str(), path.size() + 1);
    std::memcpy(file_->target.data(), target.c_str(), target.size() + 1);
    file_->state.store(state);
  }
  ~Registration() {
    if (file_ != nullptr) file_->state.store(KnownFile::unused);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

  void become(KnownFile::State state) {
    if (file_ != nullptr) file_->state.store(state);
  }
  /// The entry stays in the list until its place is needed.
  void keep() { file_ = nullptr; }

 private:
  static KnownFile* taken(KnownFile::State from) {
    for (KnownFile& file : known_files)
      if (int expected = from; file.state.compare_exchange_strong(expected, KnownFile::being_named)) return &file;
    return nullptr;
  }

  KnownFile* file_ = nullptr;
};

std::string reason_text(int reason) { return std::generic_category().message(reason); }

/// As a value of errno.
int reason_of(const std::error_code& error) { return error.default_error_condition().value(); }

Message cure_for(int reason) {
  switch (reason) {
#ifdef EDQUOT
    case EDQUOT:
#endif
    case ENOSPC: return say("Make room on the disk, or choose another place.");
    case EFBIG: return say("The file would be larger than is allowed here; choose another place.");
    case EACCES:
    case EPERM: return say("Choose a folder in which you may write.");
    case EROFS: return say("This disk can only be read; choose another place.");
    case ENOENT:
    case ENOTDIR: return say("Create the folder first, or choose another one.");
    case ENAMETOOLONG: return say("Choose a shorter name.");
    default: return say("Choose another place.");
  }
}

[[noreturn]] void fail(const std::filesystem::path& path, const Message& what, int reason) {
  throw WriteError(path, say("%1: %2", what, reason_text(reason)), cure_for(reason));
}

/// Bytes to a file descriptor; remembers the first error, which an ostream by itself would not tell.
class DescriptorBuffer : public std::streambuf {
 public:
  explicit DescriptorBuffer(int descriptor) : descriptor_(descriptor), buffer_(1 << 18) { reset(); }
  int error() const { return error_; }

 protected:
  int_type overflow(int_type c) override {
    if (!flush_buffer()) return traits_type::eof();
    if (!traits_type::eq_int_type(c, traits_type::eof())) {
      *pptr() = traits_type::to_char_type(c);
      pbump(1);
    }
    return traits_type::not_eof(c);
  }
  int sync() override { return flush_buffer() ? 0 : -1; }

 private:
  void reset() { setp(buffer_.data(), buffer_.data() + buffer_.size()); }

  bool flush_buffer() {
    const char* from = pbase();
    while (error_ == 0 && from < pptr()) {
      const ssize_t count = ::write(descriptor_, from, static_cast<std::size_t>(pptr() - from));
      if (count >= 0) {
        from += count;
      } else if (errno != EINTR) {
        error_ = errno;
      }
    }
    reset();
    return error_ == 0;
  }

  int descriptor_;
  std::vector<char> buffer_;
  int error_ = 0;
};

/// The file that would be written if `path` were simply opened: symbolic links are followed, also dangling ones.
std::filesystem::path follow_links(const std::filesystem::path& path) {
  std::error_code error;
  std::filesystem::path target = std::filesystem::absolute(path, error);
  if (error) fail(path, say("cannot be written"), reason_of(error));
  for (int step = 0; step < 40; ++step) {
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(target, error))) return target;
    const std::filesystem::path link = std::filesystem::read_symlink(target, error);
    if (error) fail(path, say("cannot be written"), reason_of(error));
    target = link.is_absolute() ? link : target.parent_path() / link;
  }
  fail(path, say("cannot be written"), ELOOP);
}

/// Whether a file stands at the target now. @throws WriteError if it cannot be replaced.
bool has_file(const std::filesystem::path& path, const std::filesystem::path& target) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(target, error);
  if (reason_of(error) == ENOENT) return false;
  if (!std::filesystem::exists(status)) fail(path, say("cannot be written"), reason_of(error));
  if (std::filesystem::is_directory(status))
    throw WriteError(path, say("is a folder, not a file"), say("Choose a file name inside it."));
  if (!std::filesystem::is_regular_file(status))
    throw WriteError(path, say("is not a regular file"), say("Choose another name."));
  // Renaming over a write-protected file would succeed; the protection was meant, though.
  if (!may_write(target))
    throw WriteError(path, say("the file is write-protected: %1", reason_text(errno)), say("Save under another name."));
  return true;
}

constexpr std::string_view temporary_prefix = ".loopmend-";
constexpr std::string_view temporary_suffix = ".tmp";
constexpr std::size_t tag_digits = 8, random_digits = 8;

std::string hexadecimal(std::uint32_t bits) {
  std::string digits(8, '0');
  for (auto digit = digits.rbegin(); digit != digits.rend(); ++digit, bits >>= 4)
    *digit = "0123456789abcdef"[bits & 15U];
  return digits;
}

/// In the names of temporary files: where their process ids mean something. A folder may be shared between machines, or
/// between containers of one machine, and the id of another's process says nothing here.
std::string machine_tag() {
  std::uint32_t hash = 2166136261U;  // FNV-1a, which is the same in every build
  for (const char c : process_namespace()) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hexadecimal(hash);
}

std::filesystem::path temporary_name(const std::filesystem::path& folder) {
  std::random_device random;
  std::string name(temporary_prefix);
  name += std::to_string(process_id()) + "-" + machine_tag() + hexadecimal(random());
  return folder / name.append(temporary_suffix);
}

/// The process that made a temporary file of this machine; nothing if the name is no such file's.
std::optional<std::int32_t> maker_of(std::string_view name, std::string_view tag) {
  if (!name.starts_with(temporary_prefix) || !name.ends_with(temporary_suffix)) return std::nullopt;
  name.remove_prefix(temporary_prefix.size());
  name.remove_suffix(temporary_suffix.size());
  std::int32_t process = 0;
  const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
  if (error != std::errc() || process <= 0) return std::nullopt;
  name.remove_prefix(static_cast<std::size_t>(end - name.data()));
  if (name.size() != 1 + tag_digits + random_digits || name[0] != '-' || name.substr(1, tag_digits) != tag ||
      name.find_first_not_of("0123456789abcdef", 1) != std::string_view::npos)
    return std::nullopt;
  return process;
}

/// What killed processes have left: of this user, by a process of this machine that is no more. A file whose process id is
/// in use again stays.
void remove_leftovers(const std::filesystem::path& folder) {
  const std::string tag = machine_tag();
  std::error_code error, ignored;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::optional<std::int32_t> maker = maker_of(path_text(entry->path().filename()), tag);
    if (maker && process_has_ended(*maker) && is_own_file(entry->path()))
      std::filesystem::remove(entry->path(), ignored);
  }
}

/// A new file next to the target. Unless it is renamed, it is gone when this object is.
class TemporaryFile {
 public:
  /// @param path  the name that error messages speak of
  TemporaryFile(const std::filesystem::path& path, const std::filesystem::path& folder, Readers readers)
      : path_(path),
        name_(temporary_name(folder)),
        registration_(path_text(name_), path_text(path)) {
    descriptor_ = open_new_file(name_, readers);
    if (descriptor_ < 0) fail(path_, say("cannot be written in this folder"), errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    std::error_code ignored;
    if (!renamed_) std::filesystem::remove(name_, ignored);
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }

  void take_properties_of(const std::filesystem::path& target) const {
    if (const int reason = take_properties(descriptor_, target); reason != 0)
      fail(path_, say("cannot be written"), reason);
  }

  /// Everything is on the disk when this returns; a full disk may tell only now.
  void finish() {
    if (flush_to_disk(descriptor_) != 0) fail(path_, say("cannot be written"), errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(path_, say("cannot be written"), errno);
  }

  void rename_to(const std::filesystem::path& target) {
    registration_.become(KnownFile::in_transit);
    if (const std::error_code error = replace_file(name_, target); error) {
      registration_.become(KnownFile::unfinished);
      fail(path_, say("cannot be replaced"), reason_of(error));
    }
    renamed_ = true;
    registration_.become(KnownFile::in_place);
  }
  void stay_known() { registration_.keep(); }

 private:
  std::filesystem::path path_;
  std::filesystem::path name_;
  Registration registration_;  // before the file exists, so that no moment is uncovered
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// A file that is complete but for its name.
struct PreparedFile {
  std::filesystem::path target;
  std::unique_ptr<TemporaryFile> file;
};

void require_file_name(const std::filesystem::path& path) {
  if (!path.has_filename()) throw WriteError(path, say("is not a file name"), say("Choose a file name."));
}

PreparedFile prepare(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  require_file_name(path);
  PreparedFile prepared;
  prepared.target = follow_links(path);
  const bool replaces = has_file(path, prepared.target);
  remove_leftovers(prepared.target.parent_path());
  // What few may read is never open to more, not even while it is written.
  prepared.file = std::make_unique<TemporaryFile>(path, prepared.target.parent_path(),
                                                  replaces ? Readers::owner : Readers::by_default);
  if (replaces) prepared.file->take_properties_of(prepared.target);
  DescriptorBuffer buffer(prepared.file->descriptor());
  std::ostream stream(&buffer);
  write(stream);
  stream.flush();
  if (buffer.error() != 0) fail(path, say("cannot be written"), buffer.error());
  if (!stream) throw WriteError(path, say("cannot be written"), say("Choose another place."));
  prepared.file->finish();
  return prepared;
}

/// A folder that was made for files to come. Unless it is kept, it is gone when this object is.
class NewFolder {
 public:
  explicit NewFolder(const std::filesystem::path& path)
      : name_(std::filesystem::absolute(path)),
        registration_(path_text(name_), "", KnownFile::folder) {}
  ~NewFolder() {
    std::error_code ignored;
    if (!kept_) std::filesystem::remove(name_, ignored);  // does nothing where something stands in it by now
  }
  NewFolder(const NewFolder&) = delete;
  NewFolder& operator=(const NewFolder&) = delete;
  void keep() { kept_ = true; }

 private:
  std::filesystem::path name_;
  Registration registration_;
  bool kept_ = false;
};

}  // namespace

void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  const PreparedFile prepared = prepare(path, write);
  prepared.file->rename_to(prepared.target);
  flush_folder(prepared.target.parent_path());
}

struct OutputTransaction::Impl {
  // In this order: the files go first, then the folders from the innermost outwards.
  ~Impl() {
    files.clear();
    while (!folders.empty()) folders.pop_back();
  }
  std::vector<std::unique_ptr<NewFolder>> folders;
  std::vector<PreparedFile> files;
};

OutputTransaction::OutputTransaction() : impl_(std::make_unique<Impl>()) {}
OutputTransaction::~OutputTransaction() = default;

void OutputTransaction::add_folder(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::is_directory(path, error)) return;
  const std::filesystem::path parent = std::filesystem::absolute(path).lexically_normal().parent_path();
  if (!std::filesystem::exists(parent, error)) add_folder(parent);
  auto folder = std::make_unique<NewFolder>(path);
  if (!std::filesystem::create_directory(path, error)) {
    folder->keep();  // it is not ours
    throw WriteError(
        path,
        error ? say("cannot be made a folder: %1", error.message()) : say("cannot be made a folder: a file is there"),
        say("Choose another name."));
  }
  impl_->folders.push_back(std::move(folder));
}

void OutputTransaction::add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  impl_->files.push_back(prepare(path, write));
}

void OutputTransaction::commit() {
  for (const PreparedFile& prepared : impl_->files) {
    prepared.file->rename_to(prepared.target);
    prepared.file->stay_known();
    for (const auto& folder : impl_->folders) folder->keep();
  }
  std::vector<std::filesystem::path> synced;
  for (const PreparedFile& prepared : impl_->files) {
    const std::filesystem::path folder = prepared.target.parent_path();
    if (std::find(synced.begin(), synced.end(), folder) != synced.end()) continue;
    flush_folder(folder);
    synced.push_back(folder);
  }
  impl_->files.clear();
}

bool same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  std::error_code error;
  const bool a_exists = std::filesystem::exists(a, error), b_exists = std::filesystem::exists(b, error);
  if (a_exists != b_exists) return false;
  if (a_exists) return std::filesystem::equivalent(a, b, error);
  const std::filesystem::path target_a = follow_links(a), target_b = follow_links(b);
  if (target_a.filename() != target_b.filename()) return false;
  const bool same_folder = std::filesystem::equivalent(target_a.parent_path(), target_b.parent_path(), error);
  return error ? target_a.lexically_normal() == target_b.lexically_normal() : same_folder;
}

void check_writable(const std::filesystem::path& path) {
  require_file_name(path);
  const std::filesystem::path target = follow_links(path);
  has_file(path, target);
  const TemporaryFile probe(path, target.parent_path(), Readers::by_default);  // gone at once
}

std::size_t other_names(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return 0;
  const std::uintmax_t names = std::filesystem::hard_link_count(path, error);
  return error || names == 0 ? 0 : static_cast<std::size_t>(names) - 1;
}

void remove_unfinished_files() noexcept {
  for (KnownFile& file : known_files) {
    const int state = file.state.load();
    if (state != KnownFile::unfinished && state != KnownFile::in_transit) continue;
    // What is being renamed by another thread is either still there, and then never gets its name, or has it already.
    const bool gone = remove_file_at_exit(file.path.data()) == ENOENT;
    if (gone && state == KnownFile::in_transit) file.state.store(KnownFile::in_place);
  }
  for (auto file = known_files.rbegin(); file != known_files.rend(); ++file)
    if (file->state.load() == KnownFile::folder) remove_folder_at_exit(file->path.data());
}

const char* file_in_place(std::size_t k) noexcept {
  for (const KnownFile& file : known_files)
    if (file.state.load() == KnownFile::in_place && k-- == 0) return file.target.data();
  return nullptr;
}

}  // namespace loopmend
