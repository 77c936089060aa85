// Where named widgets stand on the screen, so that tests and recordings find them by name.
#pragma once

#include <glm/glm.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::ui {

struct WidgetRect {
    glm::vec2 low{0, 0}, high{0, 0};  // px of the window
    glm::vec2 centre() const { return 0.5f * (low + high); }
};

// Rebuilt by every frame; names are paths such as `inspector/radius` or `canvas/node/12/a`.
class WidgetRects {
public:
    void begin_frame() { rects_.clear(); }
    // The last item drawn. Cheap when nobody listens.
    void mark(std::string_view name);
    void mark(std::string_view name, WidgetRect rect);
    std::optional<WidgetRect> find(std::string_view name) const;
    const std::map<std::string, WidgetRect, std::less<>>& all() const { return rects_; }

    bool listening = false;

private:
    std::map<std::string, WidgetRect, std::less<>> rects_;
};

}  // namespace fieldwright::ui
