// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// From the contacts of a scene to the parameters of their laws.
#include "io/build/grain_census.hpp"
#include "io/scene/scene.hpp"
#include "physics/particles/parameters.hpp"

namespace io {

/// Contacts between all pairs of species, and of all species with all materials of walls; single entries where all are equal. @pre scene.contact
void set_contacts(const Scene& scene, physics::ParticleParameters& parameters);

/// The speed of impacts for which Hertz' springs get their time step: as the scene says, or the greatest of the speeds at which
/// particles start, of the fluid that is driven, flows in or is dragged by walls, and of a fall from end to end of the domain [m/s].
[[nodiscard]] double impact_speed(const Scene& scene);

/// Normal stiffness of contacts as a bed of the scene has them, tangential over normal stiffness [-].
struct BedContact {
    double stiffness =
        0.0; ///< The softest pair's; of Hertz' springs, under the weight of a mean particle or, without weight, in impacts [N/m].
    double tangential_ratio = 0.0;
};
[[nodiscard]] BedContact bed_contact(const Scene& scene, const GrainCensus& census, const physics::ParticleParameters& parameters);

} // namespace io
