// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fluid and grains in a box, from a few numbers to steps: what every test of the coupling in space starts from.
#include "io/run/momentum_ledger.hpp"
#include "io/run/world.hpp"
#include <functional>
#include <memory>
#include <numbers>

namespace test {

using core::Vec3;

/// Grains of 2 mm in water unless told otherwise; no walls along the periodic axes.
struct CoupledBox {
    Vec3 size = {16e-3, 24e-3, 16e-3}; ///< [m]
    std::array<int, 3> cells{8, 12, 8}, blocks{1, 1, 1};
    std::vector<io::Axis> periodic;
    double diameter = 2e-3, density_ratio = 2.0, viscosity = 1e-6; ///< [m], -, kinematic [m2/s]
    Vec3 gravity = Vec3::Zero();
    double pressure_gradient = 0.0; ///< along x [Pa/m]
    double dt = 1e-3, stiffness = 1000.0, settle = 0.0, filter = 2.0, tolerance = 1e-8;
    io::CouplingMode mode = io::CouplingMode::pipelined;
    io::DragLaw drag = io::DragLaw::smooth;
    bool added_mass = true;
    io::Switch own_disturbance = io::Switch::off;
    std::string executor = "serial";
};

/// All ways to couple that a scene can ask for.
inline constexpr std::array every_mode{io::CouplingMode::pipelined, io::CouplingMode::coarse, io::CouplingMode::concurrent,
                                       io::CouplingMode::iterated};

/// A scene of the box with `count` grains, at random places.
[[nodiscard]] inline io::Scene scene_of(const CoupledBox& box, int count)
{
    io::Scene scene;
    scene.name = "box";
    scene.grid.box.emplace();
    scene.grid.box->size = box.size;
    scene.grid.box->cells = box.cells;
    scene.grid.box->blocks = box.blocks;
    scene.grid.periodic = box.periodic;
    scene.fluid.emplace();
    scene.fluid->material = {"water", 1000.0, box.viscosity};
    if (box.pressure_gradient != 0) scene.fluid->drive.emplace().pressure_gradient = box.pressure_gradient;
    if (box.gravity.norm() > 0) scene.gravity = io::Gravity{box.gravity.normalized(), box.gravity.norm()};
    io::Species species;
    species.name = "grains";
    species.count = count;
    species.diameter = box.diameter;
    species.density = 1000.0 * box.density_ratio;
    scene.particles.push_back(species);
    scene.contact.emplace();
    scene.contact->stiffness = box.stiffness;
    scene.contact->walls = io::WallShape::primitive;
    scene.coupling.emplace();
    scene.coupling->mode = box.mode;
    scene.coupling->filter = {box.filter, true};
    scene.coupling->drag = box.drag;
    scene.coupling->added_mass = box.added_mass ? io::AddedMass::on : io::AddedMass::off;
    scene.coupling->own_disturbance = box.own_disturbance;
    scene.coupling->lift = io::Switch::off;
    scene.run.until = 1e6;
    scene.run.settle = box.settle;
    scene.run.time_step = box.dt;
    scene.run.limits.cfl = 1e9;
    scene.solver.tolerance = box.tolerance;
    scene.resolve();
    return scene;
}

/// A world, ready to step; sums and extremes are those of this rank.
class CoupledRun {
public:
    explicit CoupledRun(const io::Scene& scene, const std::string& executor = "serial",
                        const core::Communicator& ranks = core::Communicator::world())
        : executor_kind_(executor), world_(scene, ranks)
    {
        world_.settle(core::SerialTeam());
    }
    CoupledRun(const CoupledBox& box, int count) : CoupledRun(scene_of(box, count), box.executor) {}

    /// Grains like the first at these places, instead of those of the scene; only before start().
    void place(const std::vector<Vec3>& places)
    {
        core::Sphere sphere;
        sphere.radius = grains().radius[0];
        sphere.density = grains().mass[0] / (4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius, 3));
        grains().resize_owned(0);
        world_.grains()->history.clear();
        for (const Vec3& place : places) {
            sphere.position = place;
            grains().add(sphere);
            world_.grains()->history.end_row();
            ++sphere.id;
        }
        world_.traffic()->restore(io::GrainTraffic(world_.scene(), world_.grains()->domain(), sphere.id).state());
    }
    /// Stops all grains: after settling, a last one may roll about for long.
    void stop_grains()
    {
        for (std::size_t a = 0; a < 3; ++a)
            for (auto* column : {&grains().velocity[a], &grains().spin[a]}) std::fill(column->begin(), column->end(), 0.0);
    }
    void start(const Vec3& fluid_velocity = Vec3::Zero(), const Vec3& grain_velocity = Vec3::Zero())
    {
        for (core::LocalBlock b = 0; b < world_.mesh().own_count(); ++b)
            core::for_each_cell(world_.mesh().geometry(b).cells, [&](int i, int j, int k) {
                for (int c = 0; c < 3; ++c)
                    for (auto* u : {&world_.fluid()->state().velocity, &world_.fluid()->state().velocity_before})
                        u->on(b).component(c)(i, j, k) = fluid_velocity[c];
            });
        if (grain_velocity.norm() > 0)
            for (std::size_t a = 0; a < 3; ++a)
                for (double& v : grains().velocity[a]) v = grain_velocity[int(a)];
        go_on();
    }
    /// After a state has been read.
    void go_on() { executor_ = tasks::make_executor({.kind = executor_kind_}, world_.compile()); }
    void step() { world_.step(*executor_); }

    [[nodiscard]] io::World& world() { return world_; }
    [[nodiscard]] core::ParticleSet& grains() { return world_.grains()->particles; }
    [[nodiscard]] Vec3 mean_grain_velocity()
    {
        Vec3 sum = Vec3::Zero();
        for (int g = 0; g < grains().owned; ++g) sum += grains().velocity_of(g);
        return sum / std::max(1, grains().owned);
    }
    /// Largest |u - expected| of all cells.
    [[nodiscard]] double fluid_deviation(const Vec3& expected = Vec3::Zero()) const
    {
        double largest = 0;
        for_cells([&](core::LocalBlock b, int i, int j, int k) {
            const auto u = world_.fluid()->state().velocity.on(b);
            largest = std::max(largest, (Vec3(u.x(i, j, k), u.y(i, j, k), u.z(i, j, k)) - expected).norm());
        });
        return largest;
    }
    /// Largest |v - expected| of all grains.
    [[nodiscard]] double grain_deviation(const Vec3& expected = Vec3::Zero())
    {
        double largest = 0;
        for (int g = 0; g < grains().owned; ++g) largest = std::max(largest, (grains().velocity_of(g) - expected).norm());
        return largest;
    }
    /// Largest |m (v - v before) / dt| over the buoyant weight of a grain.
    [[nodiscard]] double net_force_over_weight(double weight)
    {
        const auto& columns = world_.coupling()->exchange().columns();
        double largest = 0;
        for (int g = 0; g < grains().owned; ++g) {
            Vec3 before;
            for (int a = 0; a < 3; ++a) before[a] = grains().columns[std::size_t(columns.velocity_before + a)][std::size_t(g)];
            largest = std::max(largest, grains().mass[std::size_t(g)] * (grains().velocity_of(g) - before).norm() / world_.clock().dt);
        }
        return largest / weight;
    }
    /// Volume integral of a function of cells.
    [[nodiscard]] double integral(const std::function<double(core::LocalBlock, int, int, int)>& value) const
    {
        double sum = 0;
        for_cells([&](core::LocalBlock b, int i, int j, int k) { sum += world_.mesh().geometry(b).volume(i, j, k) * value(b, i, j, k); });
        return sum;
    }
    [[nodiscard]] double fluid_volume()
    {
        return integral([&](core::LocalBlock b, int i, int j, int k) { return world_.coupling()->fields().fraction.on(b)(i, j, k); });
    }
    [[nodiscard]] double solid_volume()
    {
        double sum = 0;
        for (int g = 0; g < grains().owned; ++g) sum += 4.0 / 3.0 * std::numbers::pi * std::pow(grains().radius[std::size_t(g)], 3);
        return sum;
    }

private:
    template <class Visit>
    void for_cells(Visit visit) const
    {
        for (core::LocalBlock b = 0; b < world_.mesh().own_count(); ++b)
            core::for_each_cell(world_.mesh().geometry(b).cells, [&](int i, int j, int k) { visit(b, i, j, k); });
    }

    std::string executor_kind_;
    io::World world_;
    std::unique_ptr<tasks::Executor> executor_;
};

} // namespace test
