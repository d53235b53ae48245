// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/krylov_parts.hpp"

#include <algorithm>

namespace physics {

using detail::Flat;
using Kind = KrylovDemand::Kind;

namespace {

struct BiCgVectors {
    std::span<double> r, shadow, p, v, t, correction;
};

BiCgVectors bicg_vectors(KrylovWorkspace& work)
{
    work.reserve(6);
    auto& w = work.vectors;
    return {w[0], w[1], w[2], w[3], w[4], w[5]};
}

void start_directions(const core::Team& team, const KrylovWorkspace& work, const BiCgVectors& w)
{
    detail::for_cells(team, *work.layout, [s = w.shadow.data(), p = w.p.data(), r = w.r.data()](Flat c) {
        s[c] = r[c];
        p[c] = 0.0;
    });
}

/// Sums whose ratio is omega: the residual becomes least along its own image.
void form_damping_sums(const core::Team& team, KrylovWorkspace& work, const BiCgVectors& w)
{
    work.sums.form(team, [r = w.r.data(), t = w.t.data()](Flat b, Flat e) { return std::array{dot(b, e, t, r), dot(b, e, t, t)}; });
}

/// p = r + beta (p - omega v)
void new_direction(const core::Team& team, const KrylovWorkspace& work, const BiCgVectors& w, double beta, double omega)
{
    detail::for_cells(team, *work.layout, [p = w.p.data(), r = w.r.data(), v = w.v.data(), beta, omega](Flat c) {
        p[c] = r[c] + beta * (p[c] - omega * v[c]);
    });
}

/// x += factor * correction; r -= factor * change; sums of the squares of r and of r times shadow.
void step(const core::Team& team, KrylovWorkspace& work, const BiCgVectors& w, double factor, std::span<double> change, std::span<double> x)
{
    work.sums.form(team,
                   [r = w.r.data(), s = w.shadow.data(), d = w.correction.data(), q = change.data(), x = x.data(), factor](Flat b, Flat e) {
#pragma omp simd
                       for (Flat c = b; c < e; ++c) {
                           x[c] += factor * d[c];
                           r[c] -= factor * q[c];
                       }
                       return std::array{dot(b, e, r, r), dot(b, e, r, s)};
                   });
}

} // namespace

KrylovProcess bicgstab(const core::Team& team, KrylovWorkspace& work, const KrylovOptions& options, std::span<double> right,
                       std::span<double> x, KrylovReport& report)
{
    const BiCgVectors w = bicg_vectors(work);
    auto& sums = work.sums;
    const KrylovDemand sum{Kind::sum, sums.of_blocks(), {}};
    detail::Convergence convergence(options, report);
    detail::form_right_sums(team, sums, right);
    co_yield sum;
    detail::accept_right(team, work, options, right, report);

    for (int round = 0;; ++round) { // a round ends when the recursion converges or breaks down
        if (round == 0 && options.from_zero) std::fill(w.v.begin(), w.v.end(), 0.0);
        else co_yield KrylovDemand{Kind::apply, x, w.v};
        detail::form_residual(team, work, right.data(), w.v.data(), w.r.data());
        co_yield sum;
        double norm = std::sqrt(sums.total(0)), rho = sums.total(0), beta = 0.0, omega = 0.0;
        if (round > 0 && convergence.at_round_off(norm)) {
            report.residuals.push_back(norm);
            break;
        }
        if (convergence.reached(norm)) break;
        double largest = norm;
        start_directions(team, work, w);
        while (norm > convergence.target()) {
            ++report.iterations;
            new_direction(team, work, w, beta, omega);
            co_yield KrylovDemand{Kind::precondition, w.p, w.correction};
            co_yield KrylovDemand{Kind::apply, w.correction, w.v};
            sums.form(team, [s = w.shadow.data(), v = w.v.data()](Flat b, Flat e) { return std::array{dot(b, e, s, v)}; });
            co_yield sum;
            if (sums.total(0) == 0.0) break;
            const double alpha = rho / sums.total(0);
            step(team, work, w, alpha, w.v, x);
            co_yield sum;
            norm = std::sqrt(sums.total(0));
            largest = std::max(largest, norm);
            if (norm <= convergence.target()) break; // half an iteration does
            co_yield KrylovDemand{Kind::precondition, w.r, w.correction};
            co_yield KrylovDemand{Kind::apply, w.correction, w.t};
            form_damping_sums(team, work, w);
            co_yield sum;
            omega = sums.total(1) > 0.0 ? sums.total(0) / sums.total(1) : 0.0;
            step(team, work, w, omega, w.t, x);
            co_yield sum;
            norm = std::sqrt(sums.total(0));
            const double next_rho = sums.total(1);
            if (norm > convergence.target() && !convergence.reached(norm) && (omega == 0.0 || next_rho == 0.0)) break;
            beta = next_rho / rho * (alpha / omega);
            rho = next_rho;
            largest = std::max(largest, norm);
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
