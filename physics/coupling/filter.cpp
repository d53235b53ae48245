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

} // namespace

Filter::Filter(const BlockTopology& topology, const FilterOptions& options)
    : options_(options), operator_(sorted_mesh(topology, link_source_))
{
    for (int first = 0; first < options.fields; first += FilterGroup::width) groups_.emplace_back(operator_);
}

void Filter::load(const core::Team& team, const Coefficients& transmissibility, const core::ScalarField& volume)
{
    const LevelMesh& mesh = operator_.mesh;
    SevenPoint<double> matrix = make_seven_point<double>(mesh, false);
    mesh.layout.for_pieces(team, [&](int n) { copy_coefficients(mesh, transmissibility, n, matrix); });
    copy_links(mesh, transmissibility, link_source_, matrix);
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b) {
        const core::Extents n = mesh.layout.cells(b);
        FilterOperator::Cell* cell = operator_.cells.data() + mesh.layout.origin(b);
        core::for_each_cell(n, [&](int i, int j, int k) { (cell++)->weight = 1.0 / volume.on(b)(i, j, k); });
    }
    for (std::size_t c = 0; c < operator_.cells.size(); ++c)
        for (std::size_t axis = 0; axis < 3; ++axis) operator_.cells[c].low_face[axis] = matrix.face[axis][c];
    for (std::size_t h = 0; h < mesh.halves.size(); ++h)
        operator_.half[h] = matrix.half[h] * operator_.cells[std::size_t(mesh.halves[h].cell)].weight;
    std::vector<double> sums(mesh.layout.size(), 0.0);
    own_bound_ = 0.0;
    for (std::size_t n = 0; n < mesh.layout.pieces().size(); ++n) {
        const Piece& p = mesh.layout.pieces()[n];
        coefficient_sums(mesh, matrix, int(n), 3, sums.data());
        for (auto c = std::size_t(p.begin); c < std::size_t(p.end); ++c)
            own_bound_ = std::max(own_bound_, 2.0 * sums[c] * operator_.cells[c].weight); // Gershgorin: twice the diagonal entry
    }
}

void Filter::set_bound(double bound)
{
    const double scale = bound > 0.0 ? 2.0 / bound : 0.0;
    for (auto& cell : operator_.cells) cell.weight *= scale;
    for (double& half : operator_.half) half *= scale;
    FilterPolynomial& polynomial = operator_.polynomial;
    const double steps = 0.125 * options_.bandwidth * options_.bandwidth * bound;
    polynomial = {};
    if (steps <= options_.most_steps) polynomial.steps = diffusion_steps(steps);
    else polynomial.coefficients = chebyshev_exponential(steps, 0.5 * options_.undershoot); // differs by twice what is cut off
    core::require<core::ConfigError>(degree() <= options_.most_degree,
                                     core::text("the coupling filter of bandwidth ", options_.bandwidth, " m needs ", degree(),
                                                " passes (at most ", options_.most_degree, "): the thinnest cells are about ",
                                                std::sqrt(4.0 / bound),
                                                " m. Use a smaller bandwidth or thicker cells where particles are."));
}

void Filter::put(const core::Team& team, int fields, const FieldsIn& densities)
{
    for_groups(groups_, fields, [&](FilterGroup& group, int first, int count) { group.put(team, first, count, densities); });
}

void Filter::take(const core::Team& team, int fields, const FieldsOut& densities) const
{
    for_groups(groups_, fields, [&](const FilterGroup& group, int first, int count) { group.take(team, first, count, densities); });
}

void Filter::run(const core::Team& team, int fields)
{
    for_groups(groups_, fields, [&](FilterGroup& group, int, int) { // one after the other: the fields of one stay in the cache
        for (int number = 1; number <= degree(); ++number) group.pass(team, number);
    });
}

void Filter::pass(const core::Team& team, int number, int fields)
{
    for_groups(groups_, fields, [&](FilterGroup& group, int, int) { group.pass(team, number); });
}

void Filter::start_ghosts(int number, int fields, const core::Communicator& communicator, core::Pending& pending)
{
    for_groups(groups_, fields, [&](FilterGroup& group, int, int) { group.start_ghosts(number, communicator, pending); });
}

} // namespace physics
