// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/cli/parallel_options.hpp"

#include "core/base/error.hpp"
#include "io/run/launch.hpp"
#include "io/run/manifest.hpp"
#include "io/scene/problems.hpp"
#include <algorithm>

namespace io {

namespace {

void check_executor(const std::string& executor)
{
    const std::vector<std::string> kinds{"auto", "serial", "shuffle:SEED", "openmp", "tbb"};
    const std::string shuffle = "shuffle:";
    const std::string seed = executor.starts_with(shuffle) ? executor.substr(shuffle.size()) : "";
    const bool has_seed = !seed.empty() && std::all_of(seed.begin(), seed.end(), [](char c) { return c >= '0' && c <= '9'; });
    if (has_seed || (executor != kinds[2] && std::find(kinds.begin(), kinds.end(), executor) != kinds.end())) return;
    throw core::ConfigError("--executor: there is no executor '" + executor + "'; " + suggestion(executor, kinds));
}

} // namespace

std::vector<Option> parallel_options(ParallelOptions& place)
{
    return {{"--ranks", "MPI ranks; the program starts mpirun itself", &place.ranks},
            {"--threads", "Threads of each rank; an equal share of the cores by default", &place.threads},
            {"--executor", "auto, serial, shuffle:SEED, openmp or tbb: who runs the tasks; results do not differ", &place.executor}};
}

std::optional<int> begin_parallel(const ParallelOptions& options, const Invocation& invocation)
{
    using core::ConfigError;
    core::require<ConfigError>(options.ranks.value_or(1) >= 1, "--ranks: at least one rank is needed");
    core::require<ConfigError>(options.threads.value_or(1) >= 1, "--threads: at least one thread is needed");
    check_executor(options.executor);
    const int ranks = options.ranks.value_or(1), threads = chosen_threads(options, ranks);
    if (ranks > 1)
        if (const auto code = start_ranks(ranks, threads, invocation.argc, invocation.argv)) return code;
    if (options.executor == "openmp") restrain_openmp(threads, invocation.argv);
    return {};
}

int chosen_threads(const ParallelOptions& options, int ranks) { return options.threads.value_or(std::max(1, available_cores() / ranks)); }

} // namespace io
