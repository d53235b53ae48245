// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Particles on four ranks against the same particles on one.
// ctest: ranks=4 timeout=300
#include "core/base/error.hpp"
#include "tests/support/wall_faces.hpp"
#include <doctest/doctest.h>

using test::Vec3;

namespace {

const Vec3 pull(1, 0, -9.81); // drives all particles across the sides
const core::Domain box{Vec3::Zero(), Vec3(12 * 3.2e-3, 12 * 3.2e-3, 0.1), {true, true, false}};

using physics::ParticleParameters;

const ParticleParameters plain = test::material(1000, 0.6, 0.5);

/// Hertz' springs that also hold rolling and twist, attract each other, and whose energy is booked.
ParticleParameters holding()
{
    ParticleParameters p = plain;
    for (auto* contacts : {&p.pairs, &p.walls}) {
        contacts->front().model = physics::ContactModel::hertz;
        contacts->front().young_modulus = 2e6;
        contacts->front().shear_modulus = 5e5;
        contacts->front().rolling_friction = contacts->front().twisting_friction = 0.1;
        contacts->front().cohesion = 1e-3;
    }
    p.energy_budget = physics::Budget::kept;
    return p;
}

physics::ParticleDynamics scene(const ParticleParameters& parameters)
{
    return {box, parameters, {physics::PlaneWall{Vec3::Zero(), Vec3::UnitZ()}}, 1e-5};
}

/// Owner by columns of 8 mm, dealt to `used` ranks in turn, so that ranks meet themselves and others on all sides.
physics::OwnerOf columns(int used)
{
    return [used](const Vec3& x) { return int(std::floor(x[0] / 8e-3) + 3 * std::floor(x[1] / 8e-3) + 8) % used; };
}

/// 300 particles in a pipe of faces of radius 15 mm, periodic along x.
physics::ParticleDynamics pipe_scene(const ParticleParameters& parameters)
{
    const core::Domain domain{Vec3::Zero(), Vec3(32e-3, 32e-3, 32e-3), {true, false, false}};
    physics::ParticleDynamics dynamics(domain, parameters, {}, 1e-5);
    auto faces = test::pipe(15e-3, 52e-3, 48, 13); // 10 mm beyond both ends
    for (auto& vertex : faces.vertices) vertex += Vec3(-10e-3, 16e-3, 16e-3);
    dynamics.add_surface(physics::WallSurface(faces.vertices, faces.quads));
    return dynamics;
}

const auto box_spheres = test::loose_lattice(1600, 12, 12, Vec3::Zero(), 1.0);
const auto pipe_spheres = test::loose_lattice(300, 10, 5, Vec3(0, 8e-3, 6.4e-3), 1.0);

/// Position, velocity, spin and all columns of the particles by id.
std::map<std::int64_t, std::vector<double>> all_of(const core::ParticleSet& p)
{
    std::map<std::int64_t, std::vector<double>> all;
    for (const auto& [id, row] : test::state(p)) all[id].assign(row.begin(), row.end());
    for (int i = 0; i < p.owned; ++i)
        for (const auto& column : p.columns) all[p.id[std::size_t(i)]].push_back(column[std::size_t(i)]);
    return all;
}

/// Runs a scene with particles dealt out anyhow at first.
std::map<std::int64_t, std::vector<double>> run_ranks(physics::ParticleDynamics dynamics, const std::vector<core::Sphere>& spheres,
                                                      int used, int steps)
{
    const auto communicator = core::Communicator::world();
    for (const auto& s : spheres)
        if (s.id % communicator.size() == communicator.rank()) dynamics.particles.add(s);
    physics::ParticleStepper stepper(dynamics, columns(used), communicator.rank(), communicator.size());
    for (const int part : {steps / 3, steps - steps / 3})
        physics::settle(stepper, physics::DryMotion{pull}, part, core::SerialTeam{}, communicator);
    std::int64_t count[] = {dynamics.particles.owned};
    communicator.sum(count);
    CHECK(count[0] == std::int64_t(spheres.size()));
    return all_of(dynamics.particles);
}

} // namespace

TEST_CASE("2, 3 and 4 ranks give the bits of one, whatever contacts remember")
{
    const int steps = 3000; // particles fall, pile up, cross columns and periodic sides
    for (const auto& parameters : {plain, holding()}) {
        auto alone = scene(parameters);
        for (const auto& s : box_spheres) alone.particles.add(s);
        test::run(alone, pull, steps / 3);
        test::run(alone, pull, steps - steps / 3);
        const auto wanted = all_of(alone.particles);
        for (const int used : {2, 3, 4}) {
            const auto mine = run_ranks(scene(parameters), box_spheres, used, steps);
            for (const auto& [id, row] : mine) CHECK(wanted.at(id) == row);
        }
    }
}

TEST_CASE("a pipe of faces gives the same bits on 1, 2 and 4 ranks, whatever contacts remember")
{
    const int steps = 4000; // all fall on the pipe's lower half and roll across periodic and rank sides
    for (const auto& parameters : {plain, holding()}) {
        auto alone = pipe_scene(parameters);
        for (const auto& s : pipe_spheres) alone.particles.add(s);
        test::run(alone, pull, steps / 3);
        test::run(alone, pull, steps - steps / 3);
        for (const auto& [id, row] : test::state(alone.particles))
            CHECK(std::hypot(row[1] - 16e-3, row[2] - 16e-3) < 14.1e-3); // inside, but for the overlap
        const auto wanted = all_of(alone.particles);
        for (const int used : {2, 4})
            for (const auto& [id, row] : run_ranks(pipe_scene(parameters), pipe_spheres, used, steps)) CHECK(wanted.at(id) == row);
    }
}

TEST_CASE("all ranks stop alike when a particle is lost")
{
    const auto communicator = core::Communicator::world();
    auto dynamics = scene(plain);
    if (communicator.rank() == 0) dynamics.particles.add(test::sphere(0, Vec3(0.01, 0.01, 0.01), 1e-3));
    physics::ParticleStepper stepper(dynamics, columns(2), communicator.rank(), communicator.size());
    const Vec3 endless(0, 0, 1e300);
    CHECK_THROWS_AS(physics::settle(stepper, physics::DryMotion{endless}, 10, core::SerialTeam{}, communicator), core::NumericsError);
}
