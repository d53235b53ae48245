// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/run_cost.hpp"

#include "core/base/error.hpp"
#include <algorithm>
#include <fmt/format.h>
#include <sys/resource.h>

namespace io {

std::size_t greatest_memory()
{
    rusage use{};
    getrusage(RUSAGE_SELF, &use);
    return std::size_t(use.ru_maxrss) * 1024;
}

std::string memory_line(const World& world)
{
    const auto* grains = world.grains();
    std::array sums{double(greatest_memory()), grains ? double(grains->bytes()) : 0.0, grains ? double(grains->particles.owned) : 0.0};
    world.ranks().sum(sums);
    constexpr double mega = 1e-6, kilo = 1e-3;
    const double cells = double(std::max<std::int64_t>(world.mesh().total_cells(), 1));
    std::string line = fmt::format("memory: {:.0f} MB resident on all ranks, {:.2f} kB per cell", mega * sums[0], kilo * sums[0] / cells);
    if (sums[2] > 0) line += fmt::format("; grains and their lists {:.1f} MB of it, {:.0f} B per grain", mega * sums[1], sums[1] / sums[2]);
    return line;
}

std::vector<std::string> trace_lines(const tasks::Digest& digest, const core::Communicator& ranks)
{
    const std::string here = fmt::format("rank {}: {}", ranks.rank(), core::text(digest));
    std::vector<std::string> lines;
    for (const auto& bytes : ranks.gather_all(std::as_bytes(std::span(here))))
        lines.emplace_back(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return lines;
}

} // namespace io
