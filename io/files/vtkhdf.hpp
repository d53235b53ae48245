// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Results for ParaView, VTK and h5py: VTKHDF 1.0 unstructured grids, which ParaView reads from version 5.11 on.
#include "io/files/block_nodes.hpp"
#include "io/files/field_views.hpp"
#include "io/files/hdf5.hpp"
#include "io/files/series.hpp"

namespace io {

/// The moment that a result file shows.
struct ResultTime {
    int number = 0;    ///< counts the files
    double time = 0.0; ///< [s]
};

/// Files fluid_<number>.hdf: the hexahedra of all blocks, one partition for each block, in the order of block ids. The
/// geometry is written once, in grid.h5, and linked. Group /meta has the extents of the blocks, (blocks, 3), for those who
/// want arrays (nk, nj, ni) back. All calls are collective; failures are core::FileError on all ranks.
class FluidResults {
public:
    /// @param nodes  Of this rank's blocks, in local order.
    FluidResults(const std::string& directory, const core::Communicator& ranks, BlockList blocks, const std::vector<BlockNodes>& nodes);
    /// @param fields  Scalars and vectors in cells.
    /// @return path of the file
    std::string write(ResultTime when, const std::vector<FieldViews<const double>>& fields);

private:
    void write_grid(const std::vector<BlockNodes>& nodes);
    void write_field(hdf5::File& file, const FieldViews<const double>& field) const;
    [[nodiscard]] hdf5::Rows rows_of(const std::vector<std::int64_t>& sizes, int components) const;

    std::string directory_;
    core::Communicator ranks_;
    BlockList blocks_;
    std::vector<core::LocalBlock> order_;
    std::vector<std::int64_t> extents_; ///< of every block, 3 each
    std::vector<std::int64_t> cells_;   ///< of every block
    Series series_;
};

/// A quantity of the particles: rows of `components` numbers, in the order of the positions.
template <class T>
struct ParticleColumn {
    std::string name;
    int components = 1;
    std::span<const T> values;
};

/// This rank's part of all particles in their global order, as RowOrder gives it.
struct ParticleRows {
    std::span<const double> positions; ///< 3 for each particle [m]
    std::vector<ParticleColumn<double>> numbers;
    std::vector<ParticleColumn<std::int64_t>> integers;
    std::int64_t first = 0, total = 0;
};

/// Files particles_<number>.hdf: one vertex for each particle, with whatever columns are given as point data.
class ParticleResults {
public:
    ParticleResults(const std::string& directory, const core::Communicator& ranks);
    std::string write(ResultTime when, const ParticleRows& particles);

private:
    std::string directory_;
    core::Communicator ranks_;
    Series series_;
};

} // namespace io
