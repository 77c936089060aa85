// GLFW and Dear ImGui's backends; GLFW's callbacks only queue what happened.
#include "app/window.h"

#include "graph/problem.h"
#include "ui/keys.h"

#include <epoxy/gl.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace fieldwright::app {
namespace {

using Kind = ui::InputEvent::Kind;

static_assert(ui::key::del == GLFW_KEY_DELETE && ui::key::keypad_0 == GLFW_KEY_KP_0 && ui::key::f1 == GLFW_KEY_F1 &&
              ui::key::left_shift == GLFW_KEY_LEFT_SHIFT && ui::key::z == GLFW_KEY_Z && ui::key::count > GLFW_KEY_LAST);

constexpr float title_bar = 32;  // units high, about: the window manager's, which is there after the window
constexpr glm::ivec2 smallest_px{800, 500};

std::string last_error()
{
    const char* sentence = nullptr;
    glfwGetError(&sentence);
    return sentence ? sentence : "no reason given";
}

// Letters by what is printed on the key, not by where an American keyboard has it.
int layout_key(int key, int scancode)
{
    if (key < GLFW_KEY_A || key > GLFW_KEY_Z) return key;
    const char* name = glfwGetKeyName(key, scancode);
    bool letter = name && name[0] >= 'a' && name[0] <= 'z' && name[1] == 0;
    return letter ? name[0] - 'a' + GLFW_KEY_A : key;
}

// The size, or less where the screen has less room. On a screen of many pixels an inch each unit is more than one.
glm::ivec2 size_on_screen(glm::ivec2 size)
{
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    glm::ivec4 area{0, 0, 0, 0};
    glm::vec2 scale{1, 1};
    if (monitor) glfwGetMonitorWorkarea(monitor, &area.x, &area.y, &area.z, &area.w);
    if (monitor) glfwGetMonitorContentScale(monitor, &scale.x, &scale.y);
    return area.z > 0 && area.w > 0 ? fitting_size(size, {area.z, area.w}, scale) : size;
}

}  // namespace

glm::ivec2 fitting_size(glm::ivec2 wanted, glm::ivec2 area_px, glm::vec2 scale)
{
    glm::vec2 most = glm::vec2(area_px) / scale - glm::vec2(0, title_bar);
    return glm::max(glm::ivec2(1), glm::min(wanted, glm::ivec2(most)));
}

void Window::ContextDeleter::operator()(ImGuiContext* context) const { ImGui::DestroyContext(context); }

Window::Window(const std::string& title, glm::ivec2 size)
{
    glfwSetErrorCallback(nullptr);
    if (!glfwInit())
        throw graph::Failure(
            4, "no window can be opened (" + last_error() + "); the commands of `fieldwright --help` work without one");
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, GLFW_TRUE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "fieldwright");
    size = size_on_screen(size);
    window_ = glfwCreateWindow(size.x, size.y, title.c_str(), nullptr, nullptr);
    if (!window_) {
        std::string reason = last_error();
        glfwTerminate();
        throw graph::Failure(4, "the display offers no OpenGL 3.3 window (" + reason +
                                    "); the commands of `fieldwright --help` work without one");
    }
    glm::ivec2 smallest = glm::min(smallest_px, size_px());
    glfwSetWindowSizeLimits(window_, smallest.x, smallest.y, GLFW_DONT_CARE, GLFW_DONT_CARE);
    glfwMakeContextCurrent(window_);
    glfwSwapInterval(1);
    context_.reset(ImGui::CreateContext());
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = io.LogFilename = nullptr;
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    ImGui_ImplGlfw_InitForOpenGL(window_, false);
    ImGui_ImplOpenGL3_Init("#version 330");
    ui::map_keys(io);
    theme_ = ui::make_theme(content_scale());
    connect_input();
}

Window::~Window()
{
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    context_.reset();
    glfwDestroyWindow(window_);
    glfwTerminate();
}

void Window::push(ui::InputEvent event)
{
    input.push(event);
    touched_ = true;
}

void Window::connect_input()
{
    glfwSetWindowUserPointer(window_, this);
    static constexpr auto self = [](GLFWwindow* window) {
        return static_cast<Window*>(glfwGetWindowUserPointer(window));
    };
    glfwSetCursorPosCallback(window_, [](GLFWwindow* window, double x, double y) {
        self(window)->push({.kind = Kind::move, .at = {static_cast<float>(x), static_cast<float>(y)}});
    });
    glfwSetMouseButtonCallback(window_, [](GLFWwindow* window, int button, int action, int) {
        self(window)->push({.kind = Kind::button, .code = button, .down = action == GLFW_PRESS});
    });
    glfwSetScrollCallback(window_, [](GLFWwindow* window, double x, double y) {
        self(window)->push({.kind = Kind::wheel, .at = {static_cast<float>(x), static_cast<float>(y)}});
    });
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int scancode, int action, int) {
        if (key >= 0 && action != GLFW_REPEAT)
            self(window)->push({.kind = Kind::key, .code = layout_key(key, scancode), .down = action == GLFW_PRESS});
    });
    glfwSetCharCallback(window_, [](GLFWwindow* window, unsigned codepoint) {
        self(window)->push({.kind = Kind::character, .code = static_cast<int>(codepoint)});
    });
    glfwSetCursorEnterCallback(window_, [](GLFWwindow* window, int entered) {
        if (!entered) self(window)->forget_mouse();
    });
    glfwSetWindowFocusCallback(window_, [](GLFWwindow* window, int focused) {
        self(window)->push({.kind = Kind::focus, .down = focused == GLFW_TRUE});
        if (focused) self(window)->find_mouse();
    });
    glfwSetWindowCloseCallback(window_, [](GLFWwindow* window) {
        glfwSetWindowShouldClose(window, GLFW_FALSE);
        self(window)->close_asked_ = self(window)->touched_ = true;
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        self(window)->dropped_.assign(paths, paths + count);
        self(window)->touched_ = true;
    });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* window) { self(window)->touched_ = true; });
    glfwSetFramebufferSizeCallback(window_, [](GLFWwindow* window, int, int) { self(window)->touched_ = true; });
}

// Under a window that appears or comes back, the mouse need not move to be there.
void Window::find_mouse()
{
    double x = 0, y = 0;
    glfwGetCursorPos(window_, &x, &y);
    if (glfwGetWindowAttrib(window_, GLFW_HOVERED))
        push({.kind = Kind::move, .at = {static_cast<float>(x), static_cast<float>(y)}});
}

// It left; nothing stays lit under it. A drag goes on outside.
void Window::forget_mouse()
{
    for (int button = GLFW_MOUSE_BUTTON_1; button <= GLFW_MOUSE_BUTTON_3; ++button)
        if (glfwGetMouseButton(window_, button) == GLFW_PRESS) return;
    push({.kind = Kind::move, .at = glm::vec2(-std::numeric_limits<float>::max())});
}

float Window::content_scale() const
{
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return std::clamp(std::round(4 * x) / 4, 0.75f, 4.0f);
}

void Window::update_theme()
{
    if (content_scale() == theme_.scale) return;
    theme_ = ui::make_theme(content_scale());
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Window::wait(double seconds)
{
    if (seconds > 0) glfwWaitEventsTimeout(seconds);
    else glfwPollEvents();
}

void Window::wake() { glfwPostEmptyEvent(); }

void Window::begin_frame()
{
    touched_ = false;
    update_theme();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    input.pass(ImGui::GetIO());
    ImGui::NewFrame();
}

void Window::end_frame() { ImGui::Render(); }

void Window::draw_frame()
{
    glm::ivec2 size = size_px();
    glViewport(0, 0, size.x, size.y);
    ImVec4 background = ImGui::ColorConvertU32ToFloat4(ui::colour::window);
    glClearColor(background.x, background.y, background.z, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void Window::show_frame() { glfwSwapBuffers(window_); }

void Window::rename(const std::string& title) { glfwSetWindowTitle(window_, title.c_str()); }
void Window::resize(glm::ivec2 size) { glfwSetWindowSize(window_, size.x, size.y); }
bool Window::close_asked() { return std::exchange(close_asked_, false); }
std::vector<std::string> Window::dropped_files() { return std::exchange(dropped_, {}); }
bool Window::visible() const { return !glfwGetWindowAttrib(window_, GLFW_ICONIFIED) && size_px().x > 0; }
std::string Window::renderer_name() const { return reinterpret_cast<const char*>(glGetString(GL_RENDERER)); }

glm::ivec2 Window::size_px() const
{
    glm::ivec2 size;
    glfwGetFramebufferSize(window_, &size.x, &size.y);
    return size;
}

std::vector<unsigned char> Window::screenshot() const
{
    glm::ivec2 size = size_px();
    auto width = static_cast<std::size_t>(size.x) * 3, height = static_cast<std::size_t>(size.y);
    std::vector<unsigned char> bottom_up(width * height), top_down(width * height);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadBuffer(GL_BACK);
    glReadPixels(0, 0, size.x, size.y, GL_RGB, GL_UNSIGNED_BYTE, bottom_up.data());
    for (std::size_t y = 0; y < height; ++y)
        std::copy_n(&bottom_up[(height - 1 - y) * width], width, &top_down[y * width]);
    return top_down;
}

}  // namespace fieldwright::app
