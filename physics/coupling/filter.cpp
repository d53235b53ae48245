// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/filter.hpp"

#include "core/base/error.hpp"
#include <algorithm>
#include <cmath>

namespace physics {
namespace {

LevelMesh sorted_mesh(BlockTopology topology, std::vector<int>& link_source)
{
    topology.links = canonical_links(topology.links, link_source);
    return make_level_mesh(topology);
}

/// Rows of a piece one after the other: body(flat begin, row of the view, cells).
template <class Body>
void for_rows(const core::Team& team, const BlockLayout& layout, Body body)
{
    layout.for_pieces(team, [&](int n) {
        const auto& p = layout.pieces()[std::size_t(n)];
        const auto c = layout.cells(p.block);
        for (int row = p.first(c.nj * c.nk); row < p.last(c.nj * c.nk); ++row)
            body(p.block, row % c.nj, row / c.nj, layout.origin(p.block) + std::ptrdiff_t(row) * c.ni, c.ni);
    });
}

} // namespace

std::vector<double> chebyshev_exponential(double a, double tolerance)
{
    if (!(a > 0.0)) return {1.0};
    // Scaled Bessel functions exp(-a) I_k(a) from their recurrence, downwards from far beyond the last that counts.
    const int start = 20 + int(a + 12.0 * std::sqrt(a + 40.0));
    std::vector<double> bessel(std::size_t(start) + 2, 0.0);
    bessel[std::size_t(start)] = 1e-250;
    for (int k = start; k > 0; --k) {
        const auto n = std::size_t(k);
        bessel[n - 1] = bessel[n + 1] + 2.0 * k / a * bessel[n];
        if (bessel[n - 1] > 1e200)
            for (std::size_t m = n - 1; m < bessel.size(); ++m) bessel[m] *= 1e-200;
    }
    double total = bessel[0];
    for (std::size_t k = 1; k < bessel.size(); ++k) total += 2.0 * bessel[k];
    std::vector<double> c{bessel[0] / total};
    double value = c[0]; // of the sum at y = -1, where T_k = (-1)^k
    for (std::size_t k = 1; k < bessel.size() && 1.0 - value > tolerance; ++k) {
        const double term = 2.0 * bessel[k] / total;
        c.push_back(k % 2 == 0 ? term : -term);
        value += term;
    }
    for (double& x : c) x /= value;
    return c;
}

Filter::Filter(const BlockTopology& topology, const FilterOptions& options)
    : options_(options), mesh_(sorted_mesh(topology, link_source_)), matrix_(make_seven_point<double>(mesh_, false)),
      inverse_volume_(mesh_.layout.size(), 0.0),
      groups_(std::size_t((options.fields + fields_per_octet - 1) / fields_per_octet)), messages_(groups_.size())
{
    for (Group& g : groups_) {
        g.sum.assign(mesh_.layout.size(), Octet{});
        for (auto& t : g.t) t.assign(mesh_.layout.size(), Octet{});
    }
}

void Filter::load(const core::Team& team, const Coefficients& transmissibility, const core::ScalarField& volume)
{
    mesh_.layout.for_pieces(team, [&](int n) { copy_coefficients(mesh_, transmissibility, n, matrix_); });
    copy_links(mesh_, transmissibility, link_source_, matrix_);
    for_rows(team, mesh_.layout, [&](core::LocalBlock b, int j, int k, std::ptrdiff_t at, int n) {
        const double* v = volume.on(b).row(j, k);
        for (int i = 0; i < n; ++i) inverse_volume_[std::size_t(at + i)] = 1.0 / v[i];
    });
}

double Filter::eigenvalue_bound() const
{
    std::vector<double> sums(mesh_.layout.size(), 0.0);
    double bound = 0.0;
    for (std::size_t n = 0; n < mesh_.layout.pieces().size(); ++n) {
        const auto& p = mesh_.layout.pieces()[n];
        coefficient_sums(mesh_, matrix_, int(n), 3, sums.data());
        for (auto c = std::size_t(p.begin); c < std::size_t(p.end); ++c) bound = std::max(bound, 2.0 * sums[c] * inverse_volume_[c]);
    }
    return bound; // Gershgorin: twice the largest diagonal entry
}

void Filter::set_bound(double bound)
{
    bound_ = bound;
    // The polynomial differs from the exponential by twice the part that is cut off.
    coefficients_ = chebyshev_exponential(0.125 * options_.bandwidth * options_.bandwidth * bound, 0.5 * options_.undershoot);
    core::require<core::ConfigError>(
        degree() <= options_.most_degree,
        core::text("the coupling filter of bandwidth ", options_.bandwidth, " m needs ", degree(), " passes (at most ",
                   options_.most_degree, "): the thinnest cells are about ", std::sqrt(4.0 / bound),
                   " m. Use a smaller bandwidth or thicker cells where particles are."));
}

void Filter::put(const core::Team& team, int n, const std::function<core::View<const double>(core::LocalBlock)>& density)
{
    Group& g = groups_[std::size_t(n / fields_per_octet)];
    const int f = n % fields_per_octet;
    for_rows(team, mesh_.layout, [&, c = coefficients_[0]](core::LocalBlock b, int j, int k, std::ptrdiff_t at, int cells) {
        const double* from = density(b).row(j, k);
        for (int i = 0; i < cells; ++i) {
            g.t[0][std::size_t(at + i)].field[f] = from[i];
            g.sum[std::size_t(at + i)].field[f] = c * from[i];
        }
    });
}

void Filter::take(const core::Team& team, int n, const std::function<core::View<double>(core::LocalBlock)>& density) const
{
    const Group& g = groups_[std::size_t(n / fields_per_octet)];
    const int f = n % fields_per_octet;
    for_rows(team, mesh_.layout, [&](core::LocalBlock b, int j, int k, std::ptrdiff_t at, int cells) {
        double* to = density(b).row(j, k);
        for (int i = 0; i < cells; ++i) to[i] = g.sum[std::size_t(at + i)].field[f];
    });
}

void Filter::pass_piece(int piece, int number, Group& group)
{
    const Piece& p = mesh_.layout.pieces()[std::size_t(piece)];
    const core::Extents cells = mesh_.layout.cells(p.block);
    const std::ptrdiff_t row = cells.ni, plane = row * cells.nj;
    const double *ti = matrix_.face[0].data(), *tj = matrix_.face[1].data(), *tk = matrix_.face[2].data();
    const std::size_t now = std::size_t(number + 1) % 2;
    const double scale = bound_ > 0.0 ? 2.0 / bound_ : 0.0, term = coefficients_[std::size_t(number)];
    const double factor = number == 1 ? 1.0 : 2.0, keep = number == 1 ? 0.0 : 1.0;
    const Octet* t = group.t[now].data();
    Octet *last = group.t[1 - now].data(), *sum = group.sum.data();
    int half = mesh_.piece_halves[std::size_t(piece)];
    const int last_half = mesh_.piece_halves[std::size_t(piece) + 1];
    for (auto c = p.begin; c < p.end; ++c) {
        const Octet& x = t[c];
        Octet out;
        const std::array<double, 6> a{ti[c], ti[c + 1], tj[c], tj[c + row], tk[c], tk[c + plane]};
        const std::array<const Octet*, 6> y{t + c - 1, t + c + 1, t + c - row, t + c + row, t + c - plane, t + c + plane};
#pragma omp simd
        for (int f = 0; f < fields_per_octet; ++f) {
            const double v = x.field[f];
            out.field[f] = a[0] * (v - y[0]->field[f]) + a[1] * (v - y[1]->field[f]) + a[2] * (v - y[2]->field[f]) +
                           a[3] * (v - y[3]->field[f]) + a[4] * (v - y[4]->field[f]) + a[5] * (v - y[5]->field[f]);
        }
        for (; half < last_half && mesh_.halves[std::size_t(half)].cell == c; ++half) { // halves are sorted by cell
            const Octet& there = t[mesh_.halves[std::size_t(half)].other];
            const double link = matrix_.half[std::size_t(half)];
#pragma omp simd
            for (int f = 0; f < fields_per_octet; ++f) out.field[f] += link * (x.field[f] - there.field[f]);
        }
        const double w = scale * inverse_volume_[std::size_t(c)];
        Octet &old = last[c], &total = sum[c];
#pragma omp simd
        for (int f = 0; f < fields_per_octet; ++f) {
            const double next = factor * (w * out.field[f] - x.field[f]) - keep * old.field[f];
            old.field[f] = next;
            total.field[f] += term * next;
        }
    }
}

void Filter::pass(const core::Team& team, int number, int fields)
{
    const int used = (fields + fields_per_octet - 1) / fields_per_octet;
    for (int g = 0; g < used; ++g)
        mesh_.layout.for_pieces(team, [&](int piece) { pass_piece(piece, number, groups_[std::size_t(g)]); });
}

void Filter::run(const core::Team& team, int fields)
{
    for (int number = 1; number <= degree(); ++number) pass(team, number, fields);
}

void Filter::start_ghosts(int number, int fields, const core::Communicator& communicator, core::Pending& pending)
{
    const int used = (fields + fields_per_octet - 1) / fields_per_octet;
    for (int g = 0; g < used; ++g)
        messages_[std::size_t(g)].start_ghosts(mesh_, std::span(groups_[std::size_t(g)].t[std::size_t(number + 1) % 2]), communicator, pending);
}

} // namespace physics
