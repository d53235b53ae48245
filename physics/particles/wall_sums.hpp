// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the contacts of one chunk of particles with walls are summed.
#include "physics/particles/contact_measure.hpp"
#include "physics/particles/energy_budget.hpp"
#include "physics/particles/wall_load.hpp"

namespace physics {

struct WallSums {
    ForceSums& particles;
    WallLoads loads;    ///< Of the walls that are reported; moments about the points of their axes.
    EnergySums* energy; ///< Null where no budget is kept.
    WallShares* shares; ///< Null but in sub-steps whose contacts are measured.
};

} // namespace physics
