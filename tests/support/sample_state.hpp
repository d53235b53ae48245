// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small state of blocks, particles and contacts spread over any number of ranks, to be written and read back.
#include "core/comm/communicator.hpp"
#include "io/files/block_nodes.hpp"
#include "io/files/checkpoint.hpp"
#include "io/files/row_order.hpp"
#include <cmath>
#include <filesystem>
#include <unistd.h>

namespace support {

/// A folder of its own under the system's temporary one, removed at the end.
class Folder {
public:
    explicit Folder(std::string path) : path_(std::move(path)) {}
    Folder() : Folder((std::filesystem::temp_directory_path() / ("isago_" + std::to_string(::getpid()))).string())
    {
        std::filesystem::create_directories(path_);
    }
    ~Folder()
    {
        std::error_code ignored;
        std::filesystem::remove_all(path_, ignored);
    }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] const std::string& path() const { return path_; }

private:
    std::string path_;
};

inline constexpr int block_total = 5;
inline constexpr std::int64_t particle_total = 9000; // more than two chunks of rows_per_hash

inline core::Extents cells_of(core::BlockId id) { return {3 + id, 4, 2 + id % 2}; }

/// Value of element (i, j, k) of array `a` of block `id`: a number with many bits.
inline double value_of(double salt, core::BlockId id, std::size_t a, core::Index3 c)
{
    return std::sin(salt + 1.7 * id + 0.3 * double(a) + 0.11 * c.i + 0.013 * c.j + 0.0017 * c.k);
}

struct State {
    io::BlockList blocks;
    core::ScalarField pressure;
    core::VectorField velocity;
    core::FaceField flux;
    std::vector<std::int64_t> ids;
    std::vector<double> position; // 3 for each particle

    explicit State(io::BlockList list)
        : blocks(std::move(list)),
          pressure({"pressure", "Pa", 1, true}, cells()),
          velocity({"velocity", "m/s", 2, true}, cells()),
          flux({"flux", "m3/s", 0, true}, cells())
    {
        pressure.allocate();
        velocity.allocate();
        flux.allocate();
    }

    [[nodiscard]] std::vector<core::Extents> cells() const
    {
        std::vector<core::Extents> sizes;
        for (const auto id : blocks.own) sizes.push_back(cells_of(id));
        return sizes;
    }

    void fill(double salt, int rank, int ranks)
    {
        fill(io::views(pressure), salt);
        fill(io::views(velocity), salt + 10);
        fill(io::views(flux), salt + 20);
        for (std::int64_t n = 0; n < particle_total; ++n) {
            const std::int64_t id = (n * 7919) % particle_total; // every id once, in a scattered order
            if ((id * 31) % ranks != rank) continue;
            ids.push_back(id);
            for (int c = 0; c < 3; ++c) position.push_back(std::cos(salt + double(id) + 0.1 * c));
        }
    }

    void fill(const io::FieldViews<double>& field, double salt) const
    {
        for (std::size_t b = 0; b < field.blocks.size(); ++b)
            for (std::size_t a = 0; a < field.blocks[b].size(); ++a)
                core::for_each_cell(field.blocks[b][a].extents(), [&](int i, int j, int k) {
                    field.blocks[b][a](i, j, k) = value_of(salt, blocks.own[b], a, {i, j, k});
                });
    }

    [[nodiscard]] io::RowOrder order(const core::Communicator& ranks) const
    {
        std::vector<io::RowKey> keys;
        for (const auto id : ids) keys.push_back({id, 0, 0});
        return {ranks, keys};
    }

    std::string write(const std::string& directory, std::int64_t step, const core::Communicator& ranks) const
    {
        io::CheckpointWriter writer(directory, step, ranks);
        writer.field(io::views(pressure), blocks);
        writer.field(io::views(velocity), blocks);
        writer.field(io::views(flux), blocks);
        const io::RowOrder rows = order(ranks);
        const auto sorted_ids = rows.apply(std::span(ids), 1);
        const auto sorted_position = rows.apply(std::span(position), 3);
        writer.rows("particles/id", std::span(sorted_ids), 1, rows.first_row(), rows.total_rows());
        writer.rows("particles/position", std::span(sorted_position), 3, rows.first_row(), rows.total_rows());
        writer.rows("contacts/history", std::span<const double>(), 3, 0, 0);
        writer.scalar("time", 0.125 * double(step));
        writer.note("scene", "00ff");
        return writer.finish();
    }

    [[nodiscard]] std::string digest(std::int64_t step, const core::Communicator& ranks) const
    {
        io::StateDigest digest(ranks);
        digest.field(io::views(pressure), blocks);
        digest.field(io::views(velocity), blocks);
        digest.field(io::views(flux), blocks);
        const io::RowOrder rows = order(ranks);
        const auto sorted_ids = rows.apply(std::span(ids), 1);
        const auto sorted_position = rows.apply(std::span(position), 3);
        digest.rows("particles/id", std::span<const std::int64_t>(sorted_ids), 1, rows.first_row(), rows.total_rows());
        digest.rows("particles/position", std::span<const double>(sorted_position), 3, rows.first_row(), rows.total_rows());
        digest.rows("contacts/history", std::span<const double>(), 3, 0, 0);
        digest.scalar("time", 0.125 * double(step));
        return digest.line();
    }

    void read(const std::string& path, const core::Communicator& ranks)
    {
        const io::CheckpointReader reader(path, ranks);
        reader.field(io::views(pressure), blocks);
        reader.field(io::views(velocity), blocks);
        reader.field(io::views(flux), blocks);
        const auto share = io::even_share(reader.row_count("particles/id"), ranks);
        ids = reader.rows<std::int64_t>("particles/id", share.first, share.count);
        position = reader.rows<double>("particles/position", share.first, share.count);
    }
};

/// The whole state on one rank.
inline State whole_state(double salt)
{
    State state({{3, 0, 4, 1, 2}, block_total});
    state.fill(salt, 0, 1);
    return state;
}

/// Blocks dealt out in descending order, so that no rank's blocks follow each other; particles by their ids.
inline State share_of_state(const core::Communicator& ranks)
{
    io::BlockList list{{}, block_total};
    for (int id = block_total - 1; id >= 0; --id)
        if (id % ranks.size() == ranks.rank()) list.own.push_back(id);
    return State(list);
}

/// Unit cubes as cells: block `id` starts at x = 10 id.
inline std::vector<io::BlockNodes> nodes_of(const State& state)
{
    std::vector<io::BlockNodes> nodes;
    for (const core::BlockId id : state.blocks.own) {
        const core::Extents cells = cells_of(id);
        auto& block = nodes.emplace_back(io::BlockNodes{cells, {}});
        core::for_each({0, 0, 0}, {cells.ni + 1, cells.nj + 1, cells.nk + 1}, [&](int i, int j, int k) {
            for (const int x : {10 * id + i, j, k}) block.points.push_back(x);
        });
    }
    return nodes;
}

} // namespace support
