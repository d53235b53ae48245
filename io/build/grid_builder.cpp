// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/grid_builder.hpp"
#include "core/base/error.hpp"
#include "core/grid/annulus.hpp"
#include "core/grid/bent_pipe.hpp"
#include "core/grid/blocks_apart.hpp"
#include "core/grid/elliptic_grid.hpp"
#include "core/grid/pipe.hpp"
#include "core/grid/stepped_channel.hpp"
#include "core/grid/touching_sides.hpp"
#include "core/grid/wavy_box.hpp"
#include "io/build/imported_blocks.hpp"
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
    b.periodic = grid.periodic_axes();
    return core::make_box(b);
}

core::MultiBlock blocks_of(const WavyBoxGrid& box, const Grid& grid)
{
    core::Box b;
    b.high = box.size;
    b.cells = {box.cells[0], box.cells[1], box.cells[2]};
    b.blocks = {box.blocks[0], box.blocks[1], box.blocks[2]};
    b.periodic = grid.periodic_axes();
    return core::make_wavy_box(b, {box.amplitude, box.waves});
}

core::MultiBlock blocks_of(const AnnulusGrid& annulus, const Grid& grid)
{
    core::Annulus a;
    a.inner_diameter = annulus.inner_diameter;
    a.outer_diameter = annulus.outer_diameter;
    a.length = annulus.length;
    a.cells = {annulus.cells_along, annulus.cells_outwards, annulus.cells_around};
    a.blocks = {annulus.blocks_along, annulus.blocks_outwards, annulus.blocks_around};
    a.growth = annulus.growth;
    a.periodic = grid.is_periodic(0);
    a.angle = annulus.angle;
    return core::make_annulus(a);
}

core::MultiBlock blocks_of(const BentPipeGrid& pipe, const Grid& grid)
{
    core::BentPipe p;
    p.diameter = pipe.diameter;
    p.core_cells = pipe.across / 2;
    p.wing_cells = pipe.across / 4;
    p.core_fraction = pipe.core_fraction;
    for (const PipePieceGrid& piece : pipe.pieces)
        p.pieces.push_back(
            {piece.length.value_or(0), piece.angle.value_or(0), piece.radius.value_or(0), piece.towards, piece.cells, piece.blocks});
    p.periodic = !grid.periodic.empty();
    core::MultiBlock made = core::make_bent_pipe(p);
    for (const core::Vec3& period : made.periods)
        for (int axis = 0; axis < 3; ++axis)
            core::require<core::ConfigError>(
                std::abs(period[axis]) < 1e-9 * period.norm() || grid.is_periodic(axis),
                core::text("the ends of the pipe are apart by (", period.transpose(), ") m: this must be along the periodic axis"));
    return made;
}

core::MultiBlock blocks_of(const SteppedChannelGrid& channel, const Grid& grid)
{
    core::SteppedChannel c;
    c.shallow_length = channel.shallow_length;
    c.deep_length = channel.deep_length;
    c.height = channel.height;
    c.step = channel.step;
    c.width = channel.width;
    c.cells_along = {channel.cells_shallow, channel.cells_deep};
    c.cells_up = {channel.cells_step, channel.cells_height};
    c.cells_across = channel.cells_across;
    c.deep_cells_up = channel.deep_cells_height;
    c.deep_cells_across = channel.deep_cells_across;
    c.blocks_along = {channel.blocks_shallow, channel.blocks_deep};
    c.blocks_across = channel.blocks_across;
    c.periodic_along = grid.is_periodic(0);
    c.periodic_across = grid.is_periodic(2);
    return core::make_stepped_channel(c);
}

std::optional<core::PeriodicTurn> turn_of(const Grid& grid)
{
    if (!grid.turn) return std::nullopt;
    return core::PeriodicTurn{grid.turn->axis, grid.turn->point, grid.turn->angle};
}

core::MultiBlock blocks_of_shape(const Grid& grid)
{
    if (grid.pipe) return blocks_of(*grid.pipe, grid.is_periodic(0));
    if (grid.box) return blocks_of(*grid.box, grid);
    if (grid.wavy_box) return blocks_of(*grid.wavy_box, grid);
    if (grid.annulus) return blocks_of(*grid.annulus, grid);
    if (grid.bent_pipe) return blocks_of(*grid.bent_pipe, grid);
    if (grid.stepped_channel) return blocks_of(*grid.stepped_channel, grid);
    core::require<core::ConfigError>(grid.blocks.has_value(), "the scene has no grid");
    return import_blocks(*grid.blocks, grid.periodic_axes(), turn_of(grid));
}

core::EllipticGrid elliptic_of(const EllipticKeys& keys)
{
    core::EllipticGrid elliptic;
    for (const SpacingKeys& s : keys.spacing) elliptic.spacings.push_back({s.boundary, s.first_cell, s.growth});
    for (const AttractionKeys& a : keys.attract) elliptic.attractions.push_back({a.block, {{a.i, a.j, a.k}, a.strength, a.reach}});
    elliptic.smoothed = keys.smooth;
    elliptic.curvature = keys.curvature == CurvatureForm::spline ? core::Curvature::cubic_spline : core::Curvature::compact;
    return elliptic;
}

/// @throws ConfigError naming the block where the control functions had to be weakened, so that no cell folds.
void generate_inside(const EllipticKeys& keys, core::MultiBlock& blocks)
{
    constexpr double tolerance = 0.05; // of the height of first cells
    const auto results = core::make_elliptic(blocks, elliptic_of(keys));
    for (std::size_t b = 0; b < results.size(); ++b) {
        const auto [iterations, move, share, error] = results[b];
        core::require<core::ConfigError>(share == 1,
                                         core::text("block ", b, ": cells fold under what is asked in 'elliptic'; it holds with ", share,
                                                    " of it: weaken attractions or spacings"));
        core::require<core::ConfigError>(error < tolerance, core::text("block ", b, ": the first cells miss the height that is asked by ",
                                                                       100 * error, " %: ask for less growth, or take more cells"));
    }
}

} // namespace

core::MultiBlock make_blocks(const Grid& grid)
{
    core::MultiBlock blocks = blocks_of_shape(grid);
    blocks.turn = turn_of(grid);
    core::require<core::ConfigError>(
        !grid.elliptic || blocks.contacts.empty(),
        "insides of blocks whose points do not match where they touch cannot be generated yet: remove 'elliptic'");
    if (grid.elliptic) generate_inside(*grid.elliptic, blocks);
    return blocks;
}

void require_turn_joins(const Grid& grid)
{
    core::MultiBlock made = make_blocks(grid);
    const core::Topology topology = core::match_sides(made);
    core::require_turn_joins(made, topology);
}

GridMeasure measured(const Grid& grid)
{
    core::MultiBlock made = make_blocks(grid);
    (void)core::match_sides(made);
    if (grid.blocks || grid.bent_pipe) core::require_apart(made);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    GridMeasure m{core::Vec3::Constant(infinity), core::Vec3::Constant(-infinity), 0.0};
    for (std::size_t b = 0; b < made.blocks.size(); ++b) {
        m.volume += core::checked_volume(made, core::BlockId(b));
        for (const core::Vec3& x : made.blocks[b].data()) {
            m.low = m.low.cwiseMin(x);
            m.high = m.high.cwiseMax(x);
        }
    }
    for (const core::Vec3& period : made.periods)
        for (int axis = 0; axis < 3; ++axis)
            if (grid.is_periodic(axis) && period[axis] != 0) {
                const double middle = 0.5 * (m.low[axis] + m.high[axis]);
                m.low[axis] = middle - 0.5 * std::abs(period[axis]);
                m.high[axis] = m.low[axis] + std::abs(period[axis]);
            }
    return m;
}

core::Domain make_domain(const Grid& grid)
{
    core::require<core::ConfigError>(grid.is_primitive() || grid.measure, "the grid must be measured before it has a domain");
    core::Domain domain;
    domain.origin = grid.low();
    domain.size = grid.high() - grid.low();
    domain.periodic = grid.periodic_axes();
    return domain;
}

std::vector<physics::Wall> primitive_walls(const Grid& grid, const WallMaterials& materials)
{
    const core::Domain domain = make_domain(grid);
    std::vector<physics::Wall> walls;
    const auto add = [&](auto wall, const std::string& side) {
        wall.material = materials.of_side(side);
        walls.push_back(wall);
    };
    if (grid.pipe) add(physics::CylinderWall{-domain.origin, core::Vec3::UnitX(), grid.pipe->diameter / 2}, "wall");
    for (int axis = 0; axis < (grid.pipe ? 1 : 3); ++axis) {
        if (grid.is_periodic(axis)) continue;
        const std::string letter(axis_words[std::size_t(axis) + 1]);
        add(physics::PlaneWall{core::Vec3::Zero(), core::Vec3::Unit(axis)}, letter + "_low");
        add(physics::PlaneWall{domain.size, -core::Vec3::Unit(axis)}, letter + "_high");
    }
    return walls;
}

std::vector<std::string> boundary_names(const core::Topology& topology)
{
    std::set<std::string> names;
    for (const core::Boundary& boundary : topology.boundaries) names.insert(boundary.name);
    return {names.begin(), names.end()};
}

std::vector<std::string> wall_names(const core::Mesh& mesh) { return boundary_names(mesh.topology()); }

} // namespace io
