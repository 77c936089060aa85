// Drawing and searching the add menu.
#include "ui/add_menu.h"

#include "ui/keys.h"
#include "ui/node_words.h"

#include "graph/custom_nodes.h"
#include "graph/groups.h"
#include "graph/search.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>

namespace fieldwright::ui {

using graph::NodeType;

namespace {

constexpr const char* popup_name = "add_menu";
constexpr float menu_width = 460, menu_height = 372, column_width = 112;  // design px
constexpr std::size_t recent_limit = 8;

// What a scene is built from first comes first; others follow by name.
constexpr std::array<std::string_view, 14> category_order = {
    "primitive", "shape2d", "combine", "modify", "domain", "convert",   "material",
    "light",     "camera",  "sky",     "value",  "group",  "my_groups", own_category};

std::size_t category_rank(std::string_view category)
{
    return static_cast<std::size_t>(std::find(category_order.begin(), category_order.end(), category) -
                                    category_order.begin());
}

void ellipsised(ImVec2 at, float right, ImU32 colour, std::string_view text)
{
    ImVec2 size = ImGui::CalcTextSize(text.data(), text.data() + text.size());
    ImGui::PushStyleColor(ImGuiCol_Text, colour);
    ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, {right, at.y + size.y}, right, right, text.data(),
                              text.data() + text.size(), &size);
    ImGui::PopStyleColor();
}

bool has_output_node(const graph::Document& document, const graph::Library& library)
{
    return std::any_of(document.root.nodes.begin(), document.root.nodes.end(), [&](const graph::Node& node) {
        const NodeType* type = library.type(node.type);
        return type && type->category == "output";
    });
}

std::vector<const NodeType*> fitting(const Draft& draft, const graph::LooseEnd& end)
{
    std::vector<const NodeType*> types;
    for (const graph::Fit& fit : graph::fits(draft.document, draft.library, end)) types.push_back(fit.type);
    return types;
}

std::vector<NodeType> own_beginnings()
{
    std::vector<NodeType> types;
    for (const graph::CustomTemplate& custom : graph::custom_templates()) {
        NodeType& type = types.emplace_back();
        type.name = std::string(own_prefix) + std::string(custom.name);
        type.category = own_category;
        type.title = custom.title;
        type.help = custom.help;
        type.synonyms = {"own node", "code", "glsl", "write", "script"};
    }
    return types;
}

}  // namespace

AddMenu::AddMenu() : own_beginnings_(own_beginnings()) {}

void AddMenu::open(glm::vec2 at_px, AddPlace place)
{
    at_px_ = at_px;
    place_ = std::move(place);
    opening_ = true;
}

void AddMenu::remember(const std::string& type)
{
    std::erase(recent_, type);
    recent_.insert(recent_.begin(), type);
    if (recent_.size() > recent_limit) recent_.pop_back();
}

void AddMenu::find_offered(const Draft& draft, const std::vector<SavedGroup>& saved)
{
    offered_.clear();
    if (place_.end) offered_ = fitting(draft, *place_.end);
    else if (place_.on_wire) {
        const graph::Node* target = draft.document.root.find(place_.on_wire->node);
        if (!target) return;
        std::vector<const NodeType*> before = fitting(draft, {target->input(place_.on_wire->socket), ""});
        for (const NodeType* type : fitting(draft, {target->id, place_.on_wire->socket}))
            if (std::find(before.begin(), before.end(), type) != before.end()) offered_.push_back(type);
    } else {
        bool rooted = !draft.document.entered.empty() || has_output_node(draft.document, draft.library);
        for (const NodeType* type : draft.library.types())
            if (!rooted || type->category != "output") offered_.push_back(type);
        for (const SavedGroup& group : saved) offered_.push_back(&group.type);
        for (const NodeType& type : own_beginnings_) offered_.push_back(&type);
    }
    // A group cannot contain itself.
    std::erase_if(offered_, [&](const NodeType* type) {
        const graph::Group* group = graph::group_of(draft.document, type->name);
        return group && graph::contains(draft.document, group->name, draft.document.entered);
    });
    std::stable_sort(offered_.begin(), offered_.end(), [](const NodeType* a, const NodeType* b) {
        return category_rank(a->category) < category_rank(b->category);
    });
}

std::vector<std::string> AddMenu::categories() const
{
    std::vector<std::string> names;
    for (const NodeType* type : offered_) {
        if (std::find(recent_.begin(), recent_.end(), type->name) != recent_.end() &&
            (names.empty() || !names.front().empty()))
            names.insert(names.begin(), "");
        if (std::find(names.begin(), names.end(), type->category) == names.end()) names.push_back(type->category);
    }
    return names;
}

std::vector<const NodeType*> AddMenu::listed() const
{
    if (!query_.empty()) return graph::search_types(offered_, query_, recent_);
    std::vector<const NodeType*> types;
    auto take = [&](auto&& wanted) {
        std::copy_if(offered_.begin(), offered_.end(), std::back_inserter(types), wanted);
    };
    if (!category_.empty()) take([&](const NodeType* type) { return type->category == category_; });
    else
        for (const std::string& name : recent_) take([&](const NodeType* type) { return type->name == name; });
    return types;
}

const NodeType* AddMenu::draw(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    // Anew in every frame: the types of groups are others after every edit.
    if (opening_ || shown_) find_offered(frame.draft, frame.readings.saved_groups);
    if (opening_) {
        ImGui::OpenPopup(popup_name);
        query_.clear();
        std::vector<std::string> names = categories();
        category_ = names.empty() ? "" : names.front();
        highlight_ = 0;
    }
    glm::vec2 size{theme.px(menu_width), theme.px(menu_height)};
    const ImGuiViewport& window = *ImGui::GetMainViewport();
    glm::vec2 room{window.Size.x - theme.px(8), window.Size.y - theme.px(8)};
    glm::vec2 at = glm::max(glm::min(at_px_, room - size), glm::vec2(theme.px(8)));
    ImGui::SetNextWindowPos({at.x, at.y});
    ImGui::SetNextWindowSize({size.x, size.y});
    shown_ = ImGui::BeginPopup(popup_name, ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoScrollbar);
    const NodeType* picked = nullptr;
    if (shown_) {
        picked = draw_inside(frame);
        if (picked || ImGui::IsKeyPressed(key::escape, false)) ImGui::CloseCurrentPopup();
        ImGui::EndPopup();
    }
    opening_ = false;
    if (picked) remember(picked->name);
    return picked;
}

const NodeType* AddMenu::draw_inside(FrameContext& frame)
{
    bool entered = search_field(frame);
    bool browsing = query_.empty() && categories().size() > 1;
    if (browsing) {
        category_column(frame);
        ImGui::SameLine();
    }
    std::vector<const NodeType*> types = listed();
    move_highlight(static_cast<int>(types.size()));
    const NodeType* clicked = entries(frame, types);
    if (entered && !types.empty()) return types[static_cast<std::size_t>(highlight_)];
    return clicked;
}

// True when Enter was pressed.
bool AddMenu::search_field(FrameContext& frame)
{
    if (opening_) frame.focus_next_text();
    ImGui::SetNextItemWidth(-1);
    std::string hint = place_.end || place_.on_wire ? "Search what fits" : "Search nodes to add";
    std::string before = query_;
    ImGui::PushStyleColor(ImGuiCol_FrameBg, colour::window);
    bool entered = ImGui::InputTextWithHint("##search", hint.c_str(), &query_,
                                            ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    ImGui::PopStyleColor();
    frame.rects.mark("add_menu/search");
    // The key that opened the menu may have typed a space.
    query_.erase(0, std::min(query_.find_first_not_of(' '), query_.size()));
    if (query_ != before) highlight_ = 0, scroll_to_highlight_ = true;
    return entered;
}

void AddMenu::move_highlight(int count)
{
    int before = highlight_;
    if (ImGui::IsKeyPressed(key::down)) ++highlight_;
    if (ImGui::IsKeyPressed(key::up)) --highlight_;
    highlight_ = std::clamp(highlight_, 0, std::max(count - 1, 0));
    scroll_to_highlight_ = scroll_to_highlight_ || highlight_ != before;
}

void AddMenu::category_column(FrameContext& frame)
{
    const Theme& theme = frame.theme;
    std::vector<std::string> names = categories();
    auto at = std::find(names.begin(), names.end(), category_);
    int index = static_cast<int>(at - names.begin()), last = static_cast<int>(names.size()) - 1;
    int step = static_cast<int>(ImGui::IsKeyPressed(key::right)) - static_cast<int>(ImGui::IsKeyPressed(key::left));
    int chosen = std::clamp(index + step, 0, last);
    ImGui::BeginChild("categories", {theme.px(column_width), 0});
    for (int i = 0; i <= last; ++i) {
        const std::string& name = names[static_cast<std::size_t>(i)];
        std::string words = name.empty() ? "Recent" : category_title(name);
        ImVec2 corner = ImGui::GetCursorScreenPos();
        if (ImGui::Selectable(("##" + words).c_str(), i == chosen, 0, {0, theme.row()})) chosen = i;
        frame.rects.mark("add_menu/category/" + (name.empty() ? "recent" : name));
        float middle = corner.y + 0.5f * theme.row();
        if (!name.empty())
            ImGui::GetWindowDrawList()->AddRectFilled({corner.x + theme.px(4), middle - theme.px(7)},
                                                      {corner.x + theme.px(8), middle + theme.px(7)},
                                                      category_colour(name), theme.px(2));
        ellipsised({corner.x + theme.px(14), middle - 0.5f * ImGui::GetFontSize()}, corner.x + theme.px(column_width),
                   i == chosen ? colour::text : colour::quiet_text, words);
    }
    ImGui::EndChild();
    if (chosen == index) return;
    category_ = names[static_cast<std::size_t>(chosen)];
    highlight_ = 0;
    scroll_to_highlight_ = true;
}

const NodeType* AddMenu::entries(FrameContext& frame, const std::vector<const NodeType*>& types)
{
    const NodeType* picked = nullptr;
    ImGui::BeginChild("entries", {0, 0});
    if (types.empty()) {
        ImGui::PushTextWrapPos(0);
        ImGui::TextDisabled(query_.empty() ? "Nothing fits here." : "Nothing is called that. Try another word.");
        ImGui::PopTextWrapPos();
    }
    for (std::size_t i = 0; i < types.size(); ++i)
        if (entry(frame, *types[i], static_cast<int>(i) == highlight_)) picked = types[i];
    scroll_to_highlight_ = false;
    ImGui::EndChild();
    return picked;
}

bool AddMenu::entry(FrameContext& frame, const NodeType& type, bool highlighted)
{
    const Theme& theme = frame.theme;
    float height = theme.px(40);
    ImVec2 corner = ImGui::GetCursorScreenPos();
    float right = corner.x + ImGui::GetContentRegionAvail().x - theme.px(4);
    bool picked =
        ImGui::Selectable(("##" + type.name).c_str(), highlighted, ImGuiSelectableFlags_DontClosePopups, {0, height});
    frame.rects.mark("add_menu/item/" + type.name);
    if (highlighted && scroll_to_highlight_) ImGui::SetScrollHereY();
    ImGui::GetWindowDrawList()->AddRectFilled({corner.x + theme.px(4), corner.y + theme.px(5)},
                                              {corner.x + theme.px(8), corner.y + height - theme.px(5)},
                                              category_colour(type.category), theme.px(2));
    float left = corner.x + theme.px(16);
    ImGui::PushFont(theme.fonts.small);
    std::string category = query_.empty() ? "" : category_title(type.category);
    float width = ImGui::CalcTextSize(category.c_str()).x;
    ellipsised({right - width, corner.y + theme.px(6)}, right + 1, colour::quiet_text, category);
    ellipsised({left, corner.y + theme.px(22)}, right, colour::quiet_text, type.help);
    ImGui::PopFont();
    ellipsised({left, corner.y + theme.px(4)}, right - width - theme.px(8), colour::text, type.title);
    return picked;
}

}  // namespace fieldwright::ui
