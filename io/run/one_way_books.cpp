// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/one_way_books.hpp"
#include "io/build/physics_builder.hpp"

namespace io {

OneWayBooks::OneWayBooks(World& world) : world_(world), time_(world.time()), drive_(world.clock().drive)
{
    take_totals();
    world.watch_traffic([this] { take_totals(); });
}

void OneWayBooks::take_totals()
{
    const GrainMomentum grains = grain_momentum(world_, core::Vec3::Zero());
    lines_.momentum = grains.momentum;
    lines_.owed = grains.owed;
}

void OneWayBooks::update()
{
    const auto& fluid = world_.fluid()->parameters();
    const double dt = world_.clock().dt;
    // Of a prescribed flow the step itself says what the drive was.
    const physics::DriveState& state = std::holds_alternative<physics::FlowDrive>(fluid.drive) ? world_.clock().drive : drive_;
    const core::Vec3 drive = physics::expected_acceleration(fluid.drive, state, time_, dt), owed = lines_.owed;
    const GrainMomentum grains = grain_momentum(world_, drive);
    lines_ = {grains.momentum,
              grains.owed,
              fluid.density * grains.volume * dt * drive,
              dt * grains.buoyant_mass * gravity_of(world_.scene()),
              grains.contact,
              grains.taken - owed,
              grains.couple};
    time_ = world_.time();
    drive_ = world_.clock().drive;
}

} // namespace io
