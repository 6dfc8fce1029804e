// The picture in the middle: shows the document, finds the loop under the mouse, turns, flies.
#pragma once

#include "scene/shading.h"

#include <QImage>
#include <QWidget>

#include <memory>

namespace loopmend {

class Document;
class HoleSelection;
struct SurfaceShape;

class MeshView : public QWidget {
  Q_OBJECT

 public:
  /// To be called once, before the QApplication is made.
  static void prepare_graphics();

  MeshView(const Document& document, HoleSelection& selection, QWidget* parent = nullptr);
  ~MeshView() override;

  Shading shading() const;
  void set_shading(Shading shading);
  void set_edges(Edges edges);

  /// A first picture of a scan that is still being opened.
  void show_preview(std::shared_ptr<const SurfaceShape> shape);
  void drop_preview();

  /// Everything, from where the eye is.
  void frame();
  /// Turns and moves until the loop is seen from above.
  void fly_to(int loop);

  /// The picture without overlay, in device pixels.
  QImage picture() const;

  /// Where a loop's vertex appears, in widget pixels; for tests.
  QPoint position_of(int loop, int vertex) const;
  /// The widget that takes the mouse; for tests.
  QWidget* canvas() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  struct Impl;
  void follow_document();
  void on_opened();
  void on_patches_changed();
  void on_patch_moved(int id);
  void update_loops();
  void update_highlight();
  void update_palette();
  void hover(const QPoint& at);
  void click(const QPoint& at, Qt::KeyboardModifiers modifiers);
  int loop_at(const QPoint& at);
  void face_front();
  void redraw();
  void after_render();

  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
