// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/film_writing.h"

#include "io/atomic_file.h"

#include <chrono>
#include <utility>

namespace loopmend {
namespace {

/// Leaves write_file_atomically(), which then removes what it has begun.
struct FilmGivenUp {};

}  // namespace

bool FilmWriting::has_room() const {
  const std::lock_guard lock(mutex_);
  return waiting_.size() < most_waiting && !ended_;
}

void FilmWriting::put(FilmPicture picture) {
  const std::lock_guard lock(mutex_);
  waiting_.push_back(std::move(picture));
  changed_.notify_all();
}

void FilmWriting::end() {
  const std::lock_guard lock(mutex_);
  ended_ = true;
  changed_.notify_all();
}

std::optional<FilmPicture> FilmWriting::next(const CancelToken& cancel) {
  constexpr std::chrono::milliseconds look_at_token{20};
  std::unique_lock lock(mutex_);
  while (waiting_.empty() && !ended_ && !cancel.cancelled()) changed_.wait_for(lock, look_at_token);
  if (cancel.cancelled()) throw FilmGivenUp();
  if (waiting_.empty()) return std::nullopt;
  FilmPicture picture = std::move(waiting_.front());
  waiting_.pop_front();
  return picture;
}

bool FilmWriting::write(const std::filesystem::path& path, const std::vector<RgbPicture>& samples,
                        const CancelToken& cancel) {
  const std::vector<GifColor> palette = film_palette(samples);
  try {
    write_file_atomically(path, [&](std::ostream& out) {
      write_film(out, samples.front().width, samples.front().height, palette, [&] { return next(cancel); });
      if (cancel.cancelled()) throw FilmGivenUp();
    });
  } catch (const FilmGivenUp&) {
    return false;
  }
  return true;
}

}  // namespace loopmend
