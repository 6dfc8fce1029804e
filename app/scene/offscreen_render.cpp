// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/offscreen_render.h"

#include "analysis/curvature_field.h"
#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "scene/film.h"
#include "scene/mesh_scene.h"
#include "scene/offscreen_window.h"
#include "scene/view_direction.h"

#include <vtkCamera.h>
#include <vtkCoordinate.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

namespace loopmend {
namespace {

constexpr int supersampling = 2;
constexpr double crease_deg = 50;  ///< edges that bend by more look sharp in a picture of one colour

struct SceneOfModel {
  MeshScene scene;
  SurfaceShapePtr shape;
};

void check(const RenderOptions& options) {
  for (int size : {options.width, options.height})
    if (size < 64 || size > 8192)
      throw InvalidArgument(
          say("picture size %1x%2 is out of range. Give a width and a height between 64 and 8192 pixels.",
              options.width, options.height));
  if (options.h_range && !(*options.h_range > 0)) throw InvalidArgument(say("the colour range must be larger than 0."));
  if (options.eye && !(options.eye->norm() > 0)) throw InvalidArgument(say("the eye must not stand in the middle."));
}

/// Line widths and letters are drawn for a picture about 1000 pixels wide.
double pixel_ratio(double width, double height) {
  return supersampling * std::max(0.6, std::min(width / 1000.0, height / 750.0));
}

/// Captions are larger: they can be read where a page shows the picture 390 pixels wide, as on a phone.
double caption_ratio(double width, double height) {
  return std::max(pixel_ratio(width, height), supersampling * std::min(1.7 * width / 1000, height / 240));
}

std::vector<LoopLine> lines_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const Vec3& origin) {
  std::vector<LoopLine> lines;
  for (const BoundaryLoop& loop : loops) {
    LoopLine line;
    for (int v : loop.vertices) {
      const Vec3 p = model.mesh.point(model.mesh.vertex_handle(static_cast<unsigned>(v))) - origin;
      for (double x : {p.x(), p.y(), p.z()}) line.points.push_back(static_cast<float>(x));
    }
    line.style = loop.kind == LoopKind::hole ? LoopStyle::open : LoopStyle::left_out;
    lines.push_back(std::move(line));
  }
  return lines;
}

std::array<double, 3> place_of(const SurfaceModel& model, int vertex) {
  const Vec3 p = model.mesh.point(model.mesh.vertex_handle(static_cast<unsigned>(vertex)));
  return {p.x(), p.y(), p.z()};
}

/// Those loops of `before` whose vertices lie within the surface of `after`.
std::vector<BoundaryLoop> filled_loops(const SurfaceModel& before, const SurfaceModel& after) {
  std::set<std::array<double, 3>> missing, open;
  std::vector<BoundaryLoop> loops = find_boundary_loops(before);
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) missing.insert(place_of(before, v));
  for (int v = 0; v < static_cast<int>(after.mesh.n_vertices()); ++v) missing.erase(place_of(after, v));
  for (const BoundaryLoop& loop : find_boundary_loops(after))
    for (int v : loop.vertices) open.insert(place_of(after, v));
  std::erase_if(loops, [&](const BoundaryLoop& loop) {
    return std::any_of(loop.vertices.begin(), loop.vertices.end(), [&](int v) {
      const std::array<double, 3> place = place_of(before, v);
      return missing.count(place) > 0 || open.count(place) > 0;
    });
  });
  return loops;
}

void fill_scene(SceneOfModel& picture, const SurfaceModel& model, const RenderOptions& options, const Vec3& origin) {
  auto shape = std::make_shared<SurfaceShape>(shape_of(model.mesh, origin));
  if (options.shading == Shading::plain) *shape = parted_at_creases(std::move(*shape), crease_deg);
  if (is_drawn_over_the_scan(options.shading)) *shape = with_curvature(*shape, curvature_field(model.mesh));
  std::vector<SurfaceShapePtr> parts;
  if (options.shading == Shading::scan) parts = colored_parts(scan_colors(model), *shape);
  picture.shape = std::move(shape);
  picture.scene.set_scan(0, picture.shape, parts);
  picture.scene.set_shading(options.shading);
  picture.scene.set_loops(lines_of(model, find_boundary_loops(model), origin));
  picture.scene.arrive();
}

/// @throws InvalidArgument
const BoundaryLoop& loop_numbered(const std::vector<BoundaryLoop>& loops, int number) {
  for (const BoundaryLoop& loop : loops)
    if (loop.number == number) return loop;
  throw InvalidArgument(say("there is no loop %1: the surface has %2", number, loops.size()));
}

/// What the camera is aimed at: all shapes of a picture, or one loop of the first.
struct Aim {
  Vec3 focus;
  double radius = 1;
  std::vector<float> points;
  double share = 0.86;  ///< of the picture that the points are to fill
};

Aim aim_at(const std::vector<const SurfaceShape*>& shapes) {
  Aim aim;
  Eigen::AlignedBox3d box;
  for (const SurfaceShape* shape : shapes) {
    aim.points.insert(aim.points.end(), shape->points.begin(), shape->points.end());
    for (std::size_t i = 0; i + 2 < shape->points.size(); i += 3)
      box.extend(Vec3(shape->points[i], shape->points[i + 1], shape->points[i + 2]));
  }
  aim.focus = box.center();
  aim.radius = 0.5 * box.diagonal().norm();
  return aim;
}

Aim aim_at(const SurfaceModel& model, const BoundaryLoop& loop, const Vec3& origin) {
  Aim aim;
  aim.focus = loop.center - origin;
  aim.radius = 0.5 * loop.diameter;
  aim.points = lines_of(model, {loop}, origin).front().points;
  aim.share = 0.6;  // the neighborhood is wanted too
  return aim;
}

/// Turns the scene's camera to what is to be seen. `shapes` are all that share this camera, `model` is that of the first.
void aim(MeshScene& scene, const std::vector<const SurfaceShape*>& shapes, const SurfaceModel& model,
         const RenderOptions& options, double aspect) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const Aim whole = aim_at(shapes);
  const Aim goal = options.loop ? aim_at(model, loop_numbered(loops, *options.loop), scene_origin(model.soup)) : whole;
  Eigen::AlignedBox3d first;
  for (std::size_t i = 0; i + 2 < shapes.front()->points.size(); i += 3) {
    const auto& p = shapes.front()->points;
    first.extend(Vec3(p[i], p[i + 1], p[i + 2]));
  }
  const Vec3 up = guessed_up(first.sizes());
  Stand stand;
  stand.focus = goal.focus;
  stand.direction = options.eye    ? options.eye->normalized()
                    : options.view ? direction_of(*options.view, up)
                    : options.loop ? facing(model, loop_numbered(loops, *options.loop))
                                   : view_direction(model, loops, up);
  stand.up = view_up(stand.direction, up);
  stand.radius = goal.radius;
  stand.aspect = aspect;
  vtkCamera* camera = scene.renderer()->GetActiveCamera();
  place_camera(camera, stand);
  fit(camera, goal.points, aspect, goal.share);
}

vtkNew<vtkImageData> halve(vtkUnsignedCharArray* pixels, int width, int height) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const unsigned char* in = pixels->GetPointer(0);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  const int row = 3 * supersampling * width;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (int k = 0; k < 3; ++k) {
        int sum = 0;
        for (int dy = 0; dy < supersampling; ++dy)
          for (int dx = 0; dx < supersampling; ++dx)
            sum += in[(supersampling * y + dy) * row + 3 * (supersampling * x + dx) + k];
        *out++ = static_cast<unsigned char>(sum / (supersampling * supersampling));
      }
  return image;
}

vtkNew<vtkImageData> image_of(vtkRenderWindow* window, const RenderOptions& options) {
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  const int* size = window->GetSize();
  window->GetPixelData(0, 0, size[0] - 1, size[1] - 1, 0, pixels);
  if (pixels->GetNumberOfTuples() != static_cast<vtkIdType>(size[0]) * size[1])
    throw Error(say("this machine could not draw a picture of %1x%2 pixels. Try a smaller --size.", size[0], size[1]));
  return halve(pixels, options.width, options.height);
}

std::string png_of(vtkRenderWindow* window, const RenderOptions& options) {
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image_of(window, options));
  writer->WriteToMemoryOn();
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  return {reinterpret_cast<const char*>(png->GetPointer(0)), static_cast<std::size_t>(png->GetNumberOfValues())};
}

vtkNew<vtkTextActor> add_caption(vtkRenderer* renderer, const char* words, double ratio, int height) {
  vtkNew<vtkTextActor> text;
  text->SetInput(words);
  vtkTextProperty* look = text->GetTextProperty();
  look->SetFontFamilyToArial();
  look->BoldOn();
  look->ShadowOff();
  look->SetColor(0.14, 0.14, 0.14);
  look->SetFontSize(static_cast<int>(15 * ratio));
  look->SetVerticalJustificationToTop();
  text->GetPositionCoordinate()->SetCoordinateSystemToViewport();
  text->SetPosition(16 * ratio, height - 16 * ratio);
  renderer->AddActor2D(text);
  return text;
}

/// The legend's strip at the right edge, so that it covers nothing. @returns how wide it is, device pixels.
int give_legend_room(MeshScene& scene, vtkRenderWindow* window, double ratio, int width, int height) {
  int strip = static_cast<int>(std::lround((Legend::width_px + 12) * ratio));
  strip += (width - strip) % 2;  // two pictures of the same width fit beside it
  scene.set_size(strip, height);
  scene.set_legend(LegendPlace::beside);
  scene.legend_renderer()->SetViewport(1 - static_cast<double>(strip) / width, 0, 1, 1);
  scene.legend_renderer()->InteractiveOff();
  window->AddRenderer(scene.legend_renderer());
  return strip;
}

}  // namespace

std::string render_surface(const SurfaceModel& model, const RenderOptions& options) {
  check(options);
  const int width = supersampling * options.width, height = supersampling * options.height;
  const auto window = make_offscreen_window(width, height);
  const double ratio = pixel_ratio(options.width, options.height);
  SceneOfModel picture;
  picture.scene.set_pixel_ratio(ratio);
  fill_scene(picture, model, options, scene_origin(model.soup));
  picture.scene.set_range(options.h_range.value_or(symmetric_range(picture.shape->H)));
  window->AddRenderer(picture.scene.renderer());
  const int strip = is_colored(options.shading) ? give_legend_room(picture.scene, window, ratio, width, height) : 0;
  const int room = width - strip;
  picture.scene.renderer()->SetViewport(0, 0, static_cast<double>(room) / width, 1);
  aim(picture.scene, {picture.shape.get()}, model, options, static_cast<double>(room) / height);
  picture.scene.renderer()->ResetCameraClippingRange();
  const std::string png = png_of(window, options);
  window->Finalize();
  return png;
}

std::string render_before_after(const SurfaceModel& before, const SurfaceModel& after, const RenderOptions& options) {
  check(options);
  const int width = supersampling * options.width, height = supersampling * options.height;
  const auto window = make_offscreen_window(width, height);
  const double ratio = pixel_ratio(options.width, options.height);
  const Vec3 origin = scene_origin(before.soup);
  SceneOfModel left, right;
  for (SceneOfModel* picture : {&left, &right}) {
    picture->scene.set_pixel_ratio(ratio);
    fill_scene(*picture, picture == &left ? before : after, options, origin);
    window->AddRenderer(picture->scene.renderer());
  }
  if (options.seams == Seams::shown) {
    std::vector<LoopLine> lines = lines_of(before, filled_loops(before, after), origin);
    for (LoopLine& line : lines) line.style = LoopStyle::filled;
    for (LoopLine& line : lines_of(after, find_boundary_loops(after), origin)) lines.push_back(std::move(line));
    right.scene.set_loops(lines);
  }
  const double range = options.h_range.value_or(symmetric_range(left.shape->H));
  for (SceneOfModel* picture : {&left, &right}) picture->scene.set_range(range);
  left.scene.set_legend(LegendPlace::none);
  const int strip = is_colored(options.shading) ? give_legend_room(right.scene, window, ratio, width, height) : 0;
  const int room = (width - strip) / 2;
  aim(left.scene, {left.shape.get(), right.shape.get()}, before, options, static_cast<double>(room) / height);
  right.scene.renderer()->SetActiveCamera(left.scene.renderer()->GetActiveCamera());
  const double share = static_cast<double>(room) / width;
  left.scene.renderer()->SetViewport(0, 0, share, 1);
  right.scene.renderer()->SetViewport(share, 0, 2 * share, 1);
  const double caption = caption_ratio(options.width, options.height);
  add_caption(left.scene.renderer(), "Before", caption, height);
  add_caption(right.scene.renderer(), "After", caption, height);
  left.scene.renderer()->ResetCameraClippingRange();
  const std::string png = png_of(window, options);
  window->Finalize();
  return png;
}

std::string render_panels(const std::vector<Panel>& panels, int columns, const RenderOptions& options) {
  check(options);
  if (panels.empty() || columns < 1) throw InvalidArgument(say("a picture needs at least one panel and one column."));
  const int rows = (static_cast<int>(panels.size()) + columns - 1) / columns;
  const int width = supersampling * options.width, height = supersampling * options.height;
  const auto window = make_offscreen_window(width, height);
  const double ratio =
      0.5 * (pixel_ratio(options.width, options.height) + pixel_ratio(options.width / columns, options.height / rows));
  const Vec3 origin = scene_origin(panels.front().model->soup);
  std::vector<std::unique_ptr<SceneOfModel>> pictures;
  std::vector<float> all_H;
  for (const Panel& panel : panels) {
    pictures.push_back(std::make_unique<SceneOfModel>());
    pictures.back()->scene.set_pixel_ratio(ratio);
    fill_scene(*pictures.back(), *panel.model, options, origin);
    all_H.insert(all_H.end(), pictures.back()->shape->H.begin(), pictures.back()->shape->H.end());
    window->AddRenderer(pictures.back()->scene.renderer());
  }
  for (std::size_t k = 0; k + 1 < panels.size(); ++k) pictures[k]->scene.set_legend(LegendPlace::none);
  const int strip =
      is_colored(options.shading) ? give_legend_room(pictures.back()->scene, window, ratio, width, height) : 0;
  const int panel_width = (width - strip) / columns, panel_height = height / rows;
  std::vector<const SurfaceShape*> shapes;
  for (const auto& picture : pictures) shapes.push_back(picture->shape.get());
  aim(pictures.front()->scene, shapes, *panels.front().model, options, static_cast<double>(panel_width) / panel_height);
  const double room = static_cast<double>(width - strip) / width / columns;
  for (std::size_t k = 0; k < panels.size(); ++k) {
    MeshScene& scene = pictures[k]->scene;
    const double column = static_cast<double>(static_cast<int>(k) % columns), row = static_cast<int>(k) / columns;
    scene.renderer()->SetViewport(column * room, 1 - (row + 1) / rows, (column + 1) * room, 1 - row / rows);
    scene.renderer()->SetActiveCamera(pictures.front()->scene.renderer()->GetActiveCamera());
    scene.set_range(options.h_range.value_or(symmetric_range(all_H)));
    scene.set_shading(panels[k].shading.value_or(options.shading));
    scene.set_edges(panels[k].edges);
    add_caption(scene.renderer(), panels[k].caption.c_str(), ratio, panel_height);
  }
  pictures.front()->scene.renderer()->ResetCameraClippingRange();
  const std::string png = png_of(window, options);
  window->Finalize();
  return png;
}

namespace {

/// One camera and one colour range for all pictures of a film.
class FilmStage {
 public:
  FilmStage(const SurfaceModel& model, const RenderOptions& options);
  ~FilmStage() { window_->Finalize(); }
  FilmStage(const FilmStage&) = delete;
  FilmStage& operator=(const FilmStage&) = delete;
  RgbPicture draw(const FilmState& state);

 private:
  RenderOptions options_;
  vtkSmartPointer<vtkRenderWindow> window_;
  SceneOfModel picture_;
  vtkSmartPointer<vtkTextActor> caption_;
};

FilmStage::FilmStage(const SurfaceModel& model, const RenderOptions& options) : options_(options) {
  check(options);
  options_.shading = Shading::curvature;
  const int width = supersampling * options.width, height = supersampling * options.height;
  window_ = make_offscreen_window(width, height);
  const double ratio = pixel_ratio(options.width, options.height);
  MeshScene& scene = picture_.scene;
  scene.set_pixel_ratio(ratio);
  fill_scene(picture_, model, options_, scene_origin(model.soup));
  scene.set_range(options.h_range.value_or(symmetric_range(picture_.shape->H)));
  window_->AddRenderer(scene.renderer());
  const int room = width - give_legend_room(scene, window_, ratio, width, height);
  scene.renderer()->SetViewport(0, 0, static_cast<double>(room) / width, 1);
  aim(scene, {picture_.shape.get()}, model, options, static_cast<double>(room) / height);
  caption_ = add_caption(scene.renderer(), "", ratio, height).Get();
  caption_->GetTextProperty()->SetBackgroundColor(0.97, 0.97, 0.97);  // it may lie over the surface
  caption_->GetTextProperty()->SetBackgroundOpacity(1);
}

RgbPicture FilmStage::draw(const FilmState& state) {
  MeshScene& scene = picture_.scene;
  scene.set_patch(0, 0, state.patch);
  scene.arrive();
  caption_->SetInput(state.caption.c_str());
  scene.renderer()->ResetCameraClippingRange();
  const vtkNew<vtkImageData> image = image_of(window_, options_);
  RgbPicture picture{options_.width, options_.height, {}};
  const auto* bytes = static_cast<const unsigned char*>(image->GetScalarPointer());
  const std::ptrdiff_t row = std::ptrdiff_t{3} * picture.width;
  for (std::ptrdiff_t y = picture.height; y-- > 0;)  // VTK's rows come from the bottom
    picture.bytes.insert(picture.bytes.end(), bytes + y * row, bytes + (y + 1) * row);
  return picture;
}

}  // namespace

std::size_t render_film(std::ostream& out, const SurfaceModel& model, const std::vector<FilmState>& states,
                        const RenderOptions& options) {
  if (states.empty()) throw InvalidArgument(say("a film needs at least one state."));
  FilmStage stage(model, options);
  const std::vector<std::size_t> shown = states_of_film(states.size());
  const std::vector<int> durations = film_durations(shown.size(), options.pace);
  const auto draw = [&](std::size_t k) { return stage.draw(states[shown[k]]); };
  const std::vector<GifColor> palette = film_palette({draw(0), draw(shown.size() / 2), draw(shown.size() - 1)});
  std::size_t k = 0;
  write_film(out, options.width, options.height, palette, [&]() -> std::optional<FilmPicture> {
    if (k == shown.size()) return std::nullopt;
    FilmPicture picture{draw(k), durations[k]};
    ++k;
    return picture;
  });
  return k;
}

}  // namespace loopmend
