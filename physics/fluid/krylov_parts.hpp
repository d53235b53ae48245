// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the Krylov solvers share: loops over flat vectors, the start, the test for convergence.
#include "core/base/error.hpp"
#include "physics/fluid/krylov.hpp"
#include <array>
#include <cmath>

namespace physics::detail {

using Flat = std::ptrdiff_t;

/// body(c) for every cell.
template <class Body>
void for_cells(const core::Team& team, const BlockLayout& layout, Body body)
{
    layout.for_pieces(team, [&](int n) {
        const auto& p = layout.pieces()[std::size_t(n)];
        const auto own = body;
#pragma omp simd
        for (Flat c = p.begin; c < p.end; ++c) own(c);
    });
}

/// Judges residual norms against the tolerances.
class Convergence {
public:
    Convergence(const KrylovOptions& options, KrylovReport& report) : options_(options), report_(report) {}

    [[nodiscard]] double target() const { return std::max(options_.absolute, options_.relative * report_.right_norm); }
    /// Notes the norm. @throws NumericsError if it is not finite, or the iterations are used up.
    [[nodiscard]] bool reached(double norm)
    {
        report_.residuals.push_back(norm);
        require(std::isfinite(norm), "the residual is not finite");
        if (norm <= target()) return true;
        if (report_.iterations >= options_.most_iterations)
            throw core::NumericsError(core::text(where(), "no convergence; wanted ", target()));
        return false;
    }
    /// @throws NumericsError that says where the solver is; only then the message is written, which takes longer than small systems.
    void require(bool condition, const char* otherwise) const
    {
        if (!condition) throw core::NumericsError(where() + otherwise);
    }
    /// The recursion says converged, the solution says `norm`: below this nothing can be gained in 64 bits.
    [[nodiscard]] bool at_round_off(double norm) const { return norm <= 1e-12 * report_.right_norm; }
    /// Whether the recursion has converged and needs no second look, as it drifts from the solution by round-off of the largest
    /// residual alone. Notes the norm then.
    [[nodiscard]] bool trusted(double norm, double largest)
    {
        if (norm > target() || 1e-11 * largest > target()) return false;
        report_.residuals.push_back(norm);
        return true;
    }
    [[nodiscard]] std::string where() const
    {
        return core::text("solver of ", options_.unknown, ", iteration ", report_.iterations, ", residual ",
                          report_.residuals.empty() ? 0.0 : report_.residuals.back(), ", right-hand side ", report_.right_norm, ": ");
    }

private:
    const KrylovOptions& options_;
    KrylovReport& report_;
};

/// Sums of a right-hand side and of its magnitudes and squares.
inline void form_right_sums(const core::Team& team, BlockSums& sums, std::span<const double> right)
{
    const double* b = right.data();
    sums.form(team, [=](Flat begin, Flat end) {
        return std::array{ordered_sum(begin, end, [=](Flat c) { return b[c]; }),
                          ordered_sum(begin, end, [=](Flat c) { return std::abs(b[c]); }), dot(begin, end, b, b)};
    });
}

/// Notes the norm and, of a singular system, the defect, and removes it.
/// @throws NumericsError if the defect is more than round-off can explain.
inline void accept_right(const core::Team& team, const KrylovWorkspace& work, const KrylovOptions& options, std::span<double> right,
                         KrylovReport& report)
{
    const double net = work.sums.total(0), magnitude = work.sums.total(1);
    report.right_norm = std::sqrt(work.sums.total(2));
    if (!options.singular) return;
    report.defect = magnitude > 0.0 ? std::abs(net) / magnitude : 0.0;
    if (!(report.defect <= options.largest_defect || report.right_norm <= options.absolute))
        throw core::NumericsError(core::text("solver of ", options.unknown, ": closed domain with a net source of ", net,
                                             " against magnitudes of ", magnitude, ": the sum over all cells must vanish"));
    for_cells(team, *work.layout, [b = right.data(), mean = net / double(work.all_cells)](Flat c) { b[c] -= mean; });
}

/// r = b - q, and the sum of its squares.
inline void form_residual(const core::Team& team, KrylovWorkspace& work, const double* b, const double* q, double* r)
{
    work.sums.form(team, [=](Flat begin, Flat end) {
#pragma omp simd
        for (Flat c = begin; c < end; ++c) r[c] = b[c] - q[c];
        return std::array{dot(begin, end, r, r)};
    });
}

/// The sum of the values.
inline void form_sum(const core::Team& team, BlockSums& sums, const double* x)
{
    sums.form(team, [=](Flat begin, Flat end) { return std::array{ordered_sum(begin, end, [=](Flat c) { return x[c]; })}; });
}

} // namespace physics::detail
