// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/imported_blocks.hpp"
#include "core/base/error.hpp"
#include "core/grid/hexahedron.hpp"
#include "core/grid/topology.hpp"
#include "core/grid/touching_blocks.hpp"
#include "io/files/plot3d.hpp"
#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>

namespace io {

namespace {

using core::BlockId, core::ConfigError, core::Side, core::Vec3, core::Vertices;
using SideKey = std::pair<BlockId, Side>;

[[nodiscard]] double volume_of(const Vertices& v)
{
    double volume = 0;
    core::for_each_cell(core::cells_of(v), [&](int i, int j, int k) { volume += core::cell_shape(v, {i, j, k}).volume; });
    return volume;
}

[[nodiscard]] Vertices turned(const Vertices& v)
{
    Vertices other = v;
    core::for_each_cell(v.extents(), [&](int i, int j, int k) { other(i, j, k) = v(i, j, v.extents().nk - 1 - k); });
    return other;
}

/// The same side counted along the other way of k.
[[nodiscard]] Side turned(Side side) { return side == Side::k_low ? Side::k_high : side == Side::k_high ? Side::k_low : side; }

/// "3.k_low" in the file's counting.
[[nodiscard]] SideKey side_of_text(const std::string& text, std::size_t blocks)
{
    int block = -1;
    const auto [dot, error] = std::from_chars(text.data(), text.data() + text.size(), block);
    const std::string word(dot == text.data() + text.size() ? dot : dot + 1, text.data() + text.size());
    const auto found = std::find(core::side_words.begin(), core::side_words.end(), word);
    core::require<ConfigError>(
        error == std::errc() && *dot == '.' && found != core::side_words.end(),
        fmt::format("'{}' is not a side: write the number of the block, a dot, and i_low, i_high, j_low, j_high, k_low "
                    "or k_high, such as 0.k_low",
                    text));
    core::require<ConfigError>(block >= 0 && block < int(blocks), fmt::format("'{}' names a block that the file does not have; it has {}, "
                                                                              "counted from 0",
                                                                              text, blocks));
    return {block, Side(found - core::side_words.begin())};
}

[[nodiscard]] std::map<SideKey, std::string> names_of(const ImportedGrid& grid, std::size_t blocks)
{
    std::map<SideKey, std::string> names;
    for (const NamedSides& boundary : grid.boundaries)
        for (const std::string& text : boundary.sides) {
            const auto [place, is_new] = names.emplace(side_of_text(text, blocks), boundary.name);
            core::require<ConfigError>(is_new, fmt::format("side {} is in boundary '{}' and in '{}'", text, place->second, boundary.name));
        }
    return names;
}

[[nodiscard]] std::string place_of(const core::MultiBlock& grid, BlockId block, Side side)
{
    const Vertices& v = grid.blocks[std::size_t(block)];
    const int axis = core::axis_of(side);
    core::Index3 low, high{v.extents().ni, v.extents().nj, v.extents().nk};
    low[axis] = core::is_high(side) ? high[axis] - 1 : 0;
    high[axis] = low[axis] + 1;
    Vec3 least = v(low.i, low.j, low.k), most = least;
    core::for_each(low, high, [&](int i, int j, int k) {
        least = least.cwiseMin(v(i, j, k));
        most = most.cwiseMax(v(i, j, k));
    });
    return fmt::format("within ({:.4g}, {:.4g}, {:.4g}) and ({:.4g}, {:.4g}, {:.4g}) m", least.x(), least.y(), least.z(), most.x(),
                       most.y(), most.z());
}

void add_periods(core::MultiBlock& grid, const std::optional<Vec3>& given, const std::array<bool, 3>& periodic)
{
    Vec3 low = grid.blocks[0].data()[0], high = low;
    for (const Vertices& v : grid.blocks)
        for (const Vec3& x : v.data()) {
            low = low.cwiseMin(x);
            high = high.cwiseMax(x);
        }
    const Vec3 length = given.value_or(high - low);
    for (int axis = 0; axis < 3; ++axis)
        if (periodic[std::size_t(axis)]) grid.periods.push_back(length[axis] * Vec3::Unit(axis));
}

/// "3.k_low", in the counting of the file.
[[nodiscard]] std::string file_side(BlockId block, Side side, const std::vector<bool>& is_turned)
{
    const Side of_file = is_turned[std::size_t(block)] ? turned(side) : side;
    return fmt::format("{}.{}", block, core::side_words[std::size_t(of_file)]);
}

/// @throws core::ConfigError with at most twenty of the findings.
void complain(const std::vector<std::string>& findings, const std::string& advice)
{
    constexpr std::size_t most_shown = 20;
    if (findings.empty()) return;
    std::string text;
    for (std::size_t n = 0; n < std::min(findings.size(), most_shown); ++n) text += (n > 0 ? "\n    " : "") + findings[n];
    if (findings.size() > most_shown) text += fmt::format("\n    and {} more", findings.size() - most_shown);
    throw ConfigError(fmt::format("{}\n    {}", text, advice));
}

/// Checks that exactly the sides that meet no other have names, or do so in part.
/// @param covered  The sides that others touch without matching points.
void check_names(core::MultiBlock grid, const std::vector<core::CoveredSide>& covered, const std::map<SideKey, std::string>& names,
                 const std::vector<bool>& is_turned, bool all_named)
{
    grid.boundary_name = [](BlockId, Side) { return std::string(); };
    const core::Topology topology = core::match_sides(grid);
    std::vector<std::string> wrong;
    for (BlockId b = 0; b < BlockId(grid.blocks.size()); ++b)
        for (const Side side : core::all_sides) {
            const std::string word = file_side(b, side, is_turned);
            const auto name = names.find({b, is_turned[std::size_t(b)] ? turned(side) : side});
            const auto& beyond = topology.neighbour(b, side);
            const auto touches = [&](const core::CoveredSide& c) { return c.block == b && c.side == side && c.wholly; };
            const bool is_covered = std::any_of(covered.begin(), covered.end(), touches);
            if (beyond && name != names.end())
                wrong.push_back(fmt::format("side {} is in boundary '{}', but meets block {}", word, name->second, beyond->block));
            else if (is_covered && name != names.end())
                wrong.push_back(fmt::format("side {} is in boundary '{}', but others lie on all of it", word, name->second));
            else if (!beyond && !is_covered && name == names.end() && !all_named)
                wrong.push_back(fmt::format("side {} meets no other and has no name: {}", word, place_of(grid, b, side)));
        }
    complain(wrong, "name sides in 'boundaries', or all that are left with 'other_sides'");
}

} // namespace

core::MultiBlock import_blocks(const ImportedGrid& grid, const std::array<bool, 3>& periodic, const std::optional<core::PeriodicTurn>& turn)
{
    Plot3d file = read_plot3d(grid.file);
    core::MultiBlock result;
    result.match_tolerance = grid.tolerance;
    std::vector<bool> is_turned;
    for (Vertices& block : file.blocks) {
        for (Vec3& x : block.data()) x *= grid.unit;
        is_turned.push_back(volume_of(block) < 0);
        result.blocks.push_back(is_turned.back() ? turned(block) : std::move(block));
    }
    add_periods(result, grid.period, periodic);
    result.turn = turn;
    const auto names = names_of(grid, result.blocks.size());
    const core::MultiBlock as_read = result;
    result.boundary_name = [names, is_turned, other = grid.other_sides.value_or("")](BlockId block, Side side) {
        const auto found = names.find({block, is_turned[std::size_t(block)] ? turned(side) : side});
        return found == names.end() ? other : found->second;
    };
    const auto covered = core::join_touching_blocks(result);
    check_names(as_read, covered, names, is_turned, grid.other_sides.has_value());
    return result;
}

} // namespace io
