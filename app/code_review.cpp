// Trials of own types, one at a time, each in the small scene that `new --node` makes.
#include "app/code_review.h"

#include "app/starter_scene.h"
#include "codegen/glsl.h"
#include "codegen/shader_lines.h"
#include "field/evaluator.h"
#include "graph/own_type_edits.h"

#include <algorithm>
#include <regex>

namespace fieldwright::app {
namespace {

std::string shader_with(const std::shared_ptr<const graph::Library>& library, const graph::NodeType& type)
{
    StarterScene scene(library, type);
    graph::Program program = graph::lower(scene.document, library);
    std::vector<float> block = field::evaluate_frame(program, 0);
    return codegen::print_fragment_shader(program, block, codegen::Placement::literals);
}

// Endings that say nothing against the code.
bool says_nothing(assets::Ending ending)
{
    return ending == assets::Ending::refused || ending == assets::Ending::cancelled ||
           ending == assets::Ending::not_started;
}

}  // namespace

graph::TextError error_in_type(const std::string& log, const std::string& type, const graph::Library& library,
                               std::string_view shader)
{
    std::string placed = codegen::with_place(log, library, shader);
    graph::TextError error;
    std::smatch match;
    if (std::regex_search(placed, match, std::regex("types/" + type + "\\.glsl:(\\d+)"))) {
        error.line = std::stoi(match[1]);
        placed = match.suffix();
    }
    placed = placed.substr(0, placed.find('\n'));
    static const std::regex preamble("^[\\s:]*(error)?[\\s:]*(C\\d+:)?\\s*");
    error.rule = "the driver does not take it: " + std::regex_replace(placed, preamble, "");
    return error;
}

CodeReview::CodeReview(std::filesystem::path trusted_file, Trial trial, std::function<void()> on_ready)
    : trusted_(std::move(trusted_file)), trial_(std::move(trial)), on_ready_(std::move(on_ready))
{
}

std::optional<graph::TextError> CodeReview::verdict(const graph::OwnType& type)
{
    if (!trusted_.trusts(type))
        return graph::TextError{0, 0, "its code came with the scene and waits for you to run it (in the File menu)"};
    if (!trial_) return std::nullopt;
    std::string text = nameless(type);
    if (auto known = outcomes_.find(text); known != outcomes_.end()) return known->second;
    auto same = [&](const graph::OwnType& waiting) { return nameless(waiting) == text; };
    if (std::none_of(waiting_.begin(), waiting_.end(), same)) waiting_.push_back(type);
    return graph::TextError{.rule = "its code is being tried", .waiting = true};
}

bool CodeReview::update(const std::shared_ptr<const graph::Library>& library)
{
    bool changed = false;
    {
        std::lock_guard lock(mutex_);
        if (finished_) {
            outcomes_.insert_or_assign(std::move(finished_->text), std::move(finished_->outcome));
            finished_.reset();
            running_ = false;
            changed = true;
        }
    }
    while (!running_ && !waiting_.empty()) {
        graph::OwnType next = std::move(waiting_.front());
        waiting_.pop_front();
        if (!outcomes_.contains(nameless(next))) start(std::move(next), library);
    }
    return changed;
}

void CodeReview::start(graph::OwnType type, std::shared_ptr<const graph::Library> library)
{
    running_ = true;
    thread_ = std::jthread([this, type = std::move(type), library = std::move(library)](const std::stop_token& stop) {
        Outcome outcome = tried(type, *library, stop);
        {
            std::lock_guard lock(mutex_);
            finished_ = {nameless(type), std::move(outcome)};
        }
        if (on_ready_ && !stop.stop_requested()) on_ready_();
    });
}

// Nothing where the text is no node: the library says that better.
CodeReview::Outcome CodeReview::tried(const graph::OwnType& type, const graph::Library& base,
                                      const std::stop_token& stop) const
{
    std::shared_ptr<const graph::Library> library = graph::with_own_types(base, {type});
    const graph::NodeType* declared = library->type(type.name);
    if (!declared || library->left_out(type.name)) return std::nullopt;
    std::string shader = shader_with(library, *declared);
    ShaderVerdict verdict = trial_(shader, stop);
    if (verdict.good() || says_nothing(verdict.ending)) return std::nullopt;
    if (verdict.ending != assets::Ending::answered) return graph::TextError{.rule = verdict.sentence};
    return error_in_type(verdict.log, type.name, *library, shader);
}

void CodeReview::trust(const std::vector<graph::OwnType>& types) { trusted_.trust(types); }

std::vector<graph::OwnType> CodeReview::foreign(const graph::Document& document) const
{
    std::vector<graph::OwnType> types;
    for (const graph::OwnType& type : document.own_types)
        if (graph::uses_of_own_type(document, type.name) && !trusted_.trusts(type)) types.push_back(type);
    return types;
}

}  // namespace fieldwright::app
