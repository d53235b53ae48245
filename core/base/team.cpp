// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The only file outside tasks/executor_* that names OpenMP threads or oneTBB.
#include "core/base/team.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

namespace core {
namespace {

class OpenMpTeam final : public Team {
public:
    explicit OpenMpTeam(int threads) : threads_(threads) {}
    void run(int chunks, const std::function<void(int)>& body) const override
    {
#pragma omp parallel for schedule(static) num_threads(threads_) if (chunks > 1)
        for (int c = 0; c < chunks; ++c) body(c);
    }
    [[nodiscard]] int threads() const override { return threads_; }

private:
    int threads_;
};

class TbbTeam final : public Team {
public:
    explicit TbbTeam(int threads) : threads_(threads) {}
    void run(int chunks, const std::function<void(int)>& body) const override
    {
        if (chunks <= 1 || threads_ == 1) return SerialTeam{}.run(chunks, body);
        tbb::this_task_arena::isolate([&] {
            tbb::parallel_for(
                tbb::blocked_range<int>(0, chunks, 1),
                [&](const tbb::blocked_range<int>& range) {
                    for (int c = range.begin(); c != range.end(); ++c) body(c);
                },
                tbb::simple_partitioner{});
        });
    }
    [[nodiscard]] int threads() const override { return threads_; }

private:
    int threads_;
};

} // namespace

std::unique_ptr<Team> make_openmp_team(int threads) { return std::make_unique<OpenMpTeam>(threads); }
std::unique_ptr<Team> make_tbb_team(int threads) { return std::make_unique<TbbTeam>(threads); }

} // namespace core
