// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/film.h"

#include "core/error.h"

#include <vtkImageData.h>
#include <vtkImageQuantizeRGBToIndex.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loopmend {

std::vector<std::size_t> states_of_film(std::size_t count) {
  const std::size_t shown = std::min(count, most_film_states);
  std::vector<std::size_t> states;
  for (std::size_t k = 0; k < shown; ++k) states.push_back(shown > 1 ? k * (count - 1) / (shown - 1) : 0);
  return states;
}

std::vector<int> film_durations(std::size_t shown, const FilmPace& pace) {
  constexpr int wanted_in_all = 600, shortest = 10, longest = 60, at_the_start = 80, at_the_end = 250;
  if (shown == 0) return {};
  const int count = static_cast<int>(shown);
  const int each = pace.rate > 0 ? std::max(2, static_cast<int>(std::lround(100 / pace.rate)))
                                 : std::clamp(wanted_in_all / count, shortest, longest);
  std::vector<int> durations(shown, each);
  durations.front() = std::max(each, at_the_start);
  durations.back() = std::max(each, at_the_end);
  const int lacking =
      static_cast<int>(std::lround(100 * pace.seconds)) - std::accumulate(durations.begin(), durations.end(), 0);
  if (lacking > 0)
    for (int& duration : durations) duration += (lacking + count - 1) / count;
  return durations;
}

std::vector<GifColor> film_palette(const std::vector<RgbPicture>& samples) {
  if (samples.empty()) throw InvalidArgument(say("a palette needs a picture."));
  const int width = samples.front().width;
  int rows = 0;
  for (const RgbPicture& sample : samples) rows += sample.height;
  vtkNew<vtkImageData> all;
  all->SetDimensions(width, rows, 1);
  all->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* to = static_cast<unsigned char*>(all->GetScalarPointer());
  for (const RgbPicture& sample : samples) to = std::copy(sample.bytes.begin(), sample.bytes.end(), to);
  vtkNew<vtkImageQuantizeRGBToIndex> median_cut;
  median_cut->SetInputData(all);
  median_cut->SetNumberOfColors(static_cast<int>(most_gif_colors));
  median_cut->Update();
  vtkLookupTable* table = median_cut->GetLookupTable();
  std::vector<GifColor> palette;
  for (vtkIdType k = 0; k < std::min<vtkIdType>(table->GetNumberOfTableValues(), most_gif_colors); ++k) {
    const double* rgba = table->GetTableValue(k);
    GifColor color{};
    for (std::size_t c = 0; c < 3; ++c) color[c] = static_cast<unsigned char>(std::lround(255 * rgba[c]));
    palette.push_back(color);
  }
  // What is most of a picture, its ground, is met exactly.
  const auto& corner = samples.front().bytes;
  if (corner.size() >= 3) palette.back() = {corner[0], corner[1], corner[2]};
  return palette;
}

int write_film(std::ostream& out, int width, int height, const std::vector<GifColor>& palette,
               const std::function<std::optional<FilmPicture>()>& next) {
  GifWriter writer(out, width, height, palette);
  int count = 0;
  while (out) {
    const std::optional<FilmPicture> film = next();
    if (!film) break;
    writer.add(film->picture, film->hundredths);
    ++count;
  }
  writer.finish();
  return count;
}

}  // namespace loopmend
