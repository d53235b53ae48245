// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/files/durable.hpp"
#include "io/files/vtkhdf_file.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace io {
namespace {

constexpr const char* geometry[] = {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds", "Points", "Connectivity",
                                    "Offsets",        "Types"};

core::Extents nodes_of(core::Extents cells) { return {cells.ni + 1, cells.nj + 1, cells.nk + 1}; }

/// The eight corners of every cell, as numbers of the block's nodes, in VTK's order.
void add_hexahedra(core::Extents cells, std::vector<std::int64_t>& connectivity)
{
    const auto node = [&](int i, int j, int k) { return std::int64_t(node_number(cells, {i, j, k})); };
    core::for_each_cell(cells, [&](int i, int j, int k) {
        for (const int up : {0, 1})
            for (const auto n : {node(i, j, k + up), node(i + 1, j, k + up), node(i + 1, j + 1, k + up), node(i, j + 1, k + up)})
                connectivity.push_back(n);
    });
}

std::vector<std::int64_t> per_block(const std::vector<std::int64_t>& extents, const std::function<std::int64_t(core::Extents)>& size)
{
    std::vector<std::int64_t> sizes;
    for (std::size_t b = 0; b < extents.size(); b += 3) sizes.push_back(size({int(extents[b]), int(extents[b + 1]), int(extents[b + 2])}));
    return sizes;
}

} // namespace

FluidResults::FluidResults(const std::string& directory, const core::Communicator& ranks, BlockList blocks,
                           const std::vector<BlockNodes>& nodes)
    : directory_(directory),
      ranks_(ranks),
      blocks_(std::move(blocks)),
      order_(in_global_order(blocks_)),
      extents_(std::size_t(3 * blocks_.total), 0),
      series_(directory + "/fluid.hdf.series")
{
    for (std::size_t b = 0; b < nodes.size(); ++b)
        for (int axis = 0; axis < 3; ++axis) extents_[std::size_t(3 * blocks_.own[b] + axis)] = nodes[b].cells[axis];
    ranks_.sum(extents_);
    cells_ = per_block(extents_, [](core::Extents e) { return std::int64_t(e.size()); });
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() == 0) make_directory(directory_);
    });
    write_grid(nodes);
}

hdf5::Rows FluidResults::rows_of(const std::vector<std::int64_t>& sizes, int components) const
{
    hdf5::Rows rows{0, components, {}};
    std::vector<std::int64_t> first;
    for (const std::int64_t size : sizes) {
        first.push_back(rows.total);
        rows.total += size;
    }
    for (const core::LocalBlock b : order_) {
        const auto id = std::size_t(blocks_.own[std::size_t(b)]);
        rows.mine.push_back({first[id], sizes[id]});
    }
    return rows;
}

void FluidResults::write_grid(const std::vector<BlockNodes>& nodes)
{
    std::vector<double> points;
    std::vector<std::int64_t> connectivity, offsets;
    std::vector<std::uint8_t> types;
    for (const core::LocalBlock b : order_) {
        const BlockNodes& block = nodes[std::size_t(b)];
        const std::int64_t cells = block.cells.size();
        points.insert(points.end(), block.points.begin(), block.points.end());
        add_hexahedra(block.cells, connectivity);
        for (std::int64_t cell = 0; cell <= cells; ++cell) offsets.push_back(8 * cell);
        types.insert(types.end(), std::size_t(cells), detail::vtk_hexahedron);
    }
    const auto node_counts = per_block(extents_, [](core::Extents e) { return std::int64_t(nodes_of(e).size()); });
    const auto corner_counts = per_block(extents_, [](core::Extents e) { return std::int64_t(8 * e.size()); });
    const auto offset_counts = per_block(extents_, [](core::Extents e) { return std::int64_t(e.size() + 1); });
    const std::string path = directory_ + "/grid.h5", temporary = path + ".part";
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() == 0) make_empty_file(temporary);
    });
    hdf5::together(ranks_, [&] {
        using enum hdf5::Packing;
        auto file = hdf5::File::create(temporary, ranks_, hdf5::Format::compatible);
        detail::write_from_root(file, ranks_, "grid/NumberOfPoints", node_counts);
        detail::write_from_root(file, ranks_, "grid/NumberOfCells", cells_);
        detail::write_from_root(file, ranks_, "grid/NumberOfConnectivityIds", corner_counts);
        file.write("grid/Points", std::span<const double>(points), rows_of(node_counts, 3), compressed);
        file.write("grid/Connectivity", std::span<const std::int64_t>(connectivity), rows_of(corner_counts, 1), compressed);
        file.write("grid/Offsets", std::span<const std::int64_t>(offsets), rows_of(offset_counts, 1), compressed);
        file.write("grid/Types", std::span<const std::uint8_t>(types), rows_of(cells_, 1), compressed);
        file.close();
    });
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() == 0) rename_durably(temporary, path);
    });
}

void FluidResults::write_field(hdf5::File& file, const FieldViews<const double>& field) const
{
    std::vector<double> values;
    for (const core::LocalBlock b : order_) {
        const auto& arrays = field.blocks[std::size_t(b)];
        for (const auto& view : arrays)
            core::require<core::Error>(view.extents() == arrays.front().extents(),
                                       "field '" + field.name + "' lives on faces and cannot be drawn in cells");
        core::for_each_cell(arrays.front().extents(), [&](int i, int j, int k) {
            for (const auto& view : arrays) values.push_back(view(i, j, k));
        });
    }
    std::int64_t components = field.blocks.empty() ? 1 : std::int64_t(field.blocks.front().size());
    ranks_.max({&components, 1});
    file.write("VTKHDF/CellData/" + field.name, std::span<const double>(values), rows_of(cells_, int(components)),
               hdf5::Packing::compressed);
    file.set_attribute("meta", "unit of " + field.name, field.unit);
}

std::string FluidResults::write(ResultTime when, const std::vector<FieldViews<const double>>& fields)
{
    const std::string path = fmt::format("{}/fluid_{:06}.hdf", directory_, when.number);
    return detail::write_result(path, ranks_, series_, when.time, [&](hdf5::File& file) {
        for (const char* name : geometry) file.link(std::string("VTKHDF/") + name, "grid.h5", std::string("grid/") + name);
        detail::write_from_root(file, ranks_, "meta/extents", extents_, 3);
        for (const auto& field : fields) write_field(file, field);
    });
}

} // namespace io
