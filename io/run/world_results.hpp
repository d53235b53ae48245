// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The result files of a world: fluid_*.hdf and particles_*.hdf, whichever the scene has.
#include "io/files/vtkhdf.hpp"
#include "io/run/grain_fields.hpp"
#include "io/run/world.hpp"

namespace io {

class WorldResults {
public:
    /// Writes the grid, if anything is known in its cells. Collective. @throws core::FileError on all ranks.
    WorldResults(const World& world, const std::string& directory);

    /// Fluid: velocity, pressure and, when coupled, the fluid fraction; what is measured of the grains in cells. Particles, by id: radius,
    /// velocity, spin, species, id. Collective. @throws core::FileError on all ranks.
    void write(World& world, std::int64_t number);

private:
    void write_particles(const World& world, ResultTime when);
    std::optional<FluidResults> cells_;
    std::optional<GrainFields> grain_fields_;
    std::optional<ParticleResults> particles_;
};

} // namespace io
