// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The ranks and what they say to each other. MPI is named only under core/comm.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace core {

/// MPI from construction to destruction of this object; one in each program, in main.
class MpiSession {
public:
    MpiSession(int& argc, char**& argv);
    ~MpiSession();
    MpiSession(const MpiSession&) = delete;
    MpiSession& operator=(const MpiSession&) = delete;
};

/// Messages on their way. Test it until it says true; the buffers belong to the caller until then.
class Pending {
public:
    Pending();
    ~Pending();
    Pending(Pending&&) noexcept;
    Pending& operator=(Pending&&) noexcept;
    /// True when all messages have arrived and all sent buffers are free. Never waits.
    [[nodiscard]] bool done();
    /// Waits until done().
    void wait();
    [[nodiscard]] bool empty() const;

private:
    friend class Communicator;
    struct Requests;
    std::unique_ptr<Requests> requests_;
};

/// A group of ranks with message tags of its own.
class Communicator {
public:
    /// All ranks of the run. Each call makes a separate space of messages; all ranks must call in the same order.
    static Communicator world();
    /// This rank alone.
    static Communicator self();
    /// A separate space of messages among the same ranks. Collective.
    [[nodiscard]] Communicator duplicate() const;

    [[nodiscard]] int rank() const { return rank_; }
    [[nodiscard]] int size() const { return size_; }

    void send(std::span<const std::byte> data, int to, int tag, Pending& pending) const;
    void receive(std::span<std::byte> data, int from, int tag, Pending& pending) const;
    /// Whether a message could be received at once. Never waits.
    [[nodiscard]] bool has_message(int from, int tag) const;

    /// Element-wise sum over the ranks, in place. The order of additions is not fixed: see reduce.hpp for sums whose
    /// bits must not depend on the number of ranks.
    void sum(std::span<double> values) const;
    void sum(std::span<std::int64_t> values) const;
    void max(std::span<double> values) const;
    void max(std::span<std::int64_t> values) const;
    /// Starts an element-wise sum; `values` holds the result when `pending` is done. Same order of calls on all ranks.
    void start_sum(std::span<double> values, Pending& pending) const;
    void start_max(std::span<double> values, Pending& pending) const;

    /// Everyone's bytes, in the order of the ranks.
    [[nodiscard]] std::vector<std::vector<std::byte>> gather_all(std::span<const std::byte> mine) const;
    /// to[r] goes to rank r; returns what each rank sent here.
    [[nodiscard]] std::vector<std::vector<std::byte>> exchange_all(const std::vector<std::vector<std::byte>>& to) const;
    void broadcast(std::vector<std::byte>& data, int root) const;
    void barrier() const;

    /// The MPI_Comm, for parallel HDF5: cast it back with *static_cast<const MPI_Comm*>().
    [[nodiscard]] const void* native() const;

private:
    struct Handle;
    explicit Communicator(std::shared_ptr<const Handle> handle);
    std::shared_ptr<const Handle> handle_; // shared: copies of a communicator are the same group
    int rank_ = 0, size_ = 1;
};

} // namespace core
