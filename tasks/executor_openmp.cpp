// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Bulk-synchronous: stage after stage in the order of the text, one OpenMP team over the tasks of each stage and over the
// loops of whole stages. The honest baseline, and the better one for uniform loops.
#include "tasks/executors.hpp"
#include "tasks/node_runner.hpp"

namespace tasks {
namespace {

class OpenMpExecutor final : public Executor {
public:
    OpenMpExecutor(const Plan& plan, Trace* trace, int threads)
        : threads_(threads), team_(core::make_openmp_team(threads)), runner_(plan, *team_, trace)
    {
    }

    void run_step(std::int64_t step) override
    {
        const Plan& plan = runner_.plan();
        runner_.begin_step(step);
        for (int s = 0; s < plan.stages(); ++s) {
            const auto [first, last] = plan.nodes_of(s);
            if (first == last) continue;
            if (plan.stage(s).whole()) runner_.start(first);
            else run_in_parallel(first, last);
            runner_.wait_for(first);
        }
        runner_.end_step();
    }
    [[nodiscard]] std::string name() const override { return "openmp"; }

private:
    void run_in_parallel(int first, int last)
    {
#pragma omp parallel for schedule(dynamic, 1) num_threads(threads_) if (last - first > 1)
        for (int n = first; n < last; ++n) runner_.start(n);
    }

    int threads_;
    std::unique_ptr<core::Team> team_;
    DrivenRunner runner_;
};

} // namespace

std::unique_ptr<Executor> make_openmp_executor(const Plan& plan, Trace* trace, int threads)
{
    return std::make_unique<OpenMpExecutor>(plan, trace, threads);
}

} // namespace tasks
