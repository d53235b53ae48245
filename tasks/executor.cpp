// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tasks/executors.hpp"

#include "core/base/error.hpp"

#include <charconv>

namespace tasks {
namespace {

std::uint64_t seed_of(const std::string& kind)
{
    const auto colon = kind.find(':');
    if (colon == std::string::npos) return 1;
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(kind.data() + colon + 1, kind.data() + kind.size(), seed);
    core::require<core::ConfigError>(error == std::errc{} && end == kind.data() + kind.size(),
                                     "executor '" + kind + "': write shuffle:SEED with a whole number, such as shuffle:7");
    return seed;
}

} // namespace

std::unique_ptr<Executor> make_executor(const ExecutorOptions& options, const Plan& plan)
{
    const auto& kind = options.kind;
    core::require<core::ConfigError>(options.threads >= 1, core::text("threads = ", options.threads, ": at least one is needed"));
    const bool nothing_to_overlap = options.threads == 1 && plan.ranks().size() == 1;
    if (kind == "serial" || (kind == "auto" && nothing_to_overlap)) return make_serial_executor(plan, options.trace);
    if (kind == "tbb" || kind == "auto") return make_tbb_executor(plan, options.trace, options.threads);
    if (kind == "openmp") return make_openmp_executor(plan, options.trace, options.threads);
    if (kind == "shuffle" || kind.starts_with("shuffle:")) return make_shuffle_executor(plan, options.trace, seed_of(kind));
    throw core::ConfigError("executor '" + kind + "' does not exist: choose auto, serial, shuffle:SEED, openmp or tbb");
}

} // namespace tasks
