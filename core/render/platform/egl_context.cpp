// Measured on Mesa: requesting 3.1, or a version below 3.2 with a profile mask, may give a core context, in which the
// fixed-function names that OSG uses have no effect. Therefore 3.3 compatibility is requested and the result is checked.

#include "render/platform/egl_context.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>

#include <array>

namespace trundle {
namespace {

std::string eglWords() {
    switch (eglGetError()) {
    case EGL_SUCCESS: return "no display";
    case EGL_NOT_INITIALIZED: return "not initialised";
    case EGL_BAD_ALLOC: return "out of memory";
    case EGL_BAD_CONFIG: return "bad configuration";
    case EGL_BAD_MATCH: return "no such context";
    case EGL_BAD_DISPLAY: return "no display";
    default: return "failed";
    }
}

EGLDisplay platformDisplay(EGLenum platform, void* native) {
    const auto get = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(eglGetProcAddress("eglGetPlatformDisplayEXT"));
    return get ? get(platform, native, nullptr) : EGL_NO_DISPLAY;
}

EGLDisplay surfacelessDisplay() { return platformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY); }

EGLDisplay deviceDisplay() {
    const auto query = reinterpret_cast<PFNEGLQUERYDEVICESEXTPROC>(eglGetProcAddress("eglQueryDevicesEXT"));
    EGLDeviceEXT device = nullptr;
    EGLint count = 0;
    if (!query || !query(1, &device, &count) || count < 1) return EGL_NO_DISPLAY;
    return platformDisplay(EGL_PLATFORM_DEVICE_EXT, device);
}

EGLDisplay defaultDisplay() { return eglGetDisplay(EGL_DEFAULT_DISPLAY); }

std::string glText(GLenum name) {
    const auto* text = reinterpret_cast<const char*>(glGetString(name));
    return text ? text : "";
}

struct Opened {
    EGLDisplay display = EGL_NO_DISPLAY;
    EGLContext context = EGL_NO_CONTEXT;
    EGLSurface surface = EGL_NO_SURFACE;
};

// clang-format off
constexpr std::array<EGLint, 13> kConfig{
    EGL_SURFACE_TYPE, EGL_PBUFFER_BIT,
    EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
    EGL_RED_SIZE, 8,
    EGL_GREEN_SIZE, 8,
    EGL_BLUE_SIZE, 8,
    EGL_DEPTH_SIZE, 24,
    EGL_NONE};
constexpr std::array<EGLint, 7> kContext{
    EGL_CONTEXT_MAJOR_VERSION, 3,
    EGL_CONTEXT_MINOR_VERSION, 3,
    EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_COMPATIBILITY_PROFILE_BIT,
    EGL_NONE};
// clang-format on

/// Returns the reason of the failure, or an empty string when `opened` is current.
std::string open(EGLDisplay display, Opened& opened) {
    EGLint major = 0, minor = 0;
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, &major, &minor)) return eglWords();
    if (!eglBindAPI(EGL_OPENGL_API)) return "no OpenGL";
    EGLConfig config = nullptr;
    EGLint count = 0;
    if (!eglChooseConfig(display, kConfig.data(), &config, 1, &count) || count < 1)
        return "no configuration with 8 bits for each colour";
    const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, kContext.data());
    if (context == EGL_NO_CONTEXT) return eglWords();
    EGLSurface surface = EGL_NO_SURFACE;
    bool current = eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context);
    if (!current) {
        constexpr std::array<EGLint, 5> tiny{EGL_WIDTH, 16, EGL_HEIGHT, 16, EGL_NONE};
        surface = eglCreatePbufferSurface(display, config, tiny.data());
        current = surface != EGL_NO_SURFACE && eglMakeCurrent(display, surface, surface, context);
    }
    std::string why;
    if (!current) why = eglWords();
    else if (const std::string version = glText(GL_VERSION);
             version.empty() || version.find("Core") != std::string::npos || version.find("OpenGL ES") != std::string::npos)
        why = "\"" + version + "\" is not a compatibility context";
    if (why.empty()) {
        opened = {display, context, surface};
        return why;
    }
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (surface != EGL_NO_SURFACE) eglDestroySurface(display, surface);
    eglDestroyContext(display, context);
    return why;
}

} // namespace

Result<std::unique_ptr<EglContext>> EglContext::create() {
    struct DisplayOption {
        const char* name;
        EGLDisplay (*display)();
    };
    constexpr std::array<DisplayOption, 3> ways{
        {{"surfaceless", surfacelessDisplay}, {"device", deviceDisplay}, {"default display", defaultDisplay}}};
    std::string tried;
    for (const DisplayOption& way : ways) {
        Opened opened;
        const std::string why = open(way.display(), opened);
        if (why.empty()) {
            std::unique_ptr<EglContext> result(new EglContext);
            result->m_display = opened.display;
            result->m_context = opened.context;
            result->m_surface = opened.surface;
            result->m_version = glText(GL_VERSION);
            result->m_renderer = glText(GL_RENDERER);
            return result;
        }
        tried += std::string(tried.empty() ? "" : ", ") + way.name + ": " + why;
    }
    return Error{Code::NoGraphics, "no OpenGL to draw with (" + tried + ")"};
}

EglContext::~EglContext() {
    // The display is shared by the whole process and stays open.
    eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    if (m_surface) eglDestroySurface(m_display, m_surface);
    eglDestroyContext(m_display, m_context);
    eglReleaseThread();
}

} // namespace trundle
