// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/surface_actor.h"

#include <vtkActor.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkLookupTable.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLPolyDataMapper.h>
#include <vtkPlane.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkShaderProperty.h>
#include <vtkTexture.h>
#include <vtkTypeInt32Array.h>
#include <vtkUniforms.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <utility>

namespace loopmend {

/// Can give its arrays to the graphics before it draws. Of one that never drew, the window knows nothing: to be deleted where the
/// window's graphics are current.
class SendingMapper : public vtkOpenGLPolyDataMapper {
 public:
  static SendingMapper* New();
  vtkTypeMacro(SendingMapper, vtkOpenGLPolyDataMapper) SendingMapper(const SendingMapper&) = delete;
  void operator=(const SendingMapper&) = delete;

  void send(vtkRenderer* renderer, vtkActor* actor) {
    CurrentInput = GetInput();
    UpdateBufferObjects(renderer, actor);
  }

 protected:
  SendingMapper() = default;
  ~SendingMapper() override = default;
};

vtkStandardNewMacro(SendingMapper);

namespace {

constexpr Rgb scan_color{0.80, 0.785, 0.755};
constexpr Rgb edge_color{0.22, 0.25, 0.30};
constexpr float edge_width = 0.5F;
constexpr int default_stripes = 9;
constexpr float patch_lift = 0.00004F;

constexpr std::chrono::milliseconds a_moment{150}, shortest_way{60};
constexpr std::chrono::seconds longest_way{10};

// Two programs for all shadings, one with stripes and one without: software graphics work through all of a program at
// every pixel, whichever way it branches, and take a quarter of a second to compile another one.
// There is no ambient light: VTK leaves in the ambient colour how much of a triangle's edge lies on the pixel.
// Key light over the left shoulder, soft fill from the right, a little sky: in view coordinates, so it follows the eye.
// The inside of the surface is dull, brown and darker, so that a hole reads as a hole, and lit as the outside is: VTK has turned
// its normals to the eye. Of a sheet seen from behind, or a scan that is inside out, it is all that is seen.
constexpr const char* beginning = R"(//VTK::Light::Impl
  vec3 loopmendNormal = normalVCVSOutput;  // VTK has made it a unit vector
  float loopmendEdge = clamp(ambientColor.b / loopmendEdgeColor.b, 0.0, 1.0);
  float key = max(0.0, dot(loopmendNormal, normalize(vec3(-0.45, 0.55, 0.75))));
  float fill = max(0.0, dot(loopmendNormal, normalize(vec3(0.75, -0.10, 0.55))));
  float amount = 0.51 + 0.42 * key + 0.12 * fill + 0.05 * loopmendNormal.y;
)";
constexpr const char* plain_or_colored = R"(
  vec3 loopmendBase = loopmendColored == 1 ? diffuseColor / max(0.05, 1.0 - loopmendEdge) : loopmendPlain;
  float shine = max(0.0, dot(loopmendNormal, normalize(vec3(-0.25, 0.35, 1.0))));
  shine *= shine;
  shine *= shine;
  shine *= shine;
  float loopmendShine = 0.07 * shine * shine * shine * shine * shine;
)";
constexpr const char* striped = R"(
  vec3 mirrored = reflect(normalize(vertexVC.xyz), loopmendNormal);
  float band = loopmendShading == 3 ? 0.5 + 0.5 * mirrored.y / max(1e-3, length(mirrored) + abs(mirrored.z) * 0.35)
                                    : 0.5 + 0.5 * dot(loopmendNormal, normalize(vec3(-0.35, 0.75, 0.55)));
  float stripe = sin(float(loopmendStripes) * 3.14159265 * (loopmendShading == 3 ? band : 2.0 * band));
  float soft = clamp(fwidth(stripe) * 0.9, 0.02, 1.0);
  vec3 loopmendBase = mix(vec3(0.11, 0.12, 0.14), vec3(0.94, 0.94, 0.92), smoothstep(-soft, soft, stripe));
  float loopmendShine = 0.0;
  amount = mix(1.0, amount, 0.45);
)";
constexpr const char* ending = R"(
  float loopmendMixed = loopmendTint;
  if (loopmendHatch > 0.0)
    loopmendMixed *= step(mod(gl_FragCoord.x + gl_FragCoord.y, loopmendHatch), loopmendHatch / 6.0);
  loopmendBase = mix(loopmendBase, vec3(0.25, 0.75, 0.30), loopmendMixed);
  vec3 loopmendLit = gl_FrontFacing ? loopmendBase * amount + loopmendShine
                                    : mix(loopmendBase, vec3(0.60, 0.50, 0.45), 0.75) * amount;
  fragOutput0 = vec4(mix(loopmendLit, loopmendEdgeColor, loopmendEdge), 1.0);
)";
// A patch lies on top of the rings that it shares with the scan, hence the tiny shift in depth. Made for each vertex:
// a depth made for each pixel would keep the graphics from leaving out early what is hidden. The program is the scan's, too.
constexpr const char* lifted = R"(//VTK::PositionVC::Impl
  gl_Position.z -= loopmendLift * gl_Position.w;
)";

vtkNew<vtkFloatArray> wrap(const std::vector<float>& values, int components, const char* name) {
  vtkNew<vtkFloatArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(components);
  // The shape is kept alive, and never written to, as long as the arrays are in use.
  array->SetArray(const_cast<float*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

vtkNew<vtkUnsignedCharArray> wrap_colors(const std::vector<unsigned char>& values) {
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("colors");
  array->SetNumberOfComponents(3);
  array->SetArray(const_cast<unsigned char*>(values.data()), static_cast<vtkIdType>(values.size()), 1);
  return array;
}

vtkNew<vtkTexture> texture_of(const Picture& picture) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* out = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int y = picture.height - 1; y >= 0; --y)  // VTK begins below
    for (int x = 0; x < picture.width; ++x)
      for (std::size_t k = 0; k < 3; ++k) *out++ = picture.at(x, y)[k];
  vtkNew<vtkTexture> texture;
  texture->SetInputData(image);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOn();
  return texture;
}

vtkNew<vtkFloatArray> unknown_everywhere(const SurfaceShapePtr& shape) {
  vtkNew<vtkFloatArray> array;
  array->SetName("values");
  array->SetNumberOfValues(shape ? static_cast<vtkIdType>(shape->points.size() / 3) : 0);
  array->FillValue(0);
  return array;
}

/// Where each triangle begins: 0, 3, 6, ... The slices of a large scan share one table, which saves 4 bytes a triangle.
vtkNew<vtkTypeInt32Array> offsets_of_triangles(vtkIdType count) {
  constexpr std::size_t shared_size = 1 << 16;
  static const std::vector<vtkTypeInt32> shared = [] {
    std::vector<vtkTypeInt32> table(shared_size);
    for (std::size_t i = 0; i < shared_size; ++i) table[i] = static_cast<vtkTypeInt32>(3 * i);
    return table;
  }();
  vtkNew<vtkTypeInt32Array> offsets;
  if (static_cast<std::size_t>(count) < shared_size) {
    offsets->SetArray(const_cast<vtkTypeInt32*>(shared.data()), count + 1, 1);
    return offsets;
  }
  offsets->SetNumberOfValues(count + 1);
  for (vtkIdType i = 0; i <= count; ++i) offsets->SetValue(i, static_cast<vtkTypeInt32>(3 * i));
  return offsets;
}

vtkNew<vtkCellArray> wrap_triangles(const TriangleList& triangles, vtkIdType count) {
  const vtkNew<vtkTypeInt32Array> offsets = offsets_of_triangles(count);
  vtkNew<vtkTypeInt32Array> connectivity;
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
  shader->AddVertexShaderReplacement("//VTK::PositionVC::Impl", true, lifted, false);
  shader->GetVertexCustomUniforms()->SetUniformf("loopmendLift", role == Role::patch ? patch_lift : 0);
  choose_program();
  shader->GetFragmentCustomUniforms()->SetUniformi("loopmendShading", static_cast<int>(shading_));
  std::array<float, 3> plain{}, edge{};
  std::copy(color.begin(), color.end(), plain.begin());
  shader->GetFragmentCustomUniforms()->SetUniform3f("loopmendPlain", plain.data());
  std::copy(edge_color.begin(), edge_color.end(), edge.begin());
  shader->GetFragmentCustomUniforms()->SetUniform3f("loopmendEdgeColor", edge.data());
  shader->GetFragmentCustomUniforms()->SetUniformi("loopmendColored", 0);
  update_tint();
  set_stripes(default_stripes);
}

SurfaceActor::~SurfaceActor() = default;

vtkActor* SurfaceActor::actor() const { return actor_; }

void SurfaceActor::set_shape(SurfaceShapePtr shape, Arrival arrival, Clock::time_point now) {
  const bool known = shape == shape_;
  if (known && (!glide_ || arrival == Arrival::with_the_next)) return;
  if (!known && arrival != Arrival::at_once && shape_ && ShapeGlide::is_possible(*shape_, *shape)) {
    glide(std::move(shape), arrival, now);
  } else if (known && arrival == Arrival::soon) {
    glide_->hurry(now, now + a_moment);
  } else {
    if (arrival == Arrival::with_the_next) last_news_ = now;
    show(std::move(shape));
  }
}

/// As it is, without a copy.
void SurfaceActor::show(SurfaceShapePtr shape) {
  // The old arrays stay valid until they are replaced.
  const SurfaceShapePtr old = std::move(shape_);
  const std::unique_ptr<ShapeGlide> old_glide = std::move(glide_);
  shape_ = std::move(shape);
  vtkNew<vtkPoints> points;
  points->SetData(wrap(shape_->points, 3, "points"));
  data_->SetPoints(points);
  data_->GetPointData()->SetNormals(wrap(shape_->normals, 3, "normals"));
  update_triangles();
  update_scalars();
}

/// The time that the last state took to come is about what the next one will take; some more, since a surface that waits
/// for a late one looks stuck.
void SurfaceActor::glide(SurfaceShapePtr shape, Arrival arrival, Clock::time_point now) {
  Clock::duration time = a_moment;
  if (arrival == Arrival::with_the_next && last_news_)
    time = std::clamp<Clock::duration>((now - *last_news_) * 4 / 3, shortest_way, longest_way);
  last_news_ = now;
  if (glide_) glide_->advance(now);
  auto next = std::make_unique<ShapeGlide>(glide_ ? glide_->shown() : *shape_, shape, now, time);
  const std::unique_ptr<ShapeGlide> old = std::exchange(glide_, std::move(next));
  const SurfaceShapePtr old_shape = std::exchange(shape_, std::move(shape));
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

/// The rings around a patch continue its H and its reflections, but they are not the patch: where the scan's own colours stay,
/// or the patch has a tint, they go.
void SurfaceActor::update_triangles() {
  const auto all = static_cast<vtkIdType>(shape_->triangles.size() / 3);
  const bool with_rings = is_drawn_over_the_scan(shading_) && tint_ == Tint::none;
  const vtkIdType shown = with_rings ? all : shape_->own_triangles;
  // The same ones need not go to the graphics again.
  if (triangles_of_ && data_->GetNumberOfPolys() == shown && triangles_of_->triangles == shape_->triangles) return;
  data_->SetPolys(wrap_triangles(shape_->triangles, shown));
  triangles_of_ = shape_;
}

void SurfaceActor::update_scalars() {
  update_texture();
  if (shading_ == Shading::scan && shape_) {
    // While it glides, its vertices are the same.
    const std::size_t points = shape_->points.size() / 3;
    const bool known = shape_->colors.size() == 3 * points && points > 0;
    data_->GetPointData()->SetScalars(nullptr);
    if (known) data_->GetPointData()->SetScalars(wrap_colors(shape_->colors));
    mapper_->SetScalarVisibility(known);
    actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendColored", known ? 1 : 0);
    data_->Modified();
    return;
  }
  mapper_->ScalarVisibilityOn();
  const SurfaceShape* shown = glide_ ? &glide_->shown() : shape_.get();
  const bool known = shown && !values_of(*shown, shading_).empty();
  data_->GetPointData()->SetScalars(known ? wrap(values_of(*shown, shading_), 1, "values")
                                          : unknown_everywhere(shape_));
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendColored", known ? 1 : 0);
  data_->Modified();
}

/// A picture multiplies what is drawn, so the surface itself is white.
void SurfaceActor::update_texture() {
  const bool textured = shading_ == Shading::scan && shape_ && shape_->picture && !shape_->texture.empty();
  data_->GetPointData()->SetTCoords(nullptr);
  if (textured) data_->GetPointData()->SetTCoords(wrap(shape_->texture, 2, "texture"));
  const auto picture = textured ? shape_->picture : nullptr;
  if (picture != picture_) {
    picture_ = picture;
    actor_->SetTexture(nullptr);
    if (picture) actor_->SetTexture(texture_of(*picture));
  }
  std::array<float, 3> plain{1, 1, 1};
  const Rgb& color = role_ == Role::scan ? scan_color : patch_color;
  if (!textured) std::copy(color.begin(), color.end(), plain.begin());
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniform3f("loopmendPlain", plain.data());
}

void SurfaceActor::choose_program() {
  const std::string code = std::string(beginning) + (has_stripes(shading_) ? striped : plain_or_colored) + ending;
  actor_->GetShaderProperty()->AddFragmentShaderReplacement("//VTK::Light::Impl", true, code, false);
}

void SurfaceActor::set_shading(Shading shading) {
  if (shading == shading_) return;
  const auto has_colors = [](Shading s) { return is_colored(s) || s == Shading::scan; };
  const bool other_scalars = has_colors(shading) || has_colors(shading_);
  const bool other_program = has_stripes(shading) != has_stripes(shading_);
  shading_ = shading;
  if (other_program) choose_program();
  if (shape_ && role_ == Role::patch) update_triangles();
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendShading", static_cast<int>(shading));
  update_tint();
  if (shape_ && other_scalars) update_scalars();
}

void SurfaceActor::set_tint(Tint tint) {
  if (role_ != Role::patch || std::exchange(tint_, tint) == tint) return;
  update_tint();
  if (shape_) update_triangles();
}

/// Over a colour map it is a hatching, since a mixed colour would be read as another value; where patches alone have colours,
/// there is none.
void SurfaceActor::update_tint() {
  constexpr float strength = 0.4F, of_hatching = 0.8F;
  constexpr float hatching = 12;  // logical pixels
  const bool is_map = is_colored(shading_), has_tint = tint_ == Tint::patches && !colors_patches_alone(shading_);
  vtkUniforms* uniforms = actor_->GetShaderProperty()->GetFragmentCustomUniforms();
  uniforms->SetUniformf("loopmendTint", !has_tint ? 0 : is_map ? of_hatching : strength);
  uniforms->SetUniformf("loopmendHatch", is_map ? hatching * pixel_ratio_ : 0);
}

void SurfaceActor::set_pixel_ratio(double ratio) {
  pixel_ratio_ = static_cast<float>(ratio);
  update_tint();
}

void SurfaceActor::set_edges(Edges edges) { actor_->GetProperty()->SetEdgeVisibility(edges == Edges::shown); }

void SurfaceActor::set_clipping(vtkPlane* plane) {
  mapper_->RemoveAllClippingPlanes();
  if (plane) mapper_->AddClippingPlane(plane);
}

void SurfaceActor::set_stripes(int count) {
  actor_->GetShaderProperty()->GetFragmentCustomUniforms()->SetUniformi("loopmendStripes", count);
}

void SurfaceActor::set_table(vtkLookupTable* table) { mapper_->SetLookupTable(table); }

void SurfaceActor::recolor() { mapper_->Modified(); }

void SurfaceActor::share_texture(const SurfaceActor& other) {
  picture_ = other.picture_;
  actor_->SetTexture(other.actor_->GetTexture());
}

void SurfaceActor::send(vtkRenderer* renderer) {
  vtkRenderWindow* window = renderer->GetRenderWindow();
  if (!window || window->GetNeverRendered()) return;
  window->MakeCurrent();
  mapper_->send(renderer, actor_);
}

}  // namespace loopmend
