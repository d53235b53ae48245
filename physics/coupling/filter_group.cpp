// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/filter_group.hpp"

namespace physics {
namespace {

/// Rows of a piece: body(j, k, flat place of the first cell, cells).
template <class Body>
void for_rows(const BlockLayout& layout, const Piece& p, Body body)
{
    const auto c = layout.cells(p.block);
    for (int row = p.first(c.nj * c.nk); row < p.last(c.nj * c.nk); ++row)
        body(row % c.nj, row / c.nj, layout.origin(p.block) + std::ptrdiff_t(row) * c.ni, c.ni);
}

} // namespace

FilterGroup::FilterGroup(const FilterOperator& filter) : filter_(&filter)
{
    for (auto& value : value_) value.assign(filter.mesh.layout.size(), Lanes{});
}

void FilterGroup::put(const core::Team& team, int first, int count, const FieldsIn& fields)
{
    const BlockLayout& layout = filter_->mesh.layout;
    layout.for_pieces(team, [&](int n) {
        const Piece& p = layout.pieces()[std::size_t(n)];
        std::array<core::View<const double>, width> from;
        for (int f = 0; f < width; ++f) from[std::size_t(f)] = fields(p.block, first + std::min(f, count - 1));
        for_rows(layout, p, [&](int j, int k, std::ptrdiff_t at, int cells) {
            Lanes* to = value_[0].data() + at;
            std::array<const double*, width> row;
            for (int f = 0; f < width; ++f) row[std::size_t(f)] = from[std::size_t(f)].row(j, k);
            for (int i = 0; i < cells; ++i)
                for (int f = 0; f < width; ++f) to[i].field[f] = row[std::size_t(f)][i];
        });
    });
    if (filter_->polynomial.steps.empty()) sum_.resize(value_[0].size());
}

void FilterGroup::take(const core::Team& team, int first, int count, const FieldsOut& fields) const
{
    const BlockLayout& layout = filter_->mesh.layout;
    const FilterPolynomial& polynomial = filter_->polynomial;
    const auto& result = polynomial.steps.empty() && polynomial.degree() > 0 ? sum_ : before(polynomial.degree() + 1);
    layout.for_pieces(team, [&](int n) {
        const Piece& p = layout.pieces()[std::size_t(n)];
        std::array<core::View<double>, width> to;
        for (int f = 0; f < count; ++f) to[std::size_t(f)] = fields(p.block, first + f);
        for_rows(layout, p, [&](int j, int k, std::ptrdiff_t at, int cells) {
            const Lanes* from = result.data() + at;
            std::array<double*, width> row{};
            for (int f = 0; f < count; ++f) row[std::size_t(f)] = to[std::size_t(f)].row(j, k);
            for (int i = 0; i < cells; ++i)
                for (int f = 0; f < count; ++f) row[std::size_t(f)][i] = from[i].field[f];
        });
    });
}

void FilterGroup::start_ghosts(int number, const core::Communicator& communicator, core::Pending& pending)
{
    messages_.start_ghosts(filter_->mesh, std::span(value_[std::size_t(number + 1) % 2]), communicator, pending);
}

/// Calls finish(cell, value, loss) for every cell, all lanes at once: y of filter_polynomial.hpp is value - loss, but for what
/// comes over half links; then correct(cell, gain) for each of those: no branch stands in the way of either loop.
template <class Finish, class Correct>
void FilterGroup::sweep(const core::Team& team, int number, Finish finish, Correct correct) const
{
    const LevelMesh& mesh = filter_->mesh;
    const Lanes* x = before(number).data();
    const FilterOperator::Cell* cell = filter_->cells.data();
    mesh.layout.for_pieces(team, [&](int piece) {
        const Piece& p = mesh.layout.pieces()[std::size_t(piece)];
        const core::Extents cells = mesh.layout.cells(p.block);
        const std::ptrdiff_t row = cells.ni, plane = row * cells.nj;
        Lanes inflow{}; // through the low face along i, which is the high one of the cell before; none begins a row
        for (auto c = p.begin; c < p.end; ++c) {
            const auto* a = cell + c;
            const Lanes* v = x + c;
            const std::array<double, 5> t{a[1].low_face[0], a[0].low_face[1], a[row].low_face[1], a[0].low_face[2], a[plane].low_face[2]};
            Lanes loss;
#pragma omp simd
            for (int f = 0; f < width; ++f) {
                const double q = v->field[f], to_next = t[0] * (q - v[1].field[f]);
                const double outflow = to_next - inflow.field[f] + t[1] * (q - v[-row].field[f]) + t[2] * (q - v[row].field[f]) +
                                       t[3] * (q - v[-plane].field[f]) + t[4] * (q - v[plane].field[f]);
                inflow.field[f] = to_next;
                loss.field[f] = a->weight * outflow;
            }
            finish(c, *v, loss);
        }
        for (int h = mesh.piece_halves[std::size_t(piece)]; h < mesh.piece_halves[std::size_t(piece) + 1]; ++h) {
            const HalfLink& half = mesh.halves[std::size_t(h)];
            const double part = filter_->half[std::size_t(h)];
            Lanes gain;
#pragma omp simd
            for (int f = 0; f < width; ++f) gain.field[f] = part * (x[half.other].field[f] - x[half.cell].field[f]);
            correct(half.cell, gain);
        }
    });
}

void FilterGroup::explicit_step(const core::Team& team, int number)
{
    const double share = filter_->polynomial.steps[std::size_t(number - 1)];
    Lanes* next = after(number).data();
    sweep(
        team, number,
        [=](std::ptrdiff_t c, const Lanes& x, const Lanes& loss) {
#pragma omp simd
            for (int f = 0; f < width; ++f) next[c].field[f] = x.field[f] - share * loss.field[f];
        },
        [=](int c, const Lanes& gain) {
#pragma omp simd
            for (int f = 0; f < width; ++f) next[c].field[f] += share * gain.field[f];
        });
}

/// The zeroth and first of the sum.
void FilterGroup::first_term(const core::Team& team)
{
    const double zeroth = filter_->polynomial.coefficients[0], first = filter_->polynomial.coefficients[1];
    Lanes *next = after(1).data(), *sum = sum_.data();
    sweep(
        team, 1,
        [=](std::ptrdiff_t c, const Lanes& x, const Lanes& loss) {
#pragma omp simd
            for (int f = 0; f < width; ++f) {
                next[c].field[f] = loss.field[f] - x.field[f];
                sum[c].field[f] = zeroth * x.field[f] + first * next[c].field[f];
            }
        },
        [=](int c, const Lanes& gain) {
#pragma omp simd
            for (int f = 0; f < width; ++f) {
                next[c].field[f] -= gain.field[f];
                sum[c].field[f] -= first * gain.field[f];
            }
        });
}

void FilterGroup::next_term(const core::Team& team, int number)
{
    const double term = filter_->polynomial.coefficients[std::size_t(number)];
    Lanes *next = after(number).data(), *sum = sum_.data();
    sweep(
        team, number,
        [=](std::ptrdiff_t c, const Lanes& x, const Lanes& loss) {
#pragma omp simd
            for (int f = 0; f < width; ++f) {
                const double value = 2.0 * (loss.field[f] - x.field[f]) - next[c].field[f];
                next[c].field[f] = value;
                sum[c].field[f] += term * value;
            }
        },
        [=](int c, const Lanes& gain) {
#pragma omp simd
            for (int f = 0; f < width; ++f) {
                next[c].field[f] -= 2.0 * gain.field[f];
                sum[c].field[f] -= 2.0 * term * gain.field[f];
            }
        });
}

void FilterGroup::pass(const core::Team& team, int number)
{
    if (!filter_->polynomial.steps.empty()) explicit_step(team, number);
    else if (number == 1) first_term(team);
    else next_term(team, number);
}

} // namespace physics
