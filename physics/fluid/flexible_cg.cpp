// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/krylov_parts.hpp"

#include <algorithm>

namespace physics {

using detail::Flat;
using Kind = KrylovDemand::Kind;

namespace {

/// The residual, what the preconditioner makes of it, the direction and its image.
struct CgVectors {
    std::span<double> r, z, p, q;
};

CgVectors cg_vectors(KrylovWorkspace& work)
{
    work.reserve(4);
    auto& w = work.vectors;
    return {w[0], w[1], w[2], w[3]};
}

/// x += factor * p; r -= factor * q, and the sum of its squares.
void step(const core::Team& team, KrylovWorkspace& work, const CgVectors& w, double factor, std::span<double> x)
{
    work.sums.form(team, [r = w.r.data(), p = w.p.data(), q = w.q.data(), x = x.data(), factor](Flat b, Flat e) {
#pragma omp simd
        for (Flat c = b; c < e; ++c) {
            x[c] += factor * p[c];
            r[c] -= factor * q[c];
        }
        return std::array{dot(b, e, r, r)};
    });
}

} // namespace

KrylovProcess flexible_cg(const core::Team& team, KrylovWorkspace& work, const KrylovOptions& options, std::span<double> right,
                          std::span<double> x, KrylovReport& report)
{
    const CgVectors w = cg_vectors(work);
    const auto [r, z, p, q] = w;
    auto& sums = work.sums;
    const KrylovDemand sum{Kind::sum, sums.of_blocks(), {}};
    detail::Convergence convergence(options, report);
    detail::form_right_sums(team, sums, right);
    co_yield sum;
    detail::accept_right(team, work, options, right, report);

    for (int round = 0;; ++round) { // a round ends when the recursion says converged; the solution has the last word
        if (round == 0 && options.from_zero) std::fill(q.begin(), q.end(), 0.0);
        else co_yield KrylovDemand{Kind::apply, x, q};
        detail::form_residual(team, work, right.data(), q.data(), r.data());
        co_yield sum;
        double norm = std::sqrt(sums.total(0)), alpha = 0.0, last_rho = 1.0;
        if (round > 0 && convergence.at_round_off(norm)) {
            report.residuals.push_back(norm);
            break;
        }
        if (convergence.reached(norm)) break;
        double largest = norm;
        while (norm > convergence.target()) {
            co_yield KrylovDemand{Kind::precondition, r, z};
            sums.form(team, [r = r.data(), z = z.data(), q = q.data()](Flat b, Flat e) {
                return std::array{dot(b, e, z, r), dot(b, e, z, q), ordered_sum(b, e, [=](Flat c) { return z[c]; })};
            });
            co_yield sum;
            const double rho = sums.total(0), beta = -alpha * sums.total(1) / last_rho;
            convergence.require(rho > 0.0, "the preconditioner is not positive");
            const double mean = options.singular ? sums.total(2) / double(work.all_cells) : 0.0;
            detail::for_cells(team, *work.layout, [p = p.data(), z = z.data(), beta, mean, first = alpha == 0.0](Flat c) {
                p[c] = (z[c] - mean) + (first ? 0.0 : beta * p[c]);
            });
            co_yield KrylovDemand{Kind::apply, p, q};
            sums.form(team, [p = p.data(), q = q.data()](Flat b, Flat e) { return std::array{dot(b, e, p, q)}; });
            co_yield sum;
            convergence.require(sums.total(0) > 0.0, "the operator is not positive");
            alpha = rho / sums.total(0);
            last_rho = rho;
            step(team, work, w, alpha, x);
            co_yield sum;
            ++report.iterations;
            norm = std::sqrt(sums.total(0));
            largest = std::max(largest, norm);
            if (norm > convergence.target()) (void)convergence.reached(norm);
        }
        if (convergence.trusted(norm, largest)) break;
    }
    if (options.singular) {
        detail::form_sum(team, sums, x.data());
        co_yield sum;
        detail::for_cells(team, *work.layout, [x = x.data(), mean = sums.total(0) / double(work.all_cells)](Flat c) { x[c] -= mean; });
    }
}

} // namespace physics
