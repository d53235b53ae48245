// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Who did what when: spans in one ring buffer per thread, written as a Perfetto/Chrome trace and summed up in a digest.
#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <iosfwd>
#include <map>
#include <string>
#include <thread>
#include <vector>

namespace tasks {

class Plan;

/// One stretch of work on one thread. Between two spans of one node in one step, its job waited for messages.
struct Span {
    int node = 0;
    int thread = 0;
    std::int64_t step = 0;
    double start = 0.0, end = 0.0; ///< [s] since the trace began
};

/// Sums over the steps that the trace still holds; times in seconds.
struct Digest {
    std::int64_t steps = 0;
    double wall = 0.0;                   ///< from the first to the last span of each step
    double work = 0.0;                   ///< T1: all work of all threads
    double longest = 0.0;                ///< the longest chain of dependent work: no number of threads is faster
    double overlap = 0.0;                ///< two lanes work at the same time, or one works while another waits for messages
    double exposed = 0.0;                ///< a lane waits for messages and no thread works
    std::map<std::string, double> lanes; ///< work of each lane; "" are stages of none
    double imbalance = 0.0;              ///< busiest thread over the mean thread, minus one
};
std::ostream& operator<<(std::ostream& stream, const Digest& digest);

class Trace {
public:
    /// @param capacity  Spans kept for each thread; older ones are overwritten.
    explicit Trace(std::size_t capacity = 1 << 16);
    [[nodiscard]] double now() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }
    /// From any thread, without locks.
    void add(Span span);
    /// All spans held, by start time. Call between steps, as everything below.
    [[nodiscard]] std::vector<Span> spans() const;
    [[nodiscard]] Digest digest(const Plan& plan) const;
    /// A file for ui.perfetto.dev; `rank` becomes the process. @throws core::FileError
    void write(const Plan& plan, int rank, const std::filesystem::path& file) const;

private:
    using Clock = std::chrono::steady_clock;
    static constexpr std::size_t most_threads = 256;
    struct Buffer {
        std::atomic<std::thread::id> owner{};
        std::vector<Span> ring;
        std::size_t count = 0;
    };
    [[nodiscard]] std::size_t own_buffer();

    Clock::time_point begin_ = Clock::now();
    std::size_t capacity_;
    std::array<Buffer, most_threads> buffers_;
};

} // namespace tasks
