// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/example_controller.h"

#include "compare/compare_controller.h"
#include "document/targets.h"
#include "panels/banner.h"
#include "panels/gallery.h"
#include "views/mesh_view.h"
#include "views/tool_controller.h"

namespace loopmend {
namespace {

Tool tool_of(PaperExample::Kind kind) {
  switch (kind) {
    case PaperExample::Kind::holes: return Tool::none;
    case PaperExample::Kind::blend: return Tool::blend;
    case PaperExample::Kind::points: return Tool::points;
    case PaperExample::Kind::region: return Tool::region;
  }
  return Tool::none;
}

}  // namespace

ExampleController::ExampleController(const Parts& parts, QObject* parent) : QObject(parent), parts_(parts) {}

void ExampleController::open(const QString& id) {
  const PaperExample* example = paper_example(id.toStdString());
  if (!example) return;
  drop(job_);
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [example] {
        std::vector<OpenedScanPtr> scans;
        Vec3 origin = Vec3::Zero();
        const std::vector<TriangleSoup> soups = example->parts();
        for (std::size_t k = 0; k < soups.size(); ++k) {
          if (k == 0) origin = scene_origin(soups[k]);
          const QString name = example_name(*example);
          scans.push_back(made_scan(soups[k], soups.size() > 1 ? tr("%1 %2").arg(name).arg(k + 1) : name, origin));
        }
        return scans;
      },
      [this, example](const std::vector<OpenedScanPtr>& scans) { on_made(*example, scans); },
      [this](const QString& words) {
        job_.reset();
        parts_.banner.show_problem(words);
      });
}

void ExampleController::on_made(const PaperExample& example, const std::vector<OpenedScanPtr>& scans) {
  job_.reset();
  parts_.controller.open_made(scans);
  parts_.view.frame();
  parts_.tools.take(tool_of(example.kind));
  switch (example.kind) {
    case PaperExample::Kind::holes: {
      std::set<int> holes;  // the open ends of a tube are no holes
      for (int loop = 0; loop < parts_.document.loop_count(); ++loop)
        if (parts_.document.loop(loop).turning < -0.3) holes.insert(loop);
      parts_.selection.select(holes);
      break;
    }
    case PaperExample::Kind::blend: parts_.tools.select_facing(); break;
    case PaperExample::Kind::points: break;
    case PaperExample::Kind::region:
      parts_.tools.region().set_vertices(parts_.document.scans().front(), bumps_region(scans.front()->model->soup));
      break;
  }
  parts_.banner.ask(tr("An example of the paper: %1.").arg(example_title(example)),
                    {{tr("&Run it"), "exampleRun", [this, id = QString::fromLatin1(example.id)] { run(id); }}});
}

void ExampleController::run(const QString& id) {
  const PaperExample* example = paper_example(id.toStdString());
  if (!example || !parts_.document.has_scan()) return;
  if (example->kind == PaperExample::Kind::holes) {
    fill_and_run();
  } else if (example->flows == PaperExample::Flows::one) {
    parts_.tools.evolve();
  } else {
    // What opens next is this one.
    const auto once = std::make_shared<QMetaObject::Connection>();
    *once = connect(&parts_.comparisons, &CompareController::opened, this, [once](CompareWindow* window) {
      disconnect(*once);
      window->run_when_ready();
    });
    parts_.tools.compare();
  }
}

/// The paper's scheme: the filling, then semi-implicit steps.
void ExampleController::fill_and_run() {
  constexpr double paper_sigma = 10;
  const auto once = std::make_shared<QMetaObject::Connection>();
  *once = connect(&parts_.controller, &FillController::activity_changed, this, [this, once] {
    if (parts_.controller.busy()) return;
    disconnect(*once);
    // After the fill has become a change of the document.
    QMetaObject::invokeMethod(
        this,
        [this] {
          EvolutionOptions options;
          options.sigma = paper_sigma;
          parts_.controller.evolve(patches_to_move(parts_.document, parts_.selection), options, Pace::time_steps);
        },
        Qt::QueuedConnection);
  });
  parts_.controller.fill(loops_to_fill(parts_.document, parts_.selection), {});
}

}  // namespace loopmend
