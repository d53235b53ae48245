// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a piece of work costs, for benchmarks.
#include <algorithm>
#include <ctime>

namespace test {

/// Processor time of all threads [s].
inline double processor_time() { return double(std::clock()) / CLOCKS_PER_SEC; }

/// Shortest processor time of some repetitions [s], each at least 5 ms long.
template <class Work>
double seconds(int repetitions, Work work)
{
    double best = 1e30;
    for (int n = 0; n < repetitions; ++n) {
        const double start = processor_time();
        int runs = 0;
        do {
            work();
            ++runs;
        } while (processor_time() - start < 5e-3);
        best = std::min(best, (processor_time() - start) / runs);
    }
    return best;
}

} // namespace test
