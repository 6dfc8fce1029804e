#include "scene/surface_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkLookupTable.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkShaderProperty.h>
#include <vtkTypeInt32Array.h>
#include <vtkUniforms.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace loopmend {
namespace {

constexpr Rgb scan_color{0.80, 0.785, 0.755};
constexpr Rgb patch_color{0.50, 0.74, 0.70};
constexpr Rgb edge_color{0.22, 0.25, 0.30};
constexpr float edge_width = 0.5F;
constexpr int default_stripes = 9;

constexpr std::chrono::milliseconds a_moment{150}, shortest_way{60};
constexpr std::chrono::seconds longest_way{10};

// One program for all shadings, coloured or not: to compile another one takes software graphics a quarter of a second.
// There is no ambient light: VTK leaves in the ambient colour how much of a triangle's edge lies on the pixel.
// Key light over the left shoulder, soft fill from the right, a little sky: in view coordinates, so it follows the eye.
// The inside of the surface is dull and dark, so that a hole reads as a hole. A patch lies on top of the rings that it
// shares with the scan, hence the tiny shift in depth.
constexpr const char* lighting = R"(//VTK::Light::Impl
  vec3 loopmendNormal = normalize(normalVCVSOutput);
  float loopmendEdge = clamp(ambientColor.b / loopmendEdgeColor.b, 0.0, 1.0);
  vec3 loopmendBase = loopmendColored == 1 ? diffuseColor / max(0.05, 1.0 - loopmendEdge) : loopmendPlain;
  float loopmendGloss = 0.07;
  bool striped = loopmendShading == 3 || loopmendShading == 4;
  if (striped) {
    vec3 mirrored = reflect(normalize(vertexVC.xyz), loopmendNormal);
    float band = loopmendShading == 3 ? 0.5 + 0.5 * mirrored.y / max(1e-3, length(mirrored) + abs(mirrored.z) * 0.35)
                                      : 0.5 + 0.5 * dot(loopmendNormal, normalize(vec3(-0.35, 0.75, 0.55)));
    float stripe = sin(float(loopmendStripes) * 3.14159265 * (loopmendShading == 3 ? band : 2.0 * band));
    float soft = clamp(fwidth(stripe) * 0.9, 0.02, 1.0);
    loopmendBase = mix(vec3(0.11, 0.12, 0.14), vec3(0.94, 0.94, 0.92), smoothstep(-soft, soft, stripe));
    loopmendGloss = 0.0;
  }
  float inside = gl_FrontFacing ? 0.0 : 1.0;
  loopmendBase = mix(loopmendBase, vec3(0.36, 0.34, 0.33), 0.85 * inside);
  float key = max(0.0, dot(loopmendNormal, normalize(vec3(-0.45, 0.55, 0.75))));
  float fill = max(0.0, dot(loopmendNormal, normalize(vec3(0.75, -0.10, 0.55))));
  float sky = 0.5 + 0.5 * loopmendNormal.y;
  float amount = 0.46 + 0.42 * key + 0.12 * fill + 0.10 * sky;
  float shine = pow(max(0.0, dot(loopmendNormal, normalize(vec3(-0.25, 0.35, 1.0)))), 40.0);
  if (striped) amount = mix(1.0, amount, 0.45);
  vec3 loopmendLit = loopmendBase * amount + loopmendGloss * shine * (1.0 - inside);
  fragOutput0 = vec4(mix(loopmendLit, loopmendEdgeColor, loopmendEdge), 1.0);
)";
constexpr const char* patch_on_top = R"(  gl_FragDepth = gl_FragCoord.z - 0.00002;
)";

vtkNew<vtkFloatArray> wrap(const std::vector<float>& values, int components, const char* name) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  // The shape is kept alive, and never written to, as long as the arrays are in use.
  array->SetArray(const_cast<float*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

vtkNew<vtkFloatArray> unknown_everywhere(const std::shared_ptr<const SurfaceShape>& shape) {
  vtkNew<vtkFloatArray> array;
  array->SetName("curvature");
  array->SetNumberOfValues(shape ? static_cast<vtkIdType>(shape->points.size() / 3) : 0);
  array->FillValue(0);
  return array;
}

vtkNew<vtkCellArray> wrap_triangles(const std::vector<int>& triangles, vtkIdType count) {
  vtkNew<vtkTypeInt32Array> offsets, connectivity;
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i) offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  connectivity->SetArray(const_cast<int*>(triangles.data()), 3 * count, 1);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, connectivity);
  return cells;
}

}  // namespace

SurfaceActor::SurfaceActor(Role role, vtkLookupTable* table) : role_(role) {
  mapper_->SetInputData(data_);
  mapper_->SetLookupTable(table);
  mapper_->UseLookupTableScalarRangeOn();
  mapper_->InterpolateScalarsBeforeMappingOn();
  mapper_->ScalarVisibilityOn();
  mapper_->StaticOn();
  actor_->SetMapper(mapper_);
  vtkProperty* look = actor_->GetProperty();
  const Rgb& color = role == Role::scan ? scan_color : patch_color;
  look->SetEdgeColor(edge_color[0], edge_color[1], edge_color[2]);
  look->SetLineWidth(edge_width);
  look->SetInterpolationToPhong();
  look->SetDiffuse(1);
  look->SetAmbient(0);
  vtkShaderProperty* shader = actor_->GetShaderProperty();
  const std::string code = std::string(lighting) + (role == Role::patch ? patch_on_top : "");
  shader->AddFragmentShaderReplacement("//VTK::Light::Impl", true, code, false);
  shader->GetFragmentCustomUniforms()->SetUniformi("loopmendShading", static_cast<int>(shading_));
  std::array<float, 3> plain{}, edge{};
  std::copy(color.begin(), color.end(), plain.begin());
  shader->GetFragmentCustomUniforms()->SetUniform3f("loopmendPlain", plain.data());
  std::copy(edge_color.begin(), edge_color.end(), edge.begin());
  shader->GetFragmentCustomUniforms()->SetUniform3f("loopmendEdgeColor", edge.data());
  shader->GetFragmentCustomUniforms()->SetUniformi("loopmendColored", 0);
  set_stripes(default_stripes);
}

SurfaceActor::~SurfaceActor() = default;

vtkActor* SurfaceActor::actor() const { return actor_; }

void SurfaceActor::set_shape(std::shared_ptr<const SurfaceShape> shape, Arrival arrival, Clock::time_point now) {
  const bool known = shape == shape_;
  if (known && (!glide_ || arrival == Arrival::with_the_next)) return;
  if (!known && arrival != Arrival::at_once && shape_ && ShapeGlide::is_possible(*shape_, *shape)) {
    glide(std::move(shape), arrival, now);
  } else if (known && arrival == Arrival::soon) {
    glide_->hurry(now, now + a_moment);
  } else {
    show(std::move(shape));
  }
}

/// As it is, without a copy.
void SurfaceActor::show(std::shared_ptr<const SurfaceShape> shape) {
  // The old arrays stay valid until they are replaced.
  const std::shared_ptr<const SurfaceShape> old = std::move(shape_);
  const std::unique_ptr<ShapeGlide> old_glide = std::move(glide_);
  shape_ = std::move(shape);
  vtkNew<vtkPoints> points;
  points->SetData(wrap(shape_->points, 3, "points"));
  data_->SetPoints(points);
  data_->GetPointData()->SetNormals(wrap(shape_->normals, 3, "normals"));
  update_triangles();
  update_scalars();
}

/// The time that the last state took to come is about what the next one will take.
void SurfaceActor::glide(std::shared_ptr<const SurfaceShape> shape, Arrival arrival, Clock::time_point now) {
  Clock::duration time = a_moment;
  if (arrival == Arrival::with_the_next && last_news_)
    time = std::clamp<Clock::duration>(now - *last_news_, shortest_way, longest_way);
  last_news_ = now;
  if (glide_) glide_->advance(now);
  auto next = std::make_unique<ShapeGlide>(glide_ ? glide_->shown() : *shape_, shape, now, time);
  const std::unique_ptr<ShapeGlide> old = std::exchange(glide_, std::move(next));
  const std::shared_ptr<const SurfaceShape> old_shape = std::exchange(shape_, std::move(shape));
  vtkNew<vtkPoints> points;
  points->SetData(wrap(glide_->shown().points, 3, "points"));
  data_->SetPoints(points);
  data_->GetPointData()->SetNormals(wrap(glide_->shown().normals, 3, "normals"));
  update_triangles();
  update_scalars();
}

bool SurfaceActor::advance(Clock::time_point now) {
  if (!glide_) return false;
  if (glide_->has_arrived(now)) {
    show(shape_);
    return false;
  }
  glide_->advance(now);
  data_->GetPoints()->GetData()->Modified();
  data_->GetPoints()->Modified();
  data_->GetPointData()->GetNormals()->Modified();
  if (is_colored(shading_)) data_->GetPointData()->GetScalars()->Modified();
  data_->Modified();
  return true;
}

/// The rings around a patch continue its H and its reflections, but they are not the patch: in plain colour they go.
void SurfaceActor::update_triangles() {
  const auto all = static_cast<vtkIdType>(shape_->triangles.size() / 3);
  const vtkIdType shown = shading_ == Shading::plain ? shape_->own_triangles : all;
  // The same ones need not go to the graphics again.
  if (triangles_of_ && data_->GetNumberOfPolys() == shown && triangles_of_->triangles == shape_->triangles) return;
  data_->SetPolys(wrap_triangles(shape_->triangles, shown));
  triangles_of_ = shape_;
}

void SurfaceActor::update_scalars() {
  const SurfaceShape* shown = glide_ ? &glide_->shown() : shape_.get();
  const std::vector<float>* values = nullptr;
  if (shown && shading_ == Shading::curvature) values = &shown->H;
  if (shown && shading_ == Shading::gaussian) values = &shown->K;
  const bool known = values && !values->empty();
  data_->GetPointData()->SetScalars(known ? wrap(*values, 1, "curvature") : unknown_everywhere(shape_));
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendColored", known ? 1 : 0);
  data_->Modified();
}

void SurfaceActor::set_shading(Shading shading) {
  if (shading == shading_) return;
  const bool other_scalars = is_colored(shading) || is_colored(shading_);
  shading_ = shading;
  if (shape_ && role_ == Role::patch) update_triangles();
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendShading", static_cast<int>(shading));
  if (shape_ && other_scalars) update_scalars();
}

void SurfaceActor::set_edges(Edges edges) { actor_->GetProperty()->SetEdgeVisibility(edges == Edges::shown); }

void SurfaceActor::set_stripes(int count) {
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendStripes", count);
}

void SurfaceActor::recolor() { mapper_->Modified(); }

}  // namespace loopmend
