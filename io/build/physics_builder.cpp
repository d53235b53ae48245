// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/physics_builder.hpp"
#include "io/build/contact_builder.hpp"
#include "io/scene/table_file.hpp"
#include "physics/fluid/flow_shape.hpp"
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace io {
namespace {

core::Vec3 unit_of(Axis axis) { return core::Vec3::Unit(axis == Axis::y ? 1 : axis == Axis::z ? 2 : 0); }

std::vector<physics::VelocityPoint> velocity_points(const std::string& file)
{
    std::vector<physics::VelocityPoint> points;
    for (const auto& row : read_table_file(file, 6)) points.push_back({{row[0], row[1], row[2]}, {row[3], row[4], row[5]}});
    return points;
}

physics::Drive drive_of(const Drive& drive, double density)
{
    using physics::FlowDrive;
    physics::TimeCourse course;
    if (drive.frequency) course = physics::HarmonicCourse{0, 1, 2 * std::numbers::pi * *drive.frequency, 0};
    if (drive.over_time) course = course_of(*drive.over_time);
    const core::Vec3 direction = unit_of(drive.axis);
    if (drive.flow_rate) return FlowDrive{direction, *drive.flow_rate, course};
    if (drive.bulk_velocity) return FlowDrive{direction, *drive.bulk_velocity, course, FlowDrive::Measure::bulk_velocity};
    const core::Vec3 acceleration = *drive.pressure_gradient / density * direction;
    if (drive.frequency || drive.over_time) return physics::VaryingDrive{acceleration, course};
    if (drive.reverse_at) return physics::ReversingDrive{acceleration, drive.reverse_at->axis_speed};
    return physics::ConstantDrive{acceleration};
}

physics::BoundaryCondition condition_of(const Boundary& boundary)
{
    physics::BoundaryCondition c{.kind = boundary.kind,
                                 .velocity = boundary.velocity.value_or(core::Vec3::Zero()),
                                 .laminar = boundary.profile == InflowProfile::laminar,
                                 .pressure = boundary.pressure.value_or(0.0)};
    if (!boundary.profile_file.empty()) c.profile = physics::interpolated_velocity(velocity_points(boundary.profile_file));
    if (boundary.spin) c.profile = [spin = *boundary.spin](const core::Vec3& x) { return spin.velocity(x); };
    if (boundary.over_time) c.course = course_of(*boundary.over_time);
    return c;
}

/// Speed that the turbulence of an inflow refers to: of points, the root of the mean square.
double inflow_speed(const Boundary& boundary)
{
    if (boundary.profile_file.empty()) return boundary.velocity.value_or(core::Vec3::Zero()).norm();
    const auto points = velocity_points(boundary.profile_file);
    double sum = 0;
    for (const auto& point : points) sum += point.velocity.squaredNorm();
    return std::sqrt(sum / double(points.size()));
}

} // namespace

physics::FluidParameters fluid_parameters(const Scene& scene)
{
    physics::FluidParameters p;
    p.density = scene.fluid->material.density;
    p.viscosity = scene.fluid->material.viscosity;
    for (const Boundary& boundary : scene.fluid->boundaries) p.boundaries[boundary.at] = condition_of(boundary);
    p.advection = scene.fluid->advection;
    if (scene.fluid->drive) p.drive = drive_of(*scene.fluid->drive, p.density);
    p.tolerances.pressure = scene.solver.tolerance;
    return p;
}

std::vector<physics::ScalarParameters> scalar_parameters(const Scene& scene)
{
    std::vector<physics::ScalarParameters> scalars;
    for (const Scalar& scalar : scene.fluid->scalars) {
        scalars.push_back({scalar.name, scalar.diffusivity, scalar.initial, {}});
        for (const ScalarEntry& entry : scalar.entering) scalars.back().entering[entry.at] = entry.value;
    }
    return scalars;
}

physics::TurbulenceParameters turbulence_parameters(const Scene& scene)
{
    const TurbulenceKeys& keys = *scene.fluid->turbulence;
    const core::Vec3 size = scene.grid.high() - scene.grid.low();
    double width = std::numeric_limits<double>::infinity(), fastest = 0;
    for (int axis = 0; axis < 3; ++axis)
        if (!scene.grid.is_periodic(axis)) width = std::min(width, size[axis]);
    const double length = keys.length.value_or(0.07 * std::min(width, size.maxCoeff()));
    physics::TurbulenceParameters p;
    p.roughness = keys.roughness;
    if (keys.model == TurbulenceModel::abe_kondoh_nagano) p.walls = physics::WallTreatment::resolved;
    for (const Boundary& boundary : scene.fluid->boundaries)
        if (boundary.kind == BoundaryKind::inflow) {
            const double speed = inflow_speed(boundary);
            p.entering[boundary.at] = physics::turbulence_of(speed, keys.intensity, length);
            fastest = std::max(fastest, speed);
        }
    p.initial = physics::turbulence_of(keys.speed.value_or(fastest), keys.intensity, length);
    return p;
}

physics::ParticleParameters particle_parameters(const Scene& scene)
{
    physics::ParticleParameters p;
    set_contacts(scene, p);
    p.energy_budget = scene.output.energy_budget;
    p.gravity = gravity_of(scene);
    p.seed = std::uint64_t(scene.run.random_seed);
    return p;
}

core::Vec3 gravity_of(const Scene& scene)
{
    return scene.gravity ? core::Vec3(scene.gravity->magnitude * scene.gravity->direction) : core::Vec3(core::Vec3::Zero());
}

} // namespace io
