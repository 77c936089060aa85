// Lowering the live document, and what is asked of the result.
#include "app/shown_scene.h"

#include "app/blend_curve.h"
#include "app/measured_box.h"
#include "codegen/glsl.h"
#include "field/evaluator.h"

namespace fieldwright::app {
namespace {

const graph::Node* output_of(const graph::Document& document, const graph::Library& library)
{
    for (const graph::Node& node : document.root.nodes)
        if (const graph::NodeType* type = library.type(node.type); type && type->category == "output") return &node;
    return nullptr;
}

}  // namespace

// Whether only settings differ that no program knows.
bool ShownScene::is_drawn_alike(const graph::Document& document, const graph::Library& library,
                                const graph::BakedImages& images) const
{
    if (!program_ || &library != library_.get() || images != images_) return false;
    graph::Document other = document;
    other.picture = document_.picture;
    other.animation = document_.animation;
    return other == document_;
}

void ShownScene::update(const graph::Document& document, const std::shared_ptr<const graph::Library>& library,
                        graph::BakedImages images)
{
    bool drawn_alike = is_drawn_alike(document, *library, images);
    document_ = document;
    if (drawn_alike) return;
    library_ = library;
    images_ = std::move(images);
    program_ = std::make_shared<const graph::Program>(
        graph::lower(document, library, {.images = &images_, .slopes = &slopes_}));
    baking_.follow(document, *library);
    problems_ = program_->problems;
    for (graph::Problem& note : baking_.notes(document, *library)) problems_.push_back(std::move(note));
    silhouettes_.look_at(document, library);
    const graph::Node* output = output_of(document, *library);
    has_camera_ = output && output->input("camera");
    bounds_.clear();
    shader_text_.reset();
}

std::vector<graph::Problem> ShownScene::problems() const
{
    std::vector<graph::Problem> problems = problems_;
    const std::vector<graph::Problem>& notes = silhouettes_.answer().notes;
    problems.insert(problems.end(), notes.begin(), notes.end());
    return problems;
}

bool ShownScene::poll()
{
    if (!silhouettes_.take()) return false;
    missed_cells_ = std::make_shared<const ui::MissedCells>(silhouettes_.answer().missed);
    return true;
}

std::optional<ui::Measured> ShownScene::bounds_of(graph::NodeId node)
{
    auto [known, is_new] = bounds_.try_emplace(node);
    const graph::Node* found = nullptr;
    graph::for_each_graph(document_, [&](const graph::Graph& graph) {
        if (const graph::Node* here = graph.find(node)) found = here;
    });
    const graph::NodeType* type = found ? library_->type(found->type) : nullptr;
    if (is_new && (!node || (type && type->is_field())))
        known->second = measured_box(document_, library_, images_, slopes_, node);
    return known->second;
}

std::optional<ui::BlendCurve> ShownScene::blend_of(graph::NodeId node, float time_s) const
{
    const graph::Node* found = document_.root.find(node);
    const graph::NodeType* type = found ? library_->type(found->type) : nullptr;
    return type ? blend_curve(*program_, *type, node, time_s) : std::nullopt;
}

std::shared_ptr<const std::string> ShownScene::shader_text(float time_s)
{
    if (!shader_text_) {
        if (std::string refusal = codegen::export_refusal(*program_); !refusal.empty())
            return shader_text_ = std::make_shared<const std::string>("// " + refusal + "\n");
        std::vector<float> block = field::evaluate_frame(*program_, time_s);
        shader_text_ = std::make_shared<const std::string>(codegen::print_export(*program_, document_, block, "glsl"));
    }
    return shader_text_;
}

}  // namespace fieldwright::app
