// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/metric_groups.hpp"
#include "core/comm/reduce.hpp"
#include "io/files/exact_sums.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/face_flux.hpp"
#include <algorithm>
#include <cmath>
#include <numbers>

namespace io {
namespace {

using core::LocalBlock;

/// Sum over all cells of term(block, i, j, k) times the volume of the fluid in the cell.
template <class Term>
double fluid_integral(World& world, Term term)
{
    const core::Mesh& mesh = world.mesh();
    return core::sum_over_blocks(mesh, world.ranks(), [&](LocalBlock b) {
        const auto volume = mesh.geometry(b).volume.view();
        const auto phi = world.coupling() ? world.coupling()->fields().fraction.on(b) : core::View<double>();
        double sum = 0;
        core::for_each_cell(mesh.geometry(b).cells, [&](int i, int j, int k) {
            sum += volume(i, j, k) * (world.coupling() ? phi(i, j, k) : 1.0) * term(b, i, j, k);
        });
        return sum;
    });
}

core::Vec3 velocity_at(World& world, LocalBlock b, int i, int j, int k)
{
    const auto u = world.fluid()->state().velocity.on(b);
    return {u.x(i, j, k), u.y(i, j, k), u.z(i, j, k)};
}

double largest_speed(World& world)
{
    return std::sqrt(core::max_over_blocks(world.mesh(), world.ranks(), [&](LocalBlock b) {
        double largest = 0;
        core::for_each_cell(world.mesh().geometry(b).cells,
                            [&](int i, int j, int k) { largest = std::max(largest, velocity_at(world, b, i, j, k).squaredNorm()); });
        return largest;
    }));
}

/// Root mean square of the net outflow of the cells over that of the flux through them.
double divergence(World& world)
{
    using OfFlux = void (*)(core::FaceView<const double>, core::View<double>);
    const auto sum_of_squares = [&](OfFlux of_flux) {
        return core::sum_over_blocks(world.mesh(), world.ranks(), [&](LocalBlock b) {
            core::Array3<double> result(world.mesh().geometry(b).cells);
            of_flux(std::as_const(world.fluid()->state().flux).on(b), result.view());
            return physics::sum_cells([](double x) { return x * x; }, result.view());
        });
    };
    const double net = sum_of_squares(physics::net_outflow), through = sum_of_squares(physics::throughput);
    return through > 0 ? std::sqrt(net / through) : 0.0;
}

/// One column: value(i) of each owned particle that `wanted` says yes to.
template <class Wanted, class Value>
std::vector<double> column_of(const core::ParticleSet& particles, Wanted wanted, Value value)
{
    std::vector<double> column;
    for (int i = 0; i < particles.owned; ++i)
        if (wanted(i)) column.push_back(value(i));
    return column;
}

/// Mean and its standard error.
std::array<double, 2> mean_and_error(const core::Communicator& ranks, std::vector<double> values)
{
    const auto sums = exact_sums(ranks, {values, std::vector<double>(values.size(), 1.0)});
    const double count = sums[1], mean = count > 0 ? sums[0] / count : 0.0;
    for (double& x : values) x = (x - mean) * (x - mean);
    const double squares = exact_sums(ranks, {values})[0];
    return {mean, count > 1 ? std::sqrt(squares / (count - 1) / count) : 0.0};
}

double volume_of(double radius) { return 4.0 / 3.0 * std::numbers::pi * radius * radius * radius; }

} // namespace

MetricGroup step_metrics(World& world)
{
    std::vector<std::string> names{"time", "step", "dt"};
    if (world.grains()) names.emplace_back("sub_steps");
    return {names, [&world] {
                std::vector<double> values{world.time(), double(world.clock().step), world.clock().dt_before};
                if (world.grains()) values.push_back(world.sub_steps());
                return values;
            }};
}

MetricGroup fluid_metrics(World& world)
{
    return {{"fluid_kinetic_energy", "largest_speed", "divergence", "pressure_iterations"}, [&world] {
                const double energy = fluid_integral(world, [&](LocalBlock b, int i, int j, int k) {
                    return 0.5 * world.fluid()->parameters().density * velocity_at(world, b, i, j, k).squaredNorm();
                });
                const auto& report = world.fluid()->pressure_system().report();
                return std::vector<double>{energy, largest_speed(world), divergence(world), double(report.iterations)};
            }};
}

MetricGroup drive_metrics(World& world)
{
    std::vector<std::string> names{"axis_speed", "flow_rate"};
    const bool prescribed = world.fluid()->flow_control();
    if (prescribed) names.emplace_back("pressure_gradient");
    return {names, [&world, prescribed] {
                const core::Vec3 along = physics::drive_direction(world.fluid()->parameters().drive);
                const Grid& grid = world.scene().grid;
                const double flow =
                    fluid_integral(world, [&](LocalBlock b, int i, int j, int k) { return along.dot(velocity_at(world, b, i, j, k)); });
                std::vector<double> values{world.axis_speed(), flow / along.cwiseAbs().dot(grid.high() - grid.low())};
                const auto& fluid = world.fluid()->parameters();
                const auto& clock = world.clock();
                if (prescribed)
                    values.push_back(fluid.density * along.dot(physics::mean_acceleration(fluid.drive, clock.drive, clock.time, 0)));
                return values;
            }};
}

MetricGroup turbulence_metrics(World& world)
{
    return {{"turbulence_energy", "largest_eddy_viscosity"}, [&world] {
                const auto& k = std::as_const(*world.turbulence()).k();
                const auto& fluid = world.fluid()->parameters();
                const double energy =
                    fluid_integral(world, [&](LocalBlock b, int i, int j, int m) { return fluid.density * k.on(b)(i, j, m); });
                const double largest = core::max_over_blocks(world.mesh(), world.ranks(), [&](LocalBlock b) {
                    const auto eddy = world.turbulence()->eddy_viscosity(b);
                    double most = 0;
                    core::for_each_cell(eddy.extents(), [&](int i, int j, int m) { most = std::max(most, eddy(i, j, m)); });
                    return most;
                });
                return std::vector<double>{energy, largest / fluid.viscosity};
            }};
}

MetricGroup scalar_metrics(World& world)
{
    std::vector<std::string> names;
    for (const auto& scalar : world.scalars()->parameters())
        for (const char* what : {"amount_", "least_", "largest_"}) names.push_back(what + scalar.name);
    return {names, [&world] {
                const core::Mesh& mesh = world.mesh();
                const physics::ScalarSet& fields = std::as_const(*world.scalars()).fields();
                std::vector<double> values;
                for (const core::ScalarField& field : fields.values) {
                    values.push_back(core::sum_over_blocks(mesh, world.ranks(), [&](LocalBlock b) {
                        return physics::sum_cells([](double v, double w, double q) { return v * w * q; }, mesh.geometry(b).volume.view(),
                                                  fields.share.on(b), field.on(b));
                    }));
                    const auto most = [&](double sign) {
                        return sign * core::max_over_blocks(mesh, world.ranks(), [&](LocalBlock b) {
                                   double largest = -std::numeric_limits<double>::infinity();
                                   core::for_each_cell(field.on(b).extents(), [&](int i, int j, int k) {
                                       largest = std::max(largest, sign * field.on(b)(i, j, k));
                                   });
                                   return largest;
                               });
                    };
                    values.insert(values.end(), {most(-1), most(1)});
                }
                return values;
            }};
}

MetricGroup particle_metrics(World& world)
{
    return {{"particles", "particle_kinetic_energy"}, [&world] {
                const core::ParticleSet& p = world.grains()->particles;
                const auto every = [](int) { return true; };
                const auto energy = column_of(p, every, [&](int i) {
                    const auto n = std::size_t(i);
                    return 0.5 * (p.mass[n] * p.velocity_of(i).squaredNorm() + p.inertia[n] * p.spin_of(i).squaredNorm());
                });
                return exact_sums(world.ranks(), {std::vector<double>(energy.size(), 1.0), energy});
            }};
}

MetricGroup traffic_metrics(World& world)
{
    std::vector<std::string> names;
    for (const std::string& name : world.traffic()->inflow_names()) names.push_back("entered_" + name);
    for (const std::string& name : world.traffic()->outlet_names())
        for (const char* what : {"taken_away_", "mass_taken_away_"}) names.push_back(what + name);
    return {names, [&world] {
                std::vector<double> values;
                for (const physics::Entered& entered : world.traffic()->entered()) values.push_back(double(entered.count));
                for (const TakenAway& taken : world.traffic()->taken_away()) values.insert(values.end(), {double(taken.count), taken.mass});
                return values;
            }};
}

MetricGroup height_metrics(World& world)
{
    std::vector<std::string> names;
    for (const Species& species : world.scene().particles)
        for (const char* what : {"mean_height_", "mean_height_error_"}) names.push_back(what + species.name);
    names.insert(names.end(), {"lowest", "highest"});
    return {names, [&world] {
                const core::ParticleSet& p = world.grains()->particles;
                const core::Vec3 up = -world.scene().gravity->direction.normalized(), origin = world.grains()->domain().origin;
                const auto height = [&](int i) { return up.dot(origin + p.position_of(i)); };
                std::vector<double> values;
                for (int s = 0; s < int(world.scene().particles.size()); ++s) {
                    const auto mine = [&](int i) { return p.species[std::size_t(i)] == s; };
                    const auto both = mean_and_error(world.ranks(), column_of(p, mine, height));
                    values.insert(values.end(), both.begin(), both.end());
                }
                std::array<double, 2> ends;
                ends.fill(std::numeric_limits<double>::lowest());
                for (int i = 0; i < p.owned; ++i) ends = {std::max(ends[0], -height(i)), std::max(ends[1], height(i))};
                world.ranks().max(ends);
                values.insert(values.end(), {-ends[0], ends[1]});
                return values;
            }};
}

MetricGroup solid_metrics(World& world)
{
    return {{"solid_volume", "solid_volume_defect", "largest_solid_fraction"}, [&world] {
                const core::Mesh& mesh = world.mesh();
                const auto& fraction = std::as_const(world.coupling()->fields().fraction);
                const double cells = core::sum_over_blocks(mesh, world.ranks(), [&](LocalBlock b) {
                    return physics::sum_cells([](double v, double phi) { return v * (1.0 - phi); }, mesh.geometry(b).volume.view(),
                                              fraction.on(b));
                });
                const double largest = core::max_over_blocks(mesh, world.ranks(), [&](LocalBlock b) {
                    const auto phi = fraction.on(b);
                    double most = 0;
                    core::for_each_cell(phi.extents(), [&](int i, int j, int k) { most = std::max(most, 1.0 - phi(i, j, k)); });
                    return most;
                });
                const core::ParticleSet& p = world.grains()->particles;
                const auto volumes = column_of(
                    p, [](int) { return true; }, [&](int i) { return volume_of(p.radius[std::size_t(i)]); });
                const double grains = exact_sums(world.ranks(), {volumes})[0];
                return std::vector<double>{cells, grains > 0 ? cells / grains - 1.0 : 0.0, largest};
            }};
}

MetricGroup one_way_metrics(const OneWayBooks& books)
{
    using L = OneWayBooks::Lines;
    static constexpr std::array<std::pair<const char*, core::Vec3 L::*>, 7> lines{{{"particle_momentum", &L::momentum},
                                                                                   {"owed_momentum", &L::owed},
                                                                                   {"impulse_drive", &L::drive},
                                                                                   {"impulse_weight", &L::weight},
                                                                                   {"impulse_wall_contact", &L::contact},
                                                                                   {"impulse_exchange", &L::exchange},
                                                                                   {"angular_impulse_couple", &L::couple}}};
    std::vector<std::string> names;
    for (const auto& [name, line] : lines)
        for (const char* axis : {"_x", "_y", "_z"}) names.push_back(std::string(name) + axis);
    return {names, [&books] {
                std::vector<double> values;
                for (const auto& [name, line] : lines)
                    for (int a = 0; a < 3; ++a) values.push_back((books.lines().*line)[a]);
                return values;
            }};
}

MetricGroup momentum_metrics(const MomentumLedger& ledger)
{
    std::vector<std::string> names;
    const auto name = [&](const std::string& what) {
        for (const char* axis : {"_x", "_y", "_z"}) names.push_back(what + axis);
    };
    for (const char* what : {"momentum", "fluid_momentum", "particle_momentum", "owed_momentum"}) name(what);
    for (const auto& line : MomentumImpulses::outer_lines()) name(std::string("impulse_") + line.name);
    for (const char* what : {"impulse_exchange", "angular_impulse_couple"}) name(what);
    names.insert(names.end(), {"momentum_defect", "exchange_defect"});
    return {names, [&ledger] {
                std::vector<double> values;
                const auto put = [&](const core::Vec3& x) { values.insert(values.end(), {x.x(), x.y(), x.z()}); };
                const MomentumTotals& totals = ledger.totals();
                for (const core::Vec3& x : {totals.sum(), totals.fluid, totals.grains, core::Vec3(totals.owed + totals.ledger)}) put(x);
                for (const auto& line : MomentumImpulses::outer_lines()) put(ledger.impulses().*line.impulse);
                put(ledger.impulses().given);
                put(ledger.impulses().couple);
                values.insert(values.end(), {ledger.defect(), ledger.exchange_defect()});
                return values;
            }};
}

} // namespace io
