// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A random order that the declarations allow: finds what a stage touches and does not declare.
#include "tasks/executors.hpp"
#include "tasks/node_runner.hpp"

#include <random>

namespace tasks {
namespace {

class ShuffleExecutor final : public Executor {
public:
    ShuffleExecutor(const Plan& plan, Trace* trace, std::uint64_t seed)
        : runner_(plan, team_, trace), seed_(seed), pick_(seed + std::uint64_t(plan.ranks().rank()))
    {
    }

    void run_step(std::int64_t step) override
    {
        const auto& nodes = runner_.plan().nodes();
        std::vector<int> missing, ready;
        for (const Node& node : nodes) {
            if (node.predecessors.empty()) ready.push_back(int(missing.size()));
            missing.push_back(int(node.predecessors.size()));
        }
        runner_.begin_step(step);
        core::Patience patience;
        for (std::size_t ended = 0; ended < nodes.size();) {
            if (ready.empty()) {
                runner_.wait(patience);
            } else {
                std::swap(ready[pick_() % ready.size()], ready.back());
                const int node = ready.back();
                ready.pop_back();
                runner_.start(node);
                runner_.advance();
            }
            for (const int node : runner_.take_ended()) {
                ++ended;
                for (const int next : nodes[std::size_t(node)].successors)
                    if (--missing[std::size_t(next)] == 0) ready.push_back(next);
            }
        }
        runner_.end_step();
    }
    [[nodiscard]] std::string name() const override { return "shuffle:" + std::to_string(seed_); }

private:
    core::SerialTeam team_;
    DrivenRunner runner_;
    std::uint64_t seed_;
    std::mt19937_64 pick_;
};

} // namespace

std::unique_ptr<Executor> make_shuffle_executor(const Plan& plan, Trace* trace, std::uint64_t seed)
{
    return std::make_unique<ShuffleExecutor>(plan, trace, seed);
}

} // namespace tasks
