// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/durable.hpp"
#include "io/files/vtkhdf_file.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numeric>

namespace io {

namespace detail {

std::string write_result(const std::string& path, const core::Communicator& ranks, Series& series, double time,
                         const std::function<void(hdf5::File&)>& fill)
{
    const std::string temporary = path + ".part";
    hdf5::together(ranks, [&] {
        if (ranks.rank() == 0) make_empty_file(temporary);
    });
    hdf5::together(ranks, [&] {
        auto file = hdf5::File::create(temporary, ranks, hdf5::Format::compatible);
        const std::vector<std::int64_t> version{1, 0};
        file.set_attribute("VTKHDF", "Version", std::span<const std::int64_t>(version));
        file.set_attribute("VTKHDF", "Type", std::string("UnstructuredGrid"));
        file.set_attribute("meta", "time", time);
        file.set_attribute("meta", "program", std::string("isago " ISAGO_VERSION));
        fill(file);
        file.close();
    });
    hdf5::together(ranks, [&] {
        if (ranks.rank() != 0) return;
        rename_durably(temporary, path);
        series.add(std::filesystem::path(path).filename().string(), time);
    });
    return path;
}

} // namespace detail

ParticleResults::ParticleResults(const std::string& directory, const core::Communicator& ranks)
    : directory_(directory), ranks_(ranks), series_(directory + "/particles.hdf.series")
{
    hdf5::together(ranks_, [&] {
        if (ranks_.rank() == 0) make_directory(directory_);
    });
}

std::string ParticleResults::write(ResultTime when, const ParticleRows& particles)
{
    const std::string path = fmt::format("{}/particles_{:06}.hdf", directory_, when.number);
    return detail::write_result(path, ranks_, series_, when.time, [&](hdf5::File& file) {
        const std::int64_t count = std::int64_t(particles.positions.size()) / 3, total = particles.total;
        const auto rows = [&](int components) { return hdf5::Rows{total, components, {{particles.first, count}}}; };
        const auto put = [&](const auto& column, const std::string& group) {
            file.write(group + column.name, column.values, rows(column.components), hdf5::Packing::compressed);
        };
        const bool last = ranks_.rank() == ranks_.size() - 1;
        std::vector<std::int64_t> offsets(std::size_t(count + (last ? 1 : 0)));
        std::iota(offsets.begin(), offsets.end(), particles.first);
        const auto vertices = std::span<const std::int64_t>(offsets).first(std::size_t(count));
        const std::vector<std::uint8_t> types(std::size_t(count), detail::vtk_vertex);
        for (const char* name : {"NumberOfPoints", "NumberOfCells", "NumberOfConnectivityIds"})
            detail::write_from_root(file, ranks_, std::string("VTKHDF/") + name, std::vector<std::int64_t>{total});
        put(ParticleColumn<double>{"Points", 3, particles.positions}, "VTKHDF/");
        put(ParticleColumn<std::int64_t>{"Connectivity", 1, vertices}, "VTKHDF/");
        put(ParticleColumn<std::uint8_t>{"Types", 1, types}, "VTKHDF/");
        file.write("VTKHDF/Offsets", std::span<const std::int64_t>(offsets),
                   {total + 1, 1, {{particles.first, std::int64_t(offsets.size())}}});
        for (const auto& column : particles.numbers) put(column, "VTKHDF/PointData/");
        for (const auto& column : particles.integers) put(column, "VTKHDF/PointData/");
    });
}

} // namespace io
