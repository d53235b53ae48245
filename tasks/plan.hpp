// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A compiled step: which stages are kept and why, the tasks made of them, and who waits for whom.
#include "tasks/stage.hpp"
#include <deque>
#include <iosfwd>
#include <string>
#include <vector>

namespace tasks {

class StageGraph;

/// A resource that is needed after the steps in which `label` is due.
struct Sink {
    const void* resource = nullptr;
    std::string label;
};

/// Whether a stage runs, and the reason in words.
struct Verdict {
    bool kept = false;
    std::string reason;
};

/// One task: a stage on the blocks [begin, end), or on the whole rank.
struct Node {
    int stage = 0;
    LocalBlock begin = 0, end = 0;
    std::vector<int> predecessors, successors; ///< indices of nodes, ascending
    int priority = 0;                          ///< 2 = communicates, 1 = messages depend on it, 0 = neither
};

/// What `isago plan` shows.
/// Memory of the resources that the kept stages touch, on this rank [bytes].
struct PlanMemory {
    std::size_t bytes = 0;
    std::size_t carried = 0;      ///< Of those whose values outlive the step.
    std::size_t most_at_once = 0; ///< Carried, and of the others those in use at the same stage: with shared memory no less would do.
    std::ptrdiff_t cells = 0;
};
std::ostream& operator<<(std::ostream& stream, const PlanMemory& memory);

struct PlanReport {
    struct StageLine {
        std::string name, lane;
        Verdict verdict;
        int tasks = 0;
        std::vector<std::string> after; ///< stages that it waits for
    };
    struct ResourceLine {
        std::string name;
        bool needed = false;
        std::size_t bytes = 0; ///< on this rank, 0 where unknown
    };
    std::vector<StageLine> stages;
    std::vector<ResourceLine> resources;
    std::vector<std::string> longest_path; ///< stages along the longest chain of tasks
    PlanMemory memory;
};
/// Stable text: the same for the same stages and blocks.
std::ostream& operator<<(std::ostream& stream, const PlanReport& report);

class Plan {
public:
    [[nodiscard]] const std::vector<Node>& nodes() const { return nodes_; }
    [[nodiscard]] const std::vector<Verdict>& verdicts() const { return verdicts_; } ///< one for each stage
    [[nodiscard]] const Stage& stage(int s) const;
    [[nodiscard]] const Stage& stage_of(const Node& node) const { return stage(node.stage); }
    [[nodiscard]] int stages() const { return int(verdicts_.size()); }
    /// The nodes [first, last) of a stage.
    [[nodiscard]] std::pair<int, int> nodes_of(int stage) const;
    [[nodiscard]] PlanReport describe() const;
    [[nodiscard]] MessagePump& pump() const;
    [[nodiscard]] const core::Communicator& ranks() const;
    /// A job of this stage has left messages that nobody will receive; `job` keeps the buffers that MPI may still know.
    void give_up(int stage, Job job) const;
    /// Gives new message spaces to the stages that any rank has given up. Collective.
    void renew_communicators() const;

private:
    friend class StageGraph;
    Plan(StageGraph& graph, std::vector<Verdict> verdicts);
    StageGraph* graph_;
    std::vector<Verdict> verdicts_;
    std::vector<Node> nodes_;
};

/// @param sinks  Of the graph: they outlive the step.
[[nodiscard]] PlanMemory memory_of(const Plan& plan, const std::vector<ResourceRecord>& resources, const std::vector<Sink>& sinks);

/// Walks backwards from what is needed after the step (the sinks, and all that the next step reads before it writes it).
[[nodiscard]] std::vector<Verdict> cull(const std::deque<Stage>& stages, const std::vector<Sink>& sinks,
                                        const std::vector<std::string>& due);

/// The tasks of the kept stages in the order of the text, with the dependencies that read-after-write, write-after-read and
/// write-after-write ask for, block by block.
[[nodiscard]] std::vector<Node> derive_nodes(const std::deque<Stage>& stages, const std::vector<Verdict>& verdicts, const Layout& layout);

} // namespace tasks
