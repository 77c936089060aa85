// A GL 3.3 core context without a window or a display server, on EGL.
#pragma once

namespace fieldwright::renderer {

// Hardware first, then Mesa's software renderer. Current on the thread that made it until another is made current.
class HeadlessContext {
public:
    HeadlessContext();  // throws graph::Failure{4}
    ~HeadlessContext();
    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

    void make_current() const;

private:
    void* display_ = nullptr;
    void* context_ = nullptr;
};

}  // namespace fieldwright::renderer
