// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Flexible Krylov solvers. They ask for what they cannot do themselves (operator, preconditioner, sums over ranks), so
// that the same lines serve one rank that calls and many ranks that wait for messages without blocking a thread.
#include "core/base/team.hpp"
#include "physics/fluid/block_sums.hpp"
#include <coroutine>
#include <exception>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace physics {

struct KrylovOptions {
    double relative = 1e-8; ///< of the 2-norm of the right-hand side
    double absolute = 0.0;
    int most_iterations = 200;
    bool singular = false;            ///< constants are the null space, on both sides
    bool from_zero = false;           ///< the first guess is zero: its residual is the right-hand side
    double largest_defect = 1e-6;     ///< of a singular system: net source over the sum of its magnitudes
    std::string unknown = "pressure"; ///< for messages
};

struct KrylovReport {
    int iterations = 0;
    double right_norm = 0.0;
    double defect = 0.0;           ///< net source that a singular system cannot take, over the sum of magnitudes
    std::vector<double> residuals; ///< 2-norms, the first before any iteration; the last of the solution, to round-off
};

/// What a solver asks for.
struct KrylovDemand {
    enum class Kind {
        apply,        ///< out = A in
        precondition, ///< out = M in; in need not be kept
        sum           ///< in: add element-wise over the ranks
    };
    Kind kind;
    std::span<double> in, out;
};

/// A solver that runs from demand to demand.
class KrylovProcess {
public:
    struct promise_type {
        KrylovDemand demand{};
        std::exception_ptr error;
        KrylovProcess get_return_object() { return KrylovProcess(Handle::from_promise(*this)); }
        std::suspend_always initial_suspend() noexcept { return {}; }
        std::suspend_always final_suspend() noexcept { return {}; }
        std::suspend_always yield_value(const KrylovDemand& d) noexcept
        {
            demand = d;
            return {};
        }
        void return_void() {}
        void unhandled_exception() { error = std::current_exception(); }
    };
    using Handle = std::coroutine_handle<promise_type>;

    KrylovProcess(KrylovProcess&& other) noexcept : handle_(std::exchange(other.handle_, {})) {}
    KrylovProcess& operator=(KrylovProcess&& other) noexcept
    {
        std::swap(handle_, other.handle_);
        return *this;
    }
    ~KrylovProcess()
    {
        if (handle_) handle_.destroy();
    }

    /// Runs to the next demand; false when the solution is there.
    /// @throws NumericsError if the iteration breaks down or does not converge.
    [[nodiscard]] bool next()
    {
        handle_.resume();
        if (handle_.promise().error) std::rethrow_exception(handle_.promise().error);
        return !handle_.done();
    }
    [[nodiscard]] const KrylovDemand& demand() const { return handle_.promise().demand; }

private:
    explicit KrylovProcess(Handle handle) : handle_(handle) {}
    Handle handle_;
};

/// Memory of the solvers, kept from solve to solve. Vectors are flat arrays of the layout.
class KrylovWorkspace {
public:
    KrylovWorkspace(const BlockLayout& layout, int all_blocks, std::ptrdiff_t all_cells)
        : layout(&layout), sums(layout, all_blocks), all_cells(all_cells)
    {
    }
    /// @post At least `count` vectors of zeroed memory; those that exist keep their place.
    void reserve(std::size_t count)
    {
        while (vectors.size() < count) vectors.emplace_back(layout->size(), 0.0);
    }

    const BlockLayout* layout;
    BlockSums sums;
    std::ptrdiff_t all_cells;
    std::vector<std::vector<double>> vectors;
};

/// A x = right with a symmetric positive (semi-)definite A and any preconditioner near to such a one.
/// A singular system is solved with the mean of `right` removed, and the mean of x is zero.
/// @param right  Its mean is removed if the system is singular.
/// @param x      First guess in, solution out.
/// @source  Notay, SIAM J. Sci. Comput. 22 (2000) 1444, FCG(1).
[[nodiscard]] KrylovProcess flexible_cg(const core::Team& team, KrylovWorkspace& work, const KrylovOptions& options,
                                        std::span<double> right, std::span<double> x, KrylovReport& report);

/// The same for any A; two operators and two preconditioners in each iteration.
/// @source  van der Vorst, SIAM J. Sci. Stat. Comput. 13 (1992) 631, preconditioned from the right.
[[nodiscard]] KrylovProcess bicgstab(const core::Team& team, KrylovWorkspace& work, const KrylovOptions& options, std::span<double> right,
                                     std::span<double> x, KrylovReport& report);

/// Runs a solver on one rank. apply(in, out) and precondition(in, out) take spans of doubles.
template <class Apply, class Precondition>
void drive(KrylovProcess process, Apply apply, Precondition precondition)
{
    while (process.next()) {
        const auto& d = process.demand();
        if (d.kind == KrylovDemand::Kind::apply) apply(d.in, d.out);
        if (d.kind == KrylovDemand::Kind::precondition) precondition(d.in, d.out);
    }
}

} // namespace physics
