// What the window asks of the program: done by app after the frame, in order.
#pragma once

#include "graph/problem.h"

#include <string>
#include <variant>
#include <vector>

namespace fieldwright::ui {

struct NewScene {};
struct OpenFile {
    std::string path;
};
struct OpenExample {  // as a scene without a file
    std::string name;
};
struct SaveFile {};  // to where it came from
struct SaveFileAs {
    std::string path;
};
struct ExportFile {
    std::string path, target;
};
struct ExportPicture {
    std::string path;
};  // the viewport's picture, full size, in the format that the path's end means
// Asks for a path by the system's dialog, or the built-in browser where there is none; the answer comes back as `then`.
struct ChooseFile {
    enum class Then { open, save_as, export_shader, export_picture, picture } then;
    std::string target;    // of export_shader
    graph::NodeId node{};  // of picture: whose
};
// A picture file for an image node, or for a new one when none is named.
struct UsePicture {
    std::string path;
    graph::NodeId node;
};
struct SaveGroup {  // to the user's library; `text` holds the group
    std::string name, text;
};
struct ForgetRecent {};
struct Undo {};
struct Redo {};
struct JumpTo {
    std::size_t step;
};
struct Recover {
    std::string id;
};
struct DiscardRecovered {
    std::string id;
};
// The text was written here: an own type that has it may run.
struct TrustCode {
    std::string text, type;
};
struct AllowSceneCode {};  // what the scene brought with it may run, too
struct SaveOwnNode {       // into the user's folder of nodes
    std::string type;
};
struct MeasureNodes {};  // in the background: Readings::node_costs
struct InspectRay {      // through this pixel of the shown picture; its answer is Readings::ray
    int x, y;
};
struct Quit {};

using Request = std::variant<NewScene, OpenFile, OpenExample, SaveFile, SaveFileAs, ExportFile, ExportPicture,
                             UsePicture, ChooseFile, SaveGroup, ForgetRecent, Undo, Redo, JumpTo, Recover,
                             DiscardRecovered, TrustCode, AllowSceneCode, SaveOwnNode, MeasureNodes, InspectRay, Quit>;

}  // namespace fieldwright::ui
