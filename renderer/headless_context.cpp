// Finds an EGL display that works without a window and makes a context on it.
#include "renderer/headless_context.h"

#include "graph/problem.h"

#include <epoxy/egl.h>
#include <string_view>
#include <utility>
#include <vector>

namespace fieldwright::renderer {
namespace {

bool lists(const char* extensions, std::string_view name)
{
    std::string_view all = extensions ? extensions : "";
    for (std::size_t at = all.find(name); at != std::string_view::npos; at = all.find(name, at + 1)) {
        bool starts = at == 0 || all[at - 1] == ' ';
        std::size_t end = at + name.size();
        if (starts && (end == all.size() || all[end] == ' ')) return true;
    }
    return false;
}

// A display to try: the platform and its native handle.
using Candidate = std::pair<EGLenum, void*>;

// GPUs first, then Mesa's surfaceless platform, then software devices.
std::vector<Candidate> candidates()
{
    const char* client = eglQueryString(EGL_NO_DISPLAY, EGL_EXTENSIONS);
    std::vector<Candidate> hardware, software;
    if (!lists(client, "EGL_EXT_platform_base")) return {};
    if (lists(client, "EGL_EXT_platform_device") &&
        (lists(client, "EGL_EXT_device_enumeration") || lists(client, "EGL_EXT_device_base"))) {
        EGLDeviceEXT devices[16];
        EGLint count = 0;
        if (!eglQueryDevicesEXT(16, devices, &count)) count = 0;
        for (EGLint i = 0; i < count; ++i) {
            bool is_software = lists(eglQueryDeviceStringEXT(devices[i], EGL_EXTENSIONS), "EGL_MESA_device_software");
            (is_software ? software : hardware).push_back({EGL_PLATFORM_DEVICE_EXT, devices[i]});
        }
    }
    if (lists(client, "EGL_MESA_platform_surfaceless"))
        hardware.push_back({EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY});
    hardware.insert(hardware.end(), software.begin(), software.end());
    return hardware;
}

EGLDisplay open_display(const Candidate& candidate)
{
    EGLDisplay display = eglGetPlatformDisplayEXT(candidate.first, candidate.second, nullptr);
    if (display == EGL_NO_DISPLAY || !eglInitialize(display, nullptr, nullptr)) return EGL_NO_DISPLAY;
    const char* extensions = eglQueryString(display, EGL_EXTENSIONS);
    bool usable = lists(extensions, "EGL_KHR_surfaceless_context") && lists(extensions, "EGL_KHR_create_context");
    return usable ? display : EGL_NO_DISPLAY;
}

EGLConfig any_config(EGLDisplay display)
{
    if (lists(eglQueryString(display, EGL_EXTENSIONS), "EGL_KHR_no_config_context")) return EGL_NO_CONFIG_KHR;
    const EGLint wanted[] = {EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_SURFACE_TYPE, EGL_DONT_CARE, EGL_NONE};
    EGLConfig config = nullptr;
    EGLint count = 0;
    eglChooseConfig(display, wanted, &config, 1, &count);
    return config;
}

// Robust where the driver offers it: a hang resets the context instead of taking the process along.
EGLContext make_context(EGLDisplay display)
{
    if (!eglBindAPI(EGL_OPENGL_API)) return EGL_NO_CONTEXT;
    const EGLint plain[] = {
        EGL_CONTEXT_MAJOR_VERSION,           3,       EGL_CONTEXT_MINOR_VERSION, 3, EGL_CONTEXT_OPENGL_PROFILE_MASK,
        EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE};
    const EGLint robust[] = {EGL_CONTEXT_MAJOR_VERSION,
                             3,
                             EGL_CONTEXT_MINOR_VERSION,
                             3,
                             EGL_CONTEXT_OPENGL_PROFILE_MASK,
                             EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                             EGL_CONTEXT_OPENGL_ROBUST_ACCESS,
                             EGL_TRUE,
                             EGL_CONTEXT_OPENGL_RESET_NOTIFICATION_STRATEGY,
                             EGL_LOSE_CONTEXT_ON_RESET,
                             EGL_NONE};
    EGLConfig config = any_config(display);
    bool offers_robust = epoxy_egl_version(display) >= 15;
    EGLContext context = offers_robust ? eglCreateContext(display, config, EGL_NO_CONTEXT, robust) : EGL_NO_CONTEXT;
    return context != EGL_NO_CONTEXT ? context : eglCreateContext(display, config, EGL_NO_CONTEXT, plain);
}

}  // namespace

// Displays are the process's, shared by every context on them, and stay open.
HeadlessContext::HeadlessContext()
{
    if (!epoxy_has_egl())
        throw graph::Failure(4, "no EGL library is installed; install Mesa (libegl1) or use --device cpu");
    for (const Candidate& candidate : candidates()) {
        EGLDisplay display = open_display(candidate);
        if (display == EGL_NO_DISPLAY) continue;
        EGLContext context = make_context(display);
        if (context == EGL_NO_CONTEXT) continue;
        if (eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, context)) {
            display_ = display;
            context_ = context;
            return;
        }
        eglDestroyContext(display, context);
    }
    throw graph::Failure(
        4,
        "no graphics driver here offers OpenGL 3.3 without a window; install one (Mesa's libgl1-mesa-dri "
        "draws on any machine) or use --device cpu");
}

HeadlessContext::~HeadlessContext()
{
    if (eglGetCurrentContext() == context_) eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
}

void HeadlessContext::make_current() const
{
    if (!eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_))
        throw graph::Failure(4, "the graphics driver does not give its context back; use --device cpu");
}

}  // namespace fieldwright::renderer
