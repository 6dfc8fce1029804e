// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/offscreen_window.h"

#include "core/error.h"

#include <vtk_glew.h>

#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLState.h>

#define EGL_NO_X11
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <memory>

namespace loopmend {
namespace {

class EglContext {
 public:
  EglContext() {
    const auto platform_display =
        reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    if (platform_display) display_ = platform_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
    if (display_ == EGL_NO_DISPLAY) display_ = eglGetDisplay(EGL_DEFAULT_DISPLAY);
    if (display_ == EGL_NO_DISPLAY || !eglInitialize(display_, nullptr, nullptr)) fail(say("EGL does not start"));
    if (!eglBindAPI(EGL_OPENGL_API)) fail(say("EGL has no desktop OpenGL"));
    const EGLint config_wanted[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
    EGLConfig config{};
    EGLint count = 0;
    if (!eglChooseConfig(display_, config_wanted, &config, 1, &count) || count == 0)
      fail(say("no EGL configuration fits"));
    const EGLint context_wanted[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 2, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    context_ = eglCreateContext(display_, config, EGL_NO_CONTEXT, context_wanted);
    if (context_ == EGL_NO_CONTEXT) fail(say("no OpenGL 3.2 context"));
  }
  ~EglContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
  }
  EglContext(const EglContext&) = delete;
  EglContext& operator=(const EglContext&) = delete;

  void make_current() { eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_); }
  bool is_current() const { return eglGetCurrentContext() == context_; }

 private:
  [[noreturn]] static void fail(const Message& why) {
    throw Error(
        say("cannot draw without a display: %1. Install the package libegl-mesa0 (software rendering) or a graphics "
            "driver with EGL.",
            why));
  }

  EGLDisplay display_ = EGL_NO_DISPLAY;
  EGLContext context_ = EGL_NO_CONTEXT;
};

class EglRenderWindow : public vtkGenericOpenGLRenderWindow {
 public:
  static EglRenderWindow* New();
  vtkTypeMacro(EglRenderWindow, vtkGenericOpenGLRenderWindow)

      void adopt(std::unique_ptr<EglContext> context) {
    context_ = std::move(context);
  }
  void MakeCurrent() override { context_->make_current(); }
  bool IsCurrent() override { return context_ && context_->is_current(); }
  int SupportsOpenGL() override { return 1; }
  vtkTypeBool IsDirect() override { return 1; }
  void Frame() override {}
  // There are none without a surface. VTK 9.3 would ask OpenGL, and prints that it failed.
  int GetColorBufferSizes(int* rgba) override {
    for (int i = 0; i < 4; ++i) rgba[i] = 0;
    return 0;
  }

 protected:
  EglRenderWindow() = default;
  ~EglRenderWindow() override {
    if (context_) Finalize();
  }

  // As the base class does, but GLEW built for GLX says "no GLX display" after it has loaded everything we need.
  void OpenGLInitContext() override {
    if (Initialized) return;
    constexpr GLenum no_glx_display = 4;
    const GLenum result = glewInit();
    GlewInitValid = result == GLEW_OK || result == no_glx_display;
    Initialized = GlewInitValid;
    if (!GlewInitValid) return;
    float widths[2] = {1, 1};
    glGetFloatv(GL_ALIASED_LINE_WIDTH_RANGE, widths);
    MaximumHardwareLineWidth = widths[1];
  }

 private:
  std::unique_ptr<EglContext> context_;
};

vtkStandardNewMacro(EglRenderWindow)

}  // namespace

vtkSmartPointer<vtkRenderWindow> make_offscreen_window(int width, int height) {
  auto context = std::make_unique<EglContext>();
  auto window = vtkSmartPointer<EglRenderWindow>::New();
  window->adopt(std::move(context));
  window->SetOwnContext(1);
  window->SetMapped(0);
  window->SetShowWindow(false);
  window->SetUseOffScreenBuffers(true);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  window->MakeCurrent();
  window->OpenGLInit();
  window->GetState()->Initialize(window);
  glDepthFunc(GL_LEQUAL);  // what VTK takes for granted; a bare context starts with another rule
  return window;
}

}  // namespace loopmend
