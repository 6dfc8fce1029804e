#include "io/atomic_file.h"

#include "core/error.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <optional>
#include <random>
#include <streambuf>
#include <string>
#include <system_error>
#include <vector>

namespace loopmend {

namespace {

/// Paths of temporary files, where an exit path can read them without a lock and without memory of its own.
constexpr std::size_t longest_path = 4096;

struct UnfinishedFile {
  enum State : int { unused, being_named, named };
  std::atomic<int> state{unused};
  std::array<char, longest_path> path{};
};

std::array<UnfinishedFile, 16> unfinished_files;  // the one global of the engine: a signal cannot be handed an argument
static_assert(std::atomic<int>::is_always_lock_free);

/// Keeps one path in the list while it lives. With the list full, or a path too long, it does nothing.
class Registration {
 public:
  explicit Registration(const std::string& path) {
    if (path.size() >= longest_path) return;
    for (UnfinishedFile& file : unfinished_files) {
      int expected = UnfinishedFile::unused;
      if (!file.state.compare_exchange_strong(expected, UnfinishedFile::being_named)) continue;
      std::memcpy(file.path.data(), path.c_str(), path.size() + 1);
      file.state.store(UnfinishedFile::named);
      file_ = &file;
      return;
    }
  }
  ~Registration() {
    if (file_ != nullptr) file_->state.store(UnfinishedFile::unused);
  }
  Registration(const Registration&) = delete;
  Registration& operator=(const Registration&) = delete;

 private:
  UnfinishedFile* file_ = nullptr;
};

std::string reason_text(int reason) { return std::generic_category().message(reason); }

std::string cure_for(int reason) {
  switch (reason) {
    case ENOSPC:
    case EDQUOT: return "Make room on the disk, or choose another place.";
    case EFBIG: return "The file would be larger than is allowed here; choose another place.";
    case EACCES:
    case EPERM: return "Choose a folder in which you may write.";
    case EROFS: return "This disk can only be read; choose another place.";
    case ENOENT:
    case ENOTDIR: return "Create the folder first, or choose another one.";
    case ENAMETOOLONG: return "Choose a shorter name.";
    default: return "Choose another place.";
  }
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int reason) {
  throw WriteError(path, what + ": " + reason_text(reason), cure_for(reason));
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
  if (error) fail(path, "cannot be written", error.value());
  for (int step = 0; step < 40; ++step) {
    if (!std::filesystem::is_symlink(std::filesystem::symlink_status(target, error))) return target;
    const std::filesystem::path link = std::filesystem::read_symlink(target, error);
    if (error) fail(path, "cannot be written", error.value());
    target = link.is_absolute() ? link : target.parent_path() / link;
  }
  fail(path, "cannot be written", ELOOP);
}

/// What stands at the target now; nothing if there is no file yet.
std::optional<struct stat> existing_file(const std::filesystem::path& path, const std::filesystem::path& target) {
  struct stat status {};
  if (::stat(target.c_str(), &status) != 0) {
    if (errno == ENOENT) return std::nullopt;
    fail(path, "cannot be written", errno);
  }
  if (S_ISDIR(status.st_mode)) throw WriteError(path, "is a folder, not a file", "Choose a file name inside it.");
  if (!S_ISREG(status.st_mode)) throw WriteError(path, "is not a regular file", "Choose another name.");
  // Renaming over a write-protected file would succeed; the protection was meant, though.
  if (::access(target.c_str(), W_OK) != 0) {
    throw WriteError(path, "the file is write-protected: " + reason_text(errno), "Save under another name.");
  }
  return status;
}

std::filesystem::path temporary_name(const std::filesystem::path& folder) {
  static const char digits[] = "0123456789abcdef";
  std::random_device random;
  std::string name = ".loopmend-" + std::to_string(::getpid()) + "-";
  for (int word = 0; word < 2; ++word) {
    std::uint32_t bits = random();
    for (int i = 0; i < 8; ++i, bits >>= 4) name += digits[bits & 15U];
  }
  return folder / (name + ".tmp");
}

/// A new file next to the target. Unless it is renamed, it is gone when this object is.
class TemporaryFile {
 public:
  /// @param path  the name that error messages speak of
  TemporaryFile(const std::filesystem::path& path, const std::filesystem::path& folder)
      : path_(path),
        name_(temporary_name(folder)),
        registration_(name_.string()) {
    descriptor_ = ::open(name_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ < 0) fail(path_, "cannot be written in this folder", errno);
  }
  ~TemporaryFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!renamed_) ::unlink(name_.c_str());
  }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;

  int descriptor() const { return descriptor_; }

  /// Owner first, since changing it may take away bits of the mode. A foreign owner cannot be kept by everyone.
  void take_mode_of(const struct stat& status) const {
    if (::fchown(descriptor_, status.st_uid, status.st_gid) != 0) errno = 0;
    if (::fchmod(descriptor_, status.st_mode & 07777U) != 0) fail(path_, "cannot be written", errno);
  }

  /// Everything is on the disk when this returns; a full disk may tell only now.
  void finish() {
    if (::fsync(descriptor_) != 0) fail(path_, "cannot be written", errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0) fail(path_, "cannot be written", errno);
  }

  void rename_to(const std::filesystem::path& target) {
    if (::rename(name_.c_str(), target.c_str()) != 0) fail(path_, "cannot be replaced", errno);
    renamed_ = true;
  }

 private:
  std::filesystem::path path_;
  std::filesystem::path name_;
  Registration registration_;  // before the file exists, so that no moment is uncovered
  int descriptor_ = -1;
  bool renamed_ = false;
};

/// So that the new name survives a power cut. The file stands already: a folder that cannot be synced is no failure.
void sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

}  // namespace

void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write) {
  if (!path.has_filename()) throw WriteError(path, "is not a file name", "Choose a file name.");
  const std::filesystem::path target = follow_links(path);
  const std::filesystem::path folder = target.parent_path();
  const std::optional<struct stat> old = existing_file(path, target);

  TemporaryFile file(path, folder);
  if (old) file.take_mode_of(*old);
  DescriptorBuffer buffer(file.descriptor());
  std::ostream stream(&buffer);
  write(stream);
  stream.flush();
  if (buffer.error() != 0) fail(path, "cannot be written", buffer.error());
  if (!stream) throw WriteError(path, "cannot be written", "Choose another place.");
  file.finish();
  file.rename_to(target);
  sync_folder(folder);
}

void check_writable(const std::filesystem::path& path) {
  if (!path.has_filename()) throw WriteError(path, "is not a file name", "Choose a file name.");
  const std::filesystem::path target = follow_links(path);
  existing_file(path, target);
  const TemporaryFile probe(path, target.parent_path());  // gone at once
}

void remove_unfinished_files() noexcept {
  for (UnfinishedFile& file : unfinished_files) {
    if (file.state.load() == UnfinishedFile::named) ::unlink(file.path.data());
  }
}

}  // namespace loopmend
