// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How many grains of which sizes a scene has: what its numbers of species together are.
#include "core/particles/particle_set.hpp"
#include "io/scene/scene.hpp"
#include <cstdint>
#include <limits>

namespace io {

/// Of the grains of a scene at its start; extremes are also of those that may come in, and beyond all bounds where there are none.
struct GrainCensus {
    std::int64_t count = 0;
    double cubes = 0;                                                       ///< of the diameters [m3]
    double volume = 0;                                                      ///< [m3]
    double mass = 0;                                                        ///< [kg]
    double smallest = std::numeric_limits<double>::infinity(), largest = 0; ///< diameters [m]
    double least_density = std::numeric_limits<double>::infinity();         ///< [kg/m3]
    int arriving = 0;                                                       ///< species that may come in
    double arriving_cubes = 0;                                              ///< sum of the mean cubes of their diameters [m3]

    /// Counts one more.
    void add(const core::Sphere& grain);
    /// Widens the extremes by a grain of this diameter [m] and density [kg/m3].
    void stretch(double diameter, double density);
    /// Diameter of the mean volume; where no grain is there at the start, of those that may come in [m].
    [[nodiscard]] double mean_diameter() const;
    /// Mass of a mean grain; where none is there at the start, of the mean volume and the least density [kg].
    [[nodiscard]] double mean_mass() const;
};

/// The diameters of all grains of a species, rising; a single entry where all are equal [m].
[[nodiscard]] std::vector<double> diameters_of(const Species& species);

/// Is there a diameter, or sizes that are a distribution? A species from a file need not have any.
[[nodiscard]] bool has_sizes(const Species& species);

/// Mean cube of the diameters, of a sample where there are very many [m3].
[[nodiscard]] double mean_cube(const Species& species);

/// The smallest and the largest diameter that a grain of the species may have [m].
[[nodiscard]] std::array<double, 2> size_range(const Species& species);

/// Without the grains of files. @throws core::ConfigError for sizes that make no distribution.
[[nodiscard]] GrainCensus census_of(const Scene& scene);

/// The realised sizes of each species that has a distribution: a line with ends, and diameters that 10, 50 and 90 % of the mass do not
/// exceed; empty if all species have one diameter.
[[nodiscard]] std::string size_report(const Scene& scene);

} // namespace io
