// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs a plan, step after step. All executors give the same bits; they differ in who runs what when.
#include "tasks/plan.hpp"
#include "tasks/trace.hpp"
#include <cstdint>
#include <memory>
#include <string>

namespace tasks {

struct ExecutorOptions {
    /// "serial" (order of the text), "shuffle:SEED" (random legal order), "openmp" (stage by stage, one OpenMP team), "tbb"
    /// (oneTBB flow graph) or "auto" (tbb, but serial where one thread and one rank leave nothing to overlap).
    std::string kind = "auto";
    int threads = 1;
    Trace* trace = nullptr; ///< must outlive the executor
};

class Executor {
public:
    virtual ~Executor() = default;
    /// Runs every node of the plan once. Collective.
    /// @throws StepFailure, the same on all ranks, if a stage failed on any of them.
    virtual void run_step(std::int64_t step) = 0;
    [[nodiscard]] virtual std::string name() const = 0;
};

/// @param plan  Must outlive the executor.
/// @throws core::ConfigError for a kind that does not exist or a number of threads below one.
[[nodiscard]] std::unique_ptr<Executor> make_executor(const ExecutorOptions& options, const Plan& plan);
std::unique_ptr<Executor> make_executor(const ExecutorOptions& options, const Plan&& plan) = delete;

} // namespace tasks
