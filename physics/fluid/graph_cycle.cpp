// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/graph_cycle.hpp"

#include "physics/fluid/block_sums.hpp"

namespace physics {
namespace {

/// Sum of term(n) over all nodes of a level, whose bits do not depend on threads.
template <class Term>
double sum_over_nodes(const core::Team& team, GraphLevel& level, Term term)
{
    std::fill(level.parts.begin(), level.parts.end(), 0.0);
    core::for_chunks(team, level.matrix.nodes(), GraphLevel::grain, [&](int begin, int end) {
        level.parts[std::size_t(begin / GraphLevel::grain)] = ordered_sum(begin, end, [=](std::ptrdiff_t n) { return term(n); });
    });
    double sum = 0.0;
    for (const double part : level.parts) sum += part;
    return sum;
}

double product(const core::Team& team, GraphLevel& level, const std::vector<float>& a, const std::vector<float>& b)
{
    return sum_over_nodes(team, level, [a = a.data(), b = b.data()](std::ptrdiff_t n) { return double(a[n]) * double(b[n]); });
}

template <class Body>
void for_nodes(const core::Team& team, const GraphLevel& level, Body body)
{
    core::for_chunks(team, level.matrix.nodes(), GraphLevel::grain, [&](int begin, int end) {
        const auto own = body;
#pragma omp simd
        for (int n = begin; n < end; ++n) own(n);
    });
}

} // namespace

float GraphCycle::solve(std::size_t level)
{
    if (level + 1 == levels_.size()) {
        solve_coarsest();
        return over_correction;
    }
    visit(level);
    if (!levels_[level].is_visited_twice()) return over_correction;
    visit_again(level);
    return 1.0F;
}

void GraphCycle::solve_coarsest()
{
    GraphLevel& level = levels_.back();
    const auto values = coarsest_.values();
    std::copy(level.right.begin(), level.right.end(), values.begin());
    coarsest_.solve();
    std::transform(values.begin(), values.end(), level.solution.begin(), [](double v) { return float(v); });
}

void GraphCycle::visit(std::size_t level)
{
    GraphLevel &fine = levels_[level], &coarse = levels_[level + 1];
    smooth_from_zero(team_, fine);
    form_residual(team_, fine);
    restrict_residual(fine, coarse);
    const float gain = solve(level + 1);
    add_correction(coarse, gain, fine);
    smooth(team_, fine);
}

/// Two steps of flexible conjugate gradients, of which the first visit is half.
/// @source  Notay & Vassilevski, Numer. Linear Algebra Appl. 15 (2008) 473, algorithm 3.2.
void GraphCycle::visit_again(std::size_t level)
{
    constexpr double enough = 0.3; // of the residual left by the first visit: another one would cost more than it saves
    GraphLevel& a = levels_[level];
    const auto sum = [&](const std::vector<float>& x, const std::vector<float>& y) { return product(team_, a, x, y); };
    form_residual(team_, a);
    for_nodes(team_, a,
              [s = a.solution.data(), r = a.right.data(), left = a.residual.data(), first = a.first_solution.data(),
               image = a.first_image.data()](int n) {
                  first[n] = s[n];
                  image[n] = r[n] - left[n];
              });
    const double energy = sum(a.first_solution, a.first_image), work = sum(a.first_solution, a.right), before = sum(a.right, a.right);
    if (!(energy > 0.0)) return; // nothing to do: no right-hand side
    const auto step = float(work / energy);
    for_nodes(team_, a, [r = a.right.data(), image = a.first_image.data(), step](int n) { r[n] -= step * image[n]; });
    if (sum(a.right, a.right) <= enough * enough * before) {
        for_nodes(team_, a, [s = a.solution.data(), step](int n) { s[n] *= step; });
        return;
    }
    visit(level);
    form_residual(team_, a);
    for_nodes(team_, a, [r = a.right.data(), left = a.residual.data()](int n) { left[n] = r[n] - left[n]; }); // the second image
    const double mixed = sum(a.solution, a.first_image), second_work = sum(a.solution, a.right);
    const double second_energy = sum(a.solution, a.residual) - mixed * mixed / energy;
    const double second_step = second_energy > 0.0 ? second_work / second_energy : 0.0;
    for_nodes(team_, a,
              [s = a.solution.data(), first = a.first_solution.data(), one = float(work / energy - mixed / energy * second_step),
               two = float(second_step)](int n) { s[n] = one * first[n] + two * s[n]; });
}

} // namespace physics
