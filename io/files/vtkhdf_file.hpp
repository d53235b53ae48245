// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fluid and particle results have in common: a file that appears when it is complete.
#include "io/files/vtkhdf.hpp"
#include <functional>

namespace io::detail {

inline constexpr std::uint8_t vtk_vertex = 1, vtk_hexahedron = 12;

/// Makes <stem>_<number>.hdf with `fill`, under another name until it is complete, and adds it to the series. Collective.
/// @param fill  Called with the file, which has an empty VTKHDF group with its attributes.
std::string write_result(const std::string& path, const core::Communicator& ranks, Series& series, double time,
                         const std::function<void(hdf5::File&)>& fill);

/// A small dataset that rank 0 writes.
template <class T>
void write_from_root(hdf5::File& file, const core::Communicator& ranks, const std::string& name, const std::vector<T>& values,
                     int components = 1)
{
    hdf5::Rows rows{std::int64_t(values.size()) / components, components, {}};
    if (ranks.rank() != 0) return file.write(name, std::span<const T>(), rows);
    rows.mine = {{0, rows.total}};
    file.write(name, std::span<const T>(values), rows);
}

} // namespace io::detail
