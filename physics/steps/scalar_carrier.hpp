// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Carries scalars with the volume fluxes of a step, in as many explicit parts as they need to stay bounded.
#include "physics/fluid/bounded_transport.hpp"
#include "physics/fluid/scalars.hpp"
#include "physics/steps/unknown.hpp"
#include <span>

namespace physics {

/// One scalar on its way.
struct CarriedScalar {
    core::ScalarField* value;              ///< one halo layer
    std::span<const EntryValues> entering; ///< of each block of this rank
};

class ScalarCarrier {
public:
    /// Allocates. Collective.
    explicit ScalarCarrier(const SystemContext& context);

    struct Flow {
        const core::FaceField& flux; ///< of the carrying fluid over the step [m3/s]
        core::ScalarField& share;    ///< w, the part of each cell that it fills, carried along: the sum of w V q is kept [-]
        double dt;                   ///< [s]
    };
    tasks::Job carry(tasks::Lane& lane, Flow flow, std::span<const CarriedScalar> scalars);

    /// Of the last call.
    [[nodiscard]] int parts() const { return parts_; }

private:
    tasks::Job count_parts(tasks::Lane& lane, const Flow& flow);
    void begin_part(tasks::Lane& lane, const Flow& flow, double dt);
    tasks::Job carry(tasks::Lane& lane, const Flow& flow, double dt, const CarriedScalar& scalar);
    void predict(core::LocalBlock b, const Flow& flow, double dt, const CarriedScalar& scalar);
    void step_upwind(core::LocalBlock b, const Flow& flow, const CarriedScalar& scalar);
    [[nodiscard]] const core::BlockGeometry& geometry(core::LocalBlock b) const { return context_.mesh.geometry(b); }
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(context_.mesh.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    SystemContext context_;
    std::vector<FaceCentres> centres_;
    core::VectorField velocity_, gradient_;
    core::ScalarField half_, gain_, loss_, next_share_, capacity_, low_, net_;
    core::FaceField upwind_, added_;
    int parts_ = 0;
};

/// Values beyond boundaries: of what enters, or of the cell inside.
void set_entering(const BlockWalls& walls, const EntryValues& entering, core::View<double> value);

} // namespace physics
