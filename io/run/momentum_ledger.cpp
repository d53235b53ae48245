// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/momentum_ledger.hpp"
#include "io/build/physics_builder.hpp"
#include "io/run/grain_momentum.hpp"
#include "io/run/open_momentum.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/momentum_budget.hpp"
#include <algorithm>
#include <numeric>
#include <utility>

namespace io {
namespace {

/// Places of the sums over cells: each but the last is the first of three.
enum CellSum : std::size_t {
    of_fluid,
    of_ledger = 3,
    of_gradients = 6,
    of_advection = 9,
    of_share = 12,
    of_given = 15,
    of_push = 18,
    of_friction = 21,
    of_through = 24,
    of_volume = 27,
    cell_sums = 28
};
/// Three neighbouring numbers.
core::Vec3 vector_at(std::span<const double> values, std::size_t first) { return {values[first], values[first + 1], values[first + 2]}; }

void add_vector(std::span<double> sum, std::size_t first, const core::Vec3& x)
{
    for (std::size_t a = 0; a < 3; ++a) sum[first + a] += x[int(a)];
}

} // namespace

std::span<const MomentumImpulses::Line> MomentumImpulses::outer_lines()
{
    using M = MomentumImpulses;
    static constexpr std::array<Line, 10> lines{{{"drive", &M::drive},
                                                 {"weight", &M::weight},
                                                 {"wall_contact", &M::contact},
                                                 {"wall_pressure", &M::wall_pressure},
                                                 {"wall_friction", &M::wall_friction},
                                                 {"traffic", &M::traffic},
                                                 {"through", &M::through},
                                                 {"advection_defect", &M::advection},
                                                 {"gradient_defect", &M::gradient},
                                                 {"viscous_share", &M::viscous_share}}};
    return lines;
}

core::Vec3 MomentumImpulses::outer() const
{
    core::Vec3 sum = core::Vec3::Zero();
    for (const Line& line : outer_lines()) sum += this->*line.impulse;
    return sum;
}

/// Integrals over all cells: totals always, the rest only after a step.
struct MomentumLedger::CellSums {
    std::array<double, cell_sums> values{};
    [[nodiscard]] core::Vec3 operator[](CellSum first) const { return vector_at(values, first); }
};

MomentumLedger::MomentumLedger(World& world) : world_(world), totals_(present())
{
    remember_clock();
    world.watch_traffic([this] { after_traffic(); });
}

MomentumTotals MomentumLedger::present() const
{
    const CellSums cells = sum_cells(false);
    const GrainMomentum grains = grain_momentum(world_, core::Vec3::Zero());
    return {cells[of_fluid], cells[of_ledger], grains.momentum, grains.owed};
}

void MomentumLedger::after_traffic()
{
    const core::Vec3 before = totals_.sum();
    totals_ = present();
    brought_ += totals_.sum() - before;
}

void MomentumLedger::remember_clock()
{
    time_ = world_.time();
    drive_ = world_.clock().drive;
    implicit_ = world_.clock().implicit_share();
}

/// What the cells did in the last step.
void MomentumLedger::sum_step(core::LocalBlock b, std::span<double> sum) const
{
    const auto& own = std::as_const(*world_.fluid()).fields();
    const auto& f = std::as_const(world_.coupling()->fields());
    const double rho = world_.fluid()->parameters().density, dt = world_.clock().dt;
    const auto volume = world_.mesh().geometry(b).volume.view();
    const auto phi = f.fraction.on(b), old_phi = f.fraction_before.on(b), response = f.response.on(b);
    const auto before = std::as_const(world_.fluid()->state()).velocity_before.on(b), after_all = f.advected.on(b),
               source = own.source.on(b);
    const auto velocity = std::as_const(world_.fluid()->state()).velocity.on(b);
    const auto advected = own.advected.on(b), miss = f.miss.on(b), change = f.change.on(b);
    const auto old_gradient = own.pressure_gradient.on(b), new_gradient = own.psi_gradient.on(b);
    const auto grains = f.sums.on(b);
    const auto solid = grains[physics::sum_solid];
    if (world_.fluid()->by_finite_volumes()) // what the ledger has of it
        add_vector(sum, of_advection, physics::volume_sum(world_.mesh().geometry(b), world_.coupling()->transport().owed.on(b)));
    for (int c = 0; c < 3; ++c) {
        const auto n = std::size_t(c);
        const auto at = [c](const auto& field) { return field.component(c); };
        sum[of_gradients + n] += physics::sum_cells([dt](double v, double g, double dg) { return v * dt * (-g - dg); }, volume,
                                                    at(old_gradient), at(new_gradient));
        sum[of_advection + n] += physics::sum_cells(
            [rho](double v, double p, double old_p, double ua, double q, double u) { return rho * v * (p * (ua - q) + (p - old_p) * u); },
            volume, phi, old_phi, at(advected), at(source), at(before));
        const double stress = !own.viscous.allocated()
                                  ? 0.0
                                  : physics::sum_cells([push = 0.5 * dt * rho](double v, double s, double old_a,
                                                                               double a) { return v * s * push * (old_a + a); },
                                                       volume, solid, at(own.viscous.on(b)), at(f.viscous.on(b)));
        sum[of_share + n] += stress - physics::sum_cells([rho](double v, double s, double uv, double u, double ua,
                                                               double q) { return v * s * rho * (uv - u - (ua - q)); },
                                                         volume, solid, at(after_all), at(before), at(advected), at(source));
        // Steps 4 and 5 of response.hpp, read from the fluid's side, and pressure and stress on the grains.
        sum[of_given + n] +=
            stress +
            physics::sum_cells([dt](double v, double s, double impulse, double added, double du0, double reaction, double du, double dg,
                                    double g) { return v * (impulse + added * du0 + reaction * du - dt * s * (g + dg)); },
                               volume, solid, grains[physics::sum_impulse + n], grains[physics::sum_added], at(miss),
                               grains[physics::sum_predictor], at(change), at(new_gradient), at(old_gradient));
        sum[of_given + n] += physics::sum_cells(
            [dt](double v, double flux, double reaction, double r, double dg) { return v * (dt * flux - reaction * r) * dg; }, volume,
            grains[physics::sum_projection + 1], grains[physics::sum_projection], response, at(new_gradient));
        sum[of_given + n] += physics::sum_cells(
            [](double v, double held, double u, double du, double r, double dg) { return v * held * (u - (du - r * dg)); }, volume,
            grains[physics::sum_held], at(velocity), at(change), response, at(new_gradient));
    }
}

/// What the walls did in the last step.
void MomentumLedger::sum_walls(core::LocalBlock b, std::span<double> sum) const
{
    const physics::FluidStep& fluid = *world_.fluid();
    const auto& geometry = world_.mesh().geometry(b);
    const auto& walls = fluid.walls()[std::size_t(b)];
    const double dt = world_.clock().dt, viscosity = fluid.parameters().density * fluid.parameters().viscosity;
    add_vector(sum, of_through, dt * fluid.parameters().density * momentum_through(world_, b));
    add_vector(sum, of_push, dt * physics::wall_push(geometry, walls, fluid.state().pressure.on(b), 1));
    if (!fluid.viscosity_system()) return;
    const physics::FaceFactors factors = fluid.fields().viscosity_ratio.on(b);
    const auto& old_walls = fluid.walls_before()[std::size_t(b)];
    const core::Vec3 old_time = physics::wall_friction(geometry, old_walls, fluid.state().velocity_before.on(b), factors);
    const core::Vec3 new_time = physics::wall_friction(geometry, walls, fluid.fields().predicted.on(b), factors);
    add_vector(sum, of_friction, dt * viscosity * ((1 - implicit_) * old_time + implicit_ * new_time));
}

MomentumLedger::CellSums MomentumLedger::sum_cells(bool with_step) const
{
    const core::Mesh& mesh = world_.mesh();
    const auto& f = std::as_const(world_.coupling()->fields());
    const double rho = world_.fluid()->parameters().density;
    std::vector<double> parts(cell_sums * std::size_t(mesh.blocks()), 0.0);
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const std::span sum(parts.data() + cell_sums * std::size_t(mesh.global(b)), std::size_t(cell_sums));
        const auto volume = mesh.geometry(b).volume.view();
        const auto phi = f.fraction.on(b);
        const auto u = std::as_const(world_.fluid()->state()).velocity.on(b), ledger = f.ledger.on(b);
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            const double v = volume(i, j, k), mass = rho * v * phi(i, j, k);
            sum[of_volume] += v * phi(i, j, k);
            for (int c = 0; c < 3; ++c) {
                sum[of_fluid + std::size_t(c)] += mass * u.component(c)(i, j, k);
                sum[of_ledger + std::size_t(c)] += v * ledger.component(c)(i, j, k);
            }
        });
        if (!with_step) continue;
        sum_step(b, sum);
        sum_walls(b, sum);
    }
    world_.ranks().sum(parts);
    CellSums total;
    for (std::size_t n = 0; n < parts.size(); ++n) total.values[n % cell_sums] += parts[n];
    return total;
}

void MomentumLedger::update()
{
    const auto& parameters = world_.fluid()->parameters();
    const double dt = world_.clock().dt;
    // Of a prescribed flow the step itself says what the drive was.
    const physics::DriveState& state = std::holds_alternative<physics::FlowDrive>(parameters.drive) ? world_.clock().drive : drive_;
    const core::Vec3 drive = physics::mean_acceleration(parameters.drive, state, time_, dt);
    const core::Vec3 told = physics::expected_acceleration(parameters.drive, state, time_, dt);
    const CellSums cells = sum_cells(true);
    const GrainMomentum grains = grain_momentum(world_, told);
    const MomentumTotals before = totals_;
    totals_ = {cells[of_fluid], cells[of_ledger], grains.momentum, grains.owed};
    change_ = totals_.sum() - before.sum() + brought_;
    impulses_.traffic = std::exchange(brought_, core::Vec3::Zero());
    impulses_.drive = parameters.density * dt * (cells.values[of_volume] + grains.volume) * drive;
    impulses_.weight = dt * grains.buoyant_mass * gravity_of(world_.scene());
    impulses_.contact = grains.contact;
    impulses_.wall_pressure = cells[of_push];
    impulses_.wall_friction = cells[of_friction];
    impulses_.through = cells[of_through];
    impulses_.advection = cells[of_advection] - impulses_.through;
    // What the drive gave beyond what grains were told stands among the gradients of the cells.
    impulses_.gradient = cells[of_gradients] - cells[of_push] - parameters.density * dt * world_.mesh().total_volume() * (drive - told);
    impulses_.viscous_share = cells[of_share];
    impulses_.given = cells[of_given];
    impulses_.taken = grains.taken - before.owed;
    impulses_.couple = grains.couple;
    remember_clock();
}

double MomentumLedger::defect(const core::Vec3& explained) const
{
    double largest = std::max(impulses_.given.norm(), totals_.sum().norm());
    for (const auto& line : MomentumImpulses::outer_lines()) largest = std::max(largest, (impulses_.*line.impulse).norm());
    return largest > 0 ? (change_ - explained).norm() / largest : 0.0;
}

double MomentumLedger::exchange_defect() const
{
    // What grains took is what contact and weight leave: where these balance, of a bed at rest, it is known to their round-off alone.
    double largest = 0;
    for (const auto line : {&MomentumImpulses::given, &MomentumImpulses::taken, &MomentumImpulses::contact, &MomentumImpulses::weight})
        largest = std::max(largest, (impulses_.*line).norm());
    return largest > 0 ? (impulses_.given - impulses_.taken).norm() / largest : 0.0;
}

} // namespace io
