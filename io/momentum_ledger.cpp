// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/momentum_ledger.hpp"
#include "io/exact_sums.hpp"
#include "io/physics_builder.hpp"
#include <algorithm>
#include <numbers>
#include <numeric>

namespace io {
namespace {

constexpr std::size_t cell_sums = 16, grain_sums = 20;

/// Three neighbouring numbers.
core::Vec3 vector_at(std::span<const double> values, std::size_t first) { return {values[first], values[first + 1], values[first + 2]}; }

core::Vec3 columns_at(const core::ParticleSet& grains, int first, std::size_t i)
{
    const auto value = [&](int a) { return grains.columns[std::size_t(first + a)][i]; };
    return {value(0), value(1), value(2)};
}

} // namespace

/// Integrals over all cells: totals always, the rest only after a step.
struct MomentumLedger::CellSums {
    core::Vec3 fluid, ledger, wall_pressure, friction, given;
    double volume; ///< of the fluid [m3]
};

struct MomentumLedger::GrainSums {
    core::Vec3 momentum, owed, contact, taken;
    core::Vec3 known;     ///< impulse of lift and of what was delivered
    core::Vec3 delivered; ///< of what was owed before the step
    double heavy, volume; ///< sum of m - rho V [kg], sum of V [m3]
};

MomentumLedger::MomentumLedger(World& world) : world_(world)
{
    const CellSums cells = sum_cells(false);
    const GrainSums grains = sum_grains(core::Vec3::Zero());
    totals_ = {cells.fluid, cells.ledger, grains.momentum, grains.owed};
    remember_clock();
}

void MomentumLedger::remember_clock()
{
    time_ = world_.time();
    drive_ = world_.clock().drive;
}

MomentumLedger::CellSums MomentumLedger::sum_cells(bool with_step) const
{
    const core::Mesh& mesh = world_.mesh();
    const auto& state = world_.fluid()->state();
    const auto& own = world_.fluid()->fields();
    const auto& f = std::as_const(world_.coupling()->fields());
    const double rho = world_.fluid()->parameters().density, dt = state.clock.dt;
    std::vector<double> parts(cell_sums * std::size_t(mesh.blocks()), 0.0);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const std::span sum(parts.data() + cell_sums * std::size_t(mesh.global(b)), cell_sums);
        const auto volume = mesh.geometry(b).volume.view();
        const auto phi = f.fraction.on(b);
        const auto u = state.velocity.on(b), ledger = f.ledger.on(b);
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const double v = volume(i, j, k), mass = rho * v * phi(i, j, k);
            sum[15] += v * phi(i, j, k);
            for (int c = 0; c < 3; ++c) {
                sum[std::size_t(c)] += mass * u.component(c)(i, j, k);
                sum[3 + std::size_t(c)] += v * ledger.component(c)(i, j, k);
            }
        });
        if (!with_step) continue;
        const auto before = state.velocity_before.on(b), advected = f.advected.on(b), miss = f.miss.on(b), change = f.change.on(b);
        const auto old_gradient = own.pressure_gradient.on(b), new_gradient = own.psi_gradient.on(b);
        const auto old_phi = f.fraction_before.on(b), response = f.response.on(b);
        const auto grains = f.sums.on(b);
        const bool viscous = own.viscous.allocated();
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const double v = volume(i, j, k);
            const auto mass_of = [&](double fraction) { return rho * v * fraction; };
            const physics::GrainResponse p = physics::predictor_sums(grains, i, j, k), q = physics::projection_sums(grains, i, j, k);
            for (int c = 0; c < 3; ++c) {
                const auto n = std::size_t(c);
                const auto at = [&](const auto& field) { return field.component(c)(i, j, k); };
                const double force_change = -at(new_gradient), force = -at(old_gradient) + force_change;
                const double stress = viscous ? rho * at(own.viscous.on(b)) : 0.0;
                sum[6 + n] += v * dt * force;
                sum[9 + n] += mass_of(phi(i, j, k)) * at(advected) - mass_of(old_phi(i, j, k)) * at(before) +
                              v * dt * grains[physics::sum_solid](i, j, k) * stress;
                // Steps 4 and 5 of response.hpp, read from the fluid's side, and the pressure on the grains.
                sum[12 + n] += v * (grains[physics::sum_impulse + n](i, j, k) + p.added * at(miss) + p.reaction * at(change) -
                                    dt * q.flux * force_change + q.reaction * response(i, j, k) * force_change +
                                    dt * grains[physics::sum_solid](i, j, k) * (force + stress));
            }
        });
    }
    world_.ranks().sum(parts);
    std::array<double, cell_sums> s{};
    for (std::size_t n = 0; n < parts.size(); ++n) s[n % cell_sums] += parts[n];
    return {vector_at(s, 0), vector_at(s, 3), vector_at(s, 6), vector_at(s, 9), vector_at(s, 12), s[15]};
}

MomentumLedger::GrainSums MomentumLedger::sum_grains(const core::Vec3& drive) const
{
    const core::ParticleSet& grains = world_.grains()->particles;
    const physics::GrainExchange& exchange = world_.coupling()->exchange();
    const double rho = world_.fluid()->parameters().density, dt = world_.clock().dt;
    const core::Vec3 gravity = gravity_of(world_.scene());
    std::vector<std::vector<double>> columns(grain_sums);
    const auto put = [&](std::size_t first, const core::Vec3& x) {
        for (std::size_t a = 0; a < 3; ++a) columns[first + a].push_back(x[int(a)]);
    };
    for (std::size_t i = 0; i < std::size_t(grains.owned); ++i) {
        const double mass = grains.mass[i], radius = grains.radius[i];
        const double volume = 4.0 / 3.0 * std::numbers::pi * radius * radius * radius;
        const core::Vec3 velocity = grains.velocity_of(int(i)), owed = columns_at(grains, exchange.columns().owed, i);
        const core::Vec3 contact = columns_at(grains, exchange.wet_columns().impulse, i);
        const core::Vec3 known = dt * columns_at(grains, exchange.columns().known_force, i);
        const core::Vec3 pressure = dt * volume * columns_at(grains, exchange.columns().force_used, i);
        put(0, mass * velocity);
        put(3, owed);
        put(6, contact);
        put(9, mass * (velocity - columns_at(grains, exchange.columns().velocity_before, i)) - known - contact + pressure + owed);
        put(12, known - pressure - dt * (mass - rho * volume) * gravity - dt * rho * volume * drive);
        put(15, columns_at(grains, exchange.columns().delivered, i));
        columns[18].push_back(mass - rho * volume);
        columns[19].push_back(volume);
    }
    const auto s = exact_sums(world_.ranks(), columns);
    return {vector_at(s, 0), vector_at(s, 3), vector_at(s, 6), vector_at(s, 9), vector_at(s, 12), vector_at(s, 15), s[18], s[19]};
}

void MomentumLedger::update()
{
    const auto& parameters = world_.fluid()->parameters();
    const double dt = world_.clock().dt;
    const core::Vec3 drive = physics::mean_acceleration(parameters.drive, drive_, time_, dt);
    const CellSums cells = sum_cells(true);
    const GrainSums grains = sum_grains(drive);
    const MomentumTotals before = totals_;
    totals_ = {cells.fluid, cells.ledger, grains.momentum, grains.owed};
    impulses_.drive = parameters.density * dt * (cells.volume + grains.volume) * drive;
    impulses_.weight = dt * grains.heavy * gravity_of(world_.scene());
    impulses_.contact = grains.contact;
    impulses_.wall_pressure = cells.wall_pressure;
    impulses_.friction = cells.friction;
    impulses_.lift = grains.known - grains.delivered;
    impulses_.given = cells.given;
    impulses_.taken = grains.taken - (before.owed - grains.delivered);
    double largest = std::max(impulses_.given.norm(), totals_.sum().norm());
    for (const core::Vec3& x : {impulses_.drive, impulses_.weight, impulses_.contact, impulses_.wall_pressure, impulses_.friction})
        largest = std::max(largest, x.norm());
    const core::Vec3 unexplained = totals_.sum() - before.sum() - impulses_.outer();
    defect_ = largest > 0 ? unexplained.norm() / largest : 0.0;
    remember_clock();
}

double MomentumLedger::exchange_defect() const
{
    const double larger = std::max(impulses_.given.norm(), impulses_.taken.norm());
    return larger > 0 ? (impulses_.given - impulses_.taken).norm() / larger : 0.0;
}

} // namespace io
