// What is wrong with a document, as a value: the user's kind of error (docs/architecture.md, "Errors").
#pragma once

#include <compare>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

namespace fieldwright::graph {

// Identity of a node in a document: never reused, never an index. 0 means "no node".
struct NodeId {
    std::int64_t number = 0;
    auto operator<=>(const NodeId&) const = default;
    explicit operator bool() const { return number != 0; }
};

struct Problem {
    enum class Severity { note, error };  // an error makes its node count as unconnected; a note only informs
    NodeId node;
    std::string sentence;
    Severity severity = Severity::error;
    std::vector<NodeId> inside;  // groups: the way from `node` to the inner node that it is about
    bool operator==(const Problem&) const = default;
};

// The environment's kind of error: what, where, what to do. Caught once, in main or at the session's edge.
// `exit_code` is the command line's: 1 runtime, 2 usage, 3 bad input file, 4 no usable GL, 5 output I/O, 6 shader compile.
struct Failure : std::runtime_error {
    Failure(int code, const std::string& sentence) : std::runtime_error(sentence), exit_code(code) {}
    int exit_code;
};

}  // namespace fieldwright::graph
