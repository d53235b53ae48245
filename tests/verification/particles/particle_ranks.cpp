// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Particles on four ranks against the same particles on one.
// ctest: ranks=4 timeout=300
#include "tests/support/particle_scene.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

const core::Domain box{Vec3::Zero(), Vec3(12 * 3.2e-3, 12 * 3.2e-3, 0.1), {true, true, false}};

physics::ParticleDynamics scene()
{
    return {box, test::material(1000, 0.6, 0.5), {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}}, 1e-5};
}

/// Owner by columns of 8 mm, dealt to `used` ranks in turn, so that ranks meet themselves and others on all sides.
physics::OwnerOf columns(int used)
{
    return [used](const Vec3& x) { return int(std::floor(x[0] / 8e-3) + 3 * std::floor(x[1] / 8e-3) + 8) % used; };
}

/// Runs the scene with particles dealt out anyhow at first.
std::map<std::int64_t, std::array<double, 9>> run_ranks(int used, int steps)
{
    const auto communicator = core::Communicator::world();
    auto dynamics = scene();
    for (const auto& s : test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0))
        if (s.id % communicator.size() == communicator.rank()) dynamics.particles.add(s);
    physics::ParticleStepper stepper(dynamics, columns(used), communicator.rank(), communicator.size());
    for (const int part : {steps / 3, steps - steps / 3})
        physics::settle(stepper, physics::DryMotion{Vec3(0, 0, -9.81)}, part, core::SerialTeam{}, communicator);
    for (int i = 0; i < dynamics.particles.owned && used == communicator.size(); ++i)
        CHECK(dynamics.particles.position[2][std::size_t(i)] > 0.0);
    std::int64_t count[] = {dynamics.particles.owned};
    communicator.sum(count);
    CHECK(count[0] == 1600);
    return test::state(dynamics.particles);
}

} // namespace

TEST_CASE("2, 3 and 4 ranks give the bits of one")
{
    const int steps = 3000; // particles fall, pile up, cross columns and periodic sides
    auto alone = scene();
    for (const auto& s : test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0)) alone.particles.add(s);
    test::run(alone, Vec3(0, 0, -9.81), steps / 3);
    test::run(alone, Vec3(0, 0, -9.81), steps - steps / 3);
    const auto wanted = test::state(alone.particles);
    for (const int used : {2, 3, 4}) {
        const auto mine = run_ranks(used, steps);
        for (const auto& [id, row] : mine) CHECK(wanted.at(id) == row);
    }
}

TEST_CASE("all ranks stop alike when a particle is lost")
{
    const auto communicator = core::Communicator::world();
    auto dynamics = scene();
    if (communicator.rank() == 0) dynamics.particles.add(test::sphere(0, Vec3(0.01, 0.01, 0.01), 1e-3));
    physics::ParticleStepper stepper(dynamics, columns(2), communicator.rank(), communicator.size());
    const Vec3 endless(0, 0, 1e300);
    CHECK_THROWS_AS(physics::settle(stepper, physics::DryMotion{endless}, 10, core::SerialTeam{}, communicator), core::NumericsError);
}
