// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// How long steps may be where turbulence is resolved down to the walls.
#include "io/run/initial_flow.hpp"
#include "io/run/world.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"

namespace {

/// Between plates, the first cells of 20 mm / 24.
io::Scene channel(const std::string& model)
{
    return test::scene_from_text(R"(name: channel
grid: { box: { size: [160 mm, 20 mm, 20 mm], cells: [2, 24, 1] }, periodic: [x, z] }
fluid:
  water: { density: 1000 kg/m3, viscosity: 1e-6 m2/s }
  drive: { pressure_gradient: 1 Pa/m }
  turbulence: { model: )" + model +
                                 R"(, speed: 1 m/s, intensity: 0.1 }
run: { until: 100 s }
)");
}

} // namespace

TEST_CASE("where turbulence is resolved to the walls, steps are a hundred viscous times there at most, and the plan says so")
{
    const auto limit = [](const std::string& model) {
        io::World world(channel(model), core::Communicator::self());
        world.compile();
        io::start_from(world, [](const core::Vec3&) { return core::Vec3(1, 0, 0); });
        const double dt = world.next_step();
        return std::pair(dt, world.step_limit());
    };
    const auto [resolved, ruled_by] = limit("abe-kondoh-nagano");
    CHECK(ruled_by == "turbulence at walls");
    CHECK(resolved == test::relative(100 * 20e-3 / 48).epsilon(1e-9)); // over the shear of the first cell
    const auto [modelled, other] = limit("k-epsilon");
    CHECK(other == "displacement");
    CHECK(modelled > resolved);
}
