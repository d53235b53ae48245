// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who runs the chunks of a loop: one thread, an OpenMP team, or the threads of oneTBB. Chunks never depend on the
// number of threads, so results do not either.
#include <algorithm>
#include <functional>
#include <memory>

namespace core {

class Team {
public:
    virtual ~Team() = default;
    /// Calls body(chunk) once for each chunk in [0, chunks), on any thread, and returns when all are done.
    virtual void run(int chunks, const std::function<void(int)>& body) const = 0;
    [[nodiscard]] virtual int threads() const = 0;
};

/// The calling thread alone, in order.
class SerialTeam final : public Team {
public:
    void run(int chunks, const std::function<void(int)>& body) const override
    {
        for (int c = 0; c < chunks; ++c) body(c);
    }
    [[nodiscard]] int threads() const override { return 1; }
};

/// One OpenMP team of `threads` threads; serial where OpenMP is not built in.
[[nodiscard]] std::unique_ptr<Team> make_openmp_team(int threads);
/// The oneTBB arena of the calling thread; nested calls never pick up unrelated tasks.
[[nodiscard]] std::unique_ptr<Team> make_tbb_team(int threads);

/// Calls body(begin, end) for consecutive pieces of [0, n) of at most `grain` elements.
template <class Body>
void for_chunks(const Team& team, int n, int grain, Body body)
{
    const int chunks = (n + grain - 1) / grain;
    if (chunks == 1) return body(0, n);
    team.run(chunks, [&](int c) { body(c * grain, std::min(n, (c + 1) * grain)); });
}

} // namespace core
