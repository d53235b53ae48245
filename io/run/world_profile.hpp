// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// profile.csv: fraction, speed and kinds of the grains over height, each time that results are due.
#include "io/run/bed_layers.hpp"
#include "io/run/metrics.hpp"

namespace io {

class WorldProfile {
public:
    /// Begins the table, or goes on with it as metrics do. Collective. @pre gravity @throws core::FileError on all ranks.
    WorldProfile(const World& world, const std::filesystem::path& file, std::optional<double> restart_time);

    /// A row for each layer, from the lowest up to the last that grains reach: time [s], height of its middle [m], fraction of grains [-],
    /// their mean speed [m/s], fraction of each species [-]. Collective.
    void write(const World& world);
    /// Hands the rows to the system; to be called with every checkpoint.
    void flush();

private:
    BedLayering bed_;
    std::optional<MetricsWriter> writer_; ///< on rank 0
};

} // namespace io
