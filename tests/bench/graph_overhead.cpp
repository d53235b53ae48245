// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What a node of the graph costs: empty kernels in a stencil of blocks, each executor, one and two threads. Prints the
// fastest of many runs, in nanoseconds per node.
#include "core/comm/communicator.hpp"
#include "tasks/executor.hpp"
#include "tasks/stage_graph.hpp"

#include <algorithm>
#include <chrono>
#include <iostream>

namespace {

constexpr int blocks = 8, stages = 100, runs = 200;

double seconds_per_step(tasks::Executor& executor)
{
    double best = 1.0;
    for (int run = 0; run < runs; ++run) {
        const auto begin = std::chrono::steady_clock::now();
        executor.run_step(run);
        best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    }
    return best;
}

} // namespace

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    const std::vector<core::Extents> cells(blocks, {1, 1, 1});
    core::ScalarField a({"a", "-", 0, false}, cells), b({"b", "-", 0, false}, cells);
    tasks::StageGraph graph(tasks::Layout{std::vector<std::ptrdiff_t>(blocks, 1), 1}, core::Communicator::self());
    for (int s = 0; s < stages; ++s)
        graph.each_block(
            "stage", [](int, core::View<double>, core::View<double>) {}, tasks::updates(a, b));
    graph.sink(a);
    const auto plan = graph.compile();
    for (const std::string kind : {"serial", "openmp", "tbb"})
        for (const int threads : {1, 2}) {
            tasks::Trace trace;
            const auto executor = tasks::make_executor({kind, threads, nullptr}, plan);
            const auto traced = tasks::make_executor({kind, threads, &trace}, plan);
            const double nodes = double(plan.nodes().size());
            std::cout << kind << ", " << threads << " threads: " << 1e9 * seconds_per_step(*executor) / nodes << " ns per node, traced "
                      << 1e9 * seconds_per_step(*traced) / nodes << '\n';
        }
}
