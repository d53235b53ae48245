// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Checks of the grid of a scene.
#include "core/base/error.hpp"
#include "io/build/grid_builder.hpp"
#include "io/scene/scene_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numbers>

namespace io {

namespace {

class GridChecker {
public:
    GridChecker(Grid& grid, Locations& locations, Problems& problems) : grid_(grid), locations_(locations), problems_(problems) {}

    void check()
    {
        if (grid_.pipe) check_pipe(*grid_.pipe);
        if (grid_.box) check_box(*grid_.box);
        if (grid_.bent_pipe) check_bent_pipe(*grid_.bent_pipe);
        check_periodic();
        if (grid_.turn) check_turn(*grid_.turn);
    }

    /// Makes the grid. What a generator or file complains of is a problem of the shape's key.
    void measure()
    {
        if (!grid_.is_made() || grid_.shape().empty() || !locations_.good("grid")) return;
        try {
            const GridMeasure all = measured(grid_);
            if (!grid_.is_primitive()) grid_.measure = all;
        } catch (const core::ConfigError& error) {
            complain(fmt::format("grid.{}", grid_.elliptic ? "elliptic" : grid_.shape()), error.what(), "");
            locations_.spoil("grid");
            return;
        }
        try {
            if (grid_.turn) require_turn_joins(grid_);
        } catch (const core::ConfigError& error) {
            complain("grid.turn", error.what(), "");
            locations_.spoil("grid");
        }
    }

private:
    void complain(const std::string& path, const std::string& message, const std::string& hint)
    {
        problems_.add(locations_.at(path), message, hint);
    }

    [[nodiscard]] bool all_good(const std::vector<std::string>& paths) const
    {
        return std::all_of(paths.begin(), paths.end(), [&](const auto& path) { return locations_.good(path); });
    }

    void check_across(const std::string& path, int across)
    {
        if (locations_.good(path) && across % 4 != 0)
            complain(path, fmt::format("{} cells across are not a multiple of 4", across),
                     fmt::format("write {} or {}", std::max(4, across / 4 * 4), across / 4 * 4 + 4));
    }

    void check_pipe(const PipeGrid& pipe)
    {
        const PipeCells cells = pipe.chosen_cells();
        if (pipe.cells && pipe.size) complain("grid.pipe.cells", "'cells' excludes 'size'", "keep one of the two");
        check_across("grid.pipe.cells.across", cells.across);
        if (all_good({"grid.pipe.blocks_along", "grid.pipe.cells.along", "grid.pipe.size"}) && cells.along % pipe.blocks_along != 0)
            complain("grid.pipe.blocks_along",
                     fmt::format("{} cells along the pipe do not divide into {} blocks", cells.along, pipe.blocks_along),
                     "choose a number of blocks that divides the cells");
    }

    void check_box(const BoxGrid& box)
    {
        if (!all_good({"grid.box.cells", "grid.box.blocks"})) return;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (box.cells[axis] % box.blocks[axis] != 0)
                complain(
                    "grid.box.blocks",
                    fmt::format("{} cells along {} do not divide into {} blocks", box.cells[axis], axis_words[axis + 1], box.blocks[axis]),
                    "choose numbers of blocks that divide the cells");
    }

    void check_bent_pipe(const BentPipeGrid& pipe)
    {
        const std::string path = "grid.bent_pipe";
        check_across(path + ".across", pipe.across);
        if (!locations_.given(path + ".pieces"))
            complain(path, "a bent pipe needs 'pieces'", "write straight pieces { length } and arcs { angle, radius, towards }");
        for (std::size_t n = 0; n < pipe.pieces.size(); ++n) {
            const PipePieceGrid& piece = pipe.pieces[n];
            const std::string here = fmt::format("{}.pieces.{}", path, n);
            if (piece.length.has_value() == piece.angle.has_value() && locations_.good(here))
                complain(here, "a piece is straight or an arc", "give either 'length' or 'angle'");
            if (piece.angle.has_value() != piece.radius.has_value() && locations_.good(here))
                complain(here, "an arc needs 'angle' and 'radius'", "give both or none");
        }
    }

    /// The axes along which the shape may repeat.
    [[nodiscard]] std::vector<Axis> possible_axes() const
    {
        if (grid_.pipe || grid_.annulus) return {Axis::axial, Axis::x};
        if (grid_.stepped_channel) return {Axis::x, Axis::z};
        return {Axis::x, Axis::y, Axis::z};
    }

    void check_turn(const TurnKeys& turn)
    {
        constexpr double parallel = 1e-9; // sine of an angle
        const double whole = 2 * std::numbers::pi;
        if (locations_.good("grid.turn.angle") && (turn.angle == 0 || std::abs(turn.angle) >= whole))
            complain("grid.turn.angle", "the angle of a turn lies between 0 and 360 degrees",
                     "write that of the sector that the grid fills");
        if (!all_good({"grid.turn", "grid.periodic"})) return;
        for (int axis = 0; axis < 3; ++axis)
            if (grid_.is_periodic(axis) && turn.axis.cross(core::Vec3::Unit(axis)).norm() > parallel)
                complain("grid.periodic",
                         fmt::format("the grid repeats along {}, across the axis of its turn", axis_words[std::size_t(axis) + 1]),
                         "keep only the axis that the turn is about");
    }

    void check_periodic()
    {
        if (!locations_.good("grid.periodic")) return;
        const std::vector<Axis> possible = possible_axes();
        for (const Axis axis : grid_.periodic) {
            if (std::find(possible.begin(), possible.end(), axis) != possible.end()) continue;
            if (grid_.pipe || grid_.annulus)
                complain("grid.periodic", fmt::format("a {} repeats only along its axis", grid_.shape()), "write [axial]");
            else if (axis == Axis::axial)
                complain("grid.periodic", fmt::format("a {} has no 'axial' direction", grid_.shape()), "write x, y or z");
            else if (grid_.stepped_channel) complain("grid.periodic", "a stepped_channel repeats only along x and z", "remove y");
        }
        if (grid_.bent_pipe && grid_.periodic.size() > 1)
            complain("grid.periodic", "a bent_pipe repeats from end to end, along one axis",
                     "keep the axis along which its ends are apart");
    }

    Grid& grid_;
    Locations& locations_;
    Problems& problems_;
};

} // namespace

void check_grid(Grid& grid, const std::filesystem::path& folder, Locations& locations, Problems& problems)
{
    if (grid.blocks && !grid.blocks->file.empty() && std::filesystem::path(grid.blocks->file).is_relative())
        grid.blocks->file = std::filesystem::absolute(folder / grid.blocks->file).lexically_normal().string();
    GridChecker checker(grid, locations, problems);
    const std::size_t before = problems.size();
    checker.check();
    if (problems.size() == before) checker.measure();
    else if (!grid.is_primitive()) locations.spoil("grid"); // what it fills is not known
}

} // namespace io
