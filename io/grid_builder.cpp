// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/grid_builder.hpp"
#include "core/grid/box.hpp"
#include "core/grid/pipe.hpp"
#include <set>

namespace io {
namespace {

core::MultiBlock blocks_of(const PipeGrid& pipe, bool periodic)
{
    const PipeCells cells = pipe.chosen_cells();
    core::Pipe p;
    p.diameter = pipe.diameter;
    p.length = pipe.length;
    p.core_cells = cells.core();
    p.wing_cells = cells.wing();
    p.axial_cells = cells.along;
    p.blocks_along = pipe.blocks_along;
    p.core_fraction = pipe.core_fraction;
    p.periodic = periodic;
    return core::make_pipe(p);
}

core::MultiBlock blocks_of(const BoxGrid& box, const Grid& grid)
{
    core::Box b;
    b.low = core::Vec3::Zero();
    b.high = box.size;
    b.cells = {box.cells[0], box.cells[1], box.cells[2]};
    b.blocks = {box.blocks[0], box.blocks[1], box.blocks[2]};
    for (int axis = 0; axis < 3; ++axis) b.periodic[std::size_t(axis)] = grid.is_periodic(axis);
    return core::make_box(b);
}

} // namespace

core::MultiBlock make_blocks(const Grid& grid)
{
    return grid.pipe ? blocks_of(*grid.pipe, grid.is_periodic(0)) : blocks_of(*grid.box, grid);
}

core::Domain make_domain(const Grid& grid)
{
    core::Domain domain;
    domain.origin = grid.low();
    domain.size = grid.high() - grid.low();
    for (int axis = 0; axis < 3; ++axis) domain.periodic[std::size_t(axis)] = grid.is_periodic(axis);
    return domain;
}

std::vector<physics::Wall> primitive_walls(const Grid& grid)
{
    const core::Domain domain = make_domain(grid);
    std::vector<physics::Wall> walls;
    if (grid.pipe) walls.push_back(physics::CylinderWall{-domain.origin, core::Vec3::UnitX(), grid.pipe->diameter / 2});
    for (int axis = 0; axis < (grid.pipe ? 1 : 3); ++axis) {
        if (grid.is_periodic(axis)) continue;
        walls.push_back(physics::PlaneWall{core::Vec3::Zero(), core::Vec3::Unit(axis)});
        walls.push_back(physics::PlaneWall{domain.size, -core::Vec3::Unit(axis)});
    }
    return walls;
}

std::vector<std::string> wall_names(const core::Mesh& mesh)
{
    std::set<std::string> names;
    for (const core::Boundary& boundary : mesh.topology().boundaries) names.insert(boundary.name);
    return {names.begin(), names.end()};
}

} // namespace io
