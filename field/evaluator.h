// The program on the CPU: 256 points at a time, one compiled loop per call.
#pragma once

#include "field/kernel.h"
#include "graph/program.h"

#include <memory>
#include <vector>

namespace fieldwright::field {

// The parameter block with constants and frame values for `time` seconds filled in (program.frame evaluated).
std::vector<float> evaluate_frame(const graph::Program& program, float time);

// An entry prepared for evaluation: kernels resolved, rows allocated by liveness. Immutable; share between threads.
// Throws graph::Failure{1} naming the node when a function is not compiled into this program.
class Evaluator {
public:
    Evaluator(const graph::Program& program, const graph::Entry& entry, const KernelTable& table = kernels());

    int input_lanes() const { return input_lanes_; }                            // sum over entry.inputs
    int result_lanes() const { return static_cast<int>(result_rows_.size()); }  // sum over entry.results

    // One thread's rows. Reuse it between calls of the same evaluator, which must outlive it.
    class Workspace {
    public:
        explicit Workspace(const Evaluator& evaluator);
        Workspace(Workspace&&) = default;
        float* input(int lane) { return row(lane); }  // row to fill before evaluate; lanes of entry.inputs in turn
        const float* result(int lane) const;          // row to read after; lanes of entry.results in turn

    private:
        friend class Evaluator;
        float* row(int index) { return rows_ + static_cast<std::ptrdiff_t>(index) * row_width; }
        void point_into(std::span<const float> block);

        std::vector<float> memory_;
        float* rows_ = nullptr;               // aligned to 64 bytes
        std::vector<float> counters_;         // copies done, by block
        std::vector<const float*> pointers_;  // by operand
        const float* block_ = nullptr;        // where pointers_ into the block point
        const Evaluator* evaluator_ = nullptr;
    };

    // block: as evaluate_frame returned it. count <= row_width.
    void evaluate(Workspace& workspace, std::span<const float> block, int count) const;

private:
    // Where an argument is found: rows of the workspace, a place in the block, or a counter of copies.
    struct Operand {
        enum class Kind { rows, block, counter } kind;
        int at;  // first row, slot of the block, or counter
    };
    struct Operation {
        enum class Kind { call, spread, copy, begin_block, end_block, guard } kind;
        Kernel kernel = nullptr;
        int result = 0;                         // first row; of a guard: that of what it may leave out
        int first_operand = 0;                  // of all but blocks; a spread or copy has one
        int lanes = 0;                          // of a spread or copy; of a guard: how many rivals it has
        int counter = 0, copies = 0, body = 0;  // of blocks; body: how many operations, of guards as well
        int needed = -1;                        // of a block's end: slot of the number of copies that differ
    };
    class Compiler;
    static float copies(const Operation& end_of_block, std::span<const float> block);

    std::vector<Operation> operations_;
    std::vector<Operand> operands_;
    std::vector<int> block_operands_;  // indices of operands in the block
    std::vector<int> result_rows_;     // by result lane
    std::vector<glm::vec4> list_data_;
    int input_lanes_ = 0;
    int row_count_ = 0;
    int counter_count_ = 0;
};

// Signed distances of the program's distance entry at points; any number of points, on the calling thread.
std::vector<float> distances(const graph::Program& program, std::span<const float> block,
                             std::span<const glm::vec3> points, const KernelTable& table = kernels());

}  // namespace fieldwright::field
