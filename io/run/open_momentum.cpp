// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/open_momentum.hpp"
#include "physics/fluid/momentum_budget.hpp"
#include <utility>

namespace io {

core::Vec3 momentum_through(World& world, core::LocalBlock b)
{
    const physics::FluidStep& fluid = *world.fluid();
    const physics::FlowBoundaries at = fluid.flow_boundaries(b);
    if (!fluid.by_finite_volumes())
        return physics::through_flow(at.geometry, at.after, fluid.state().flux.on(b), fluid.state().velocity_before.on(b));
    const physics::TransportFields& t = std::as_const(*world.coupling()).transport();
    core::Vec3 twice = core::Vec3::Zero();
    for (const physics::BlockWalls* walls : {&at.before, &at.after})
        twice += physics::through_flow(at.geometry, *walls, fluid.fields().middle_flux.on(b), fluid.fields().middle.on(b)) +
                 physics::through_flow(at.geometry, *walls, t.rest.on(b), t.velocity.on(b));
    return 0.5 * twice;
}

} // namespace io
