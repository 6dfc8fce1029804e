// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a film beside the window: pictures come from the window's thread, which alone can draw them, one or two ahead.
#pragma once

#include "core/cancel.h"
#include "scene/film.h"

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <vector>

namespace loopmend {

class FilmWriting {
 public:
  /// Window's thread: whether a picture more is to be drawn now. Not while enough of them wait to be written.
  bool has_room() const;
  void put(FilmPicture picture);
  void end();

  /// Worker's thread: writes until end(). Cancelled, or on a failure, no file is left.
  /// @param samples  pictures that the colors are chosen by, all of the film's size. @returns whether it was written.
  /// @throws WriteError, Error.
  bool write(const std::filesystem::path& path, const std::vector<RgbPicture>& samples, const CancelToken& cancel);

 private:
  std::optional<FilmPicture> next(const CancelToken& cancel);

  static constexpr std::size_t most_waiting = 2;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<FilmPicture> waiting_;
  bool ended_ = false;
};

}  // namespace loopmend
