// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/film_source.h"

#include "document/document.h"
#include "document/labels.h"
#include "views/mesh_view.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>

namespace loopmend {
namespace {

QString translated(const char* text) { return QCoreApplication::translate("loopmend::FilmSource", text); }

/// In the upper left corner, on a ground of its own: it may lie over the surface.
void write_caption(QImage& picture, const QString& words) {
  QPainter painter(&picture);
  QFont font = painter.font();
  const int size = std::max(11, picture.height() / 30);
  font.setPixelSize(size);
  font.setBold(true);
  painter.setFont(font);
  const QRect text = painter.fontMetrics().boundingRect(words).translated(size, size + painter.fontMetrics().ascent());
  painter.fillRect(text.adjusted(-size / 2, -size / 4, size / 2, size / 4), QColor(250, 250, 250));
  painter.setPen(QColor(36, 36, 36));
  painter.drawText(size, size + painter.fontMetrics().ascent(), words);
}

struct FilmedPatches {
  std::vector<TimelinePtr> timelines;
  std::set<int> loops;
  std::size_t longest = 0;  ///< which of the timelines
};

FilmedPatches filmed(const Document& document, const std::set<int>& patches) {
  FilmedPatches film;
  for (const OpenPatch& patch : document.patches()) {
    if (!patches.contains(patch.id) || !patch.timeline) continue;
    film.timelines.push_back(patch.timeline);
    film.loops.insert(patch.loops.begin(), patch.loops.end());
    if (patch.timeline->size() > film.timelines[film.longest]->size()) film.longest = film.timelines.size() - 1;
  }
  return film;
}

}  // namespace

QString shown_by(Shading shading) {
  switch (shading) {
    case Shading::curvature: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "mean curvature"));
    case Shading::gaussian: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "Gaussian curvature"));
    case Shading::zebra: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "reflected stripes"));
    case Shading::isophotes: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "isophotes"));
    case Shading::deviation: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "likely error"));
    case Shading::scan: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "the scan's colours"));
    case Shading::difference:
    case Shading::plain: return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "the surface"));
  }
  return {};
}

QString film_caption(const PatchState& state, int steps, Shading shading) {
  if (state.steps == 0)
    return translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "Initial patch: %1")).arg(shown_by(shading));
  const bool by_flow =
      state.method == Method::flow || state.method == Method::split_flow || state.method == Method::mixed_order;
  const QString step = translated(QT_TRANSLATE_NOOP("loopmend::FilmSource", "step %1 of %2: %3"))
                           .arg(state.steps)
                           .arg(steps)
                           .arg(shown_by(shading));
  return by_flow ? labels::flow_name(state.flow) + QStringLiteral(", ") + step : labels::sentence(step);
}

bool has_film(const Document& document, const std::set<int>& patches) {
  const FilmedPatches film = filmed(document, patches);
  return std::any_of(film.timelines.begin(), film.timelines.end(), [](const auto& t) { return t->size() > 1; });
}

FilmSource film_of(MeshView& view, const Document& document, const std::set<int>& patches) {
  FilmSource source;
  const FilmedPatches film = filmed(document, patches);
  source.states = film.timelines.empty() ? 0 : film.timelines[film.longest]->size();
  source.seen = view.size();
  source.draw = [&view, film](std::size_t at, const QSize& pixels) {
    constexpr int supersampling = 2;  // the graphics do not smooth edges
    std::vector<SurfaceShapePtr> shapes;
    for (const TimelinePtr& timeline : film.timelines)
      shapes.push_back((*timeline)[std::min(at, timeline->size() - 1)]->shape);
    view.show_instead(film.loops, shapes);
    QImage picture =
        view.picture({supersampling * pixels, PictureOptions::Ground::as_seen, PictureOptions::Extras::legend});
    view.show_instead({}, {});
    if (picture.isNull()) return picture;
    picture = picture.scaled(pixels, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const Timeline& longest = *film.timelines[film.longest];
    write_caption(picture, film_caption(*longest[at], longest.back()->steps, view.look().shading));
    return picture;
  };
  return source;
}

}  // namespace loopmend
