// Runs `loopmend` as a person or a script would.
#pragma once

#include <filesystem>
#include <string>

namespace loopmend::test {

struct Outcome {
  int code = -1;  ///< exit code; 128 + signal when killed
  std::string out, err;
};

/// @param arguments  as typed in a shell.
Outcome loopmend_program(const std::string& arguments);

std::string text_of(const std::filesystem::path& path);

/// A folder of its own for each test, removed at its end.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

}  // namespace loopmend::test
