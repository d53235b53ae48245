// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fields of finite-volume advection beside grains; other scenes never allocate them.
#include "core/grid/mesh.hpp"

namespace physics {

struct TransportFields {
    explicit TransportFields(const core::Mesh& mesh)
        : solid({"flux density of grains", "m/s", 1, false, true}, mesh.own_cells()),
          flux({"volume flux of the fluid itself", "m3/s", 0, false}, mesh.own_cells()),
          momentum{core::FaceField({"flux of momentum x", "m4/s2", 0, false}, mesh.own_cells()),
                   core::FaceField({"flux of momentum y", "m4/s2", 0, false}, mesh.own_cells()),
                   core::FaceField({"flux of momentum z", "m4/s2", 0, false}, mesh.own_cells())},
          share({"fluid fraction as carried", "1", 0, false}, mesh.own_cells()),
          velocity({"velocity as carried", "m/s", 1, false}, mesh.own_cells()),
          rest({"flux that fluid and grains disagree by", "m3/s", 0, false}, mesh.own_cells()),
          owed({"momentum that the carrying flux owes", "N s/m3", 0, false}, mesh.own_cells())
    {
    }

    core::VectorField solid;
    core::FaceField flux; ///< of the present state: it follows from that, so no checkpoint has it
    std::array<core::FaceField, 3> momentum;
    core::ScalarField share;    ///< phi~ = phi - dt sum F / V
    core::VectorField velocity; ///< u as F carries it
    core::FaceField rest;
    core::VectorField owed; ///< what of the ledger is the transport's
};

} // namespace physics
