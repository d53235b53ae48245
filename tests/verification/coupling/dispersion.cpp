// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Grains that turbulence spreads (NUMERICS B10): as far as theory has it where turbulence decays everywhere alike; what is well mixed in a
// channel stays so; and momentum is kept.
// ctest: timeout=300
#include "tests/support/coupled_run.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <doctest/doctest.h>

using namespace test;

namespace {

/// Still water that is stirred, in a box 0.2 m wide, and grains that follow it within milliseconds and hardly meet.
io::World stirred(const std::string& periodic, int count)
{
    return {scene_from_text("name: stirred water\n"
                            "grid: { box: { size: [0.2 m, 0.2 m, 0.2 m], cells: [4, 16, 4], blocks: [1, 2, 1] }, periodic: " +
                            periodic +
                            " }\n"
                            "fluid: { water: { density: 1000 kg/m3, viscosity: 3e-5 m2/s },\n"
                            "  turbulence: { model: k-epsilon, speed: 1 m/s, intensity: 0.1, length: 20 mm } }\n"
                            "particles: [{ name: tracers, count: " +
                            std::to_string(count) +
                            ", diameter: 1 mm, density: 1000 kg/m3 }]\n"
                            "contact: { law: linear, stiffness: 0.1 N/m, walls: primitive }\n"
                            "coupling: { feedback: one_way, lift: off }\n"
                            "run: { until: 100 s, time_step: 20 ms, limits: { cfl: 1000, particle_move: 1000 } }\n"),
            core::Communicator::self()};
}

/// Which way each tracer has gone, in domains that repeat.
class Ways {
public:
    Ways(const core::ParticleSet& grains, double period)
        : period_(period), last_(std::size_t(grains.owned)), way_(last_.size(), Vec3::Zero())
    {
        for (int g = 0; g < grains.owned; ++g) last_[std::size_t(grains.id[std::size_t(g)])] = grains.position_of(g);
    }
    void follow(const core::ParticleSet& grains)
    {
        for (int g = 0; g < grains.owned; ++g) {
            const auto id = std::size_t(grains.id[std::size_t(g)]);
            const Vec3 moved = grains.position_of(g) - last_[id];
            for (int a = 0; a < 3; ++a) way_[id][a] += std::remainder(moved[a], period_);
            last_[id] = grains.position_of(g);
        }
    }
    /// Mean square along an axis [m2].
    [[nodiscard]] double mean_square() const
    {
        double sum = 0;
        for (const Vec3& way : way_) sum += way.squaredNorm() / 3;
        return sum / double(way_.size());
    }

private:
    double period_;
    std::vector<Vec3> last_, way_;
};

} // namespace

TEST_CASE("decaying turbulence spreads grains as far as the process along their way says")
{
    constexpr int count = 4000;
    io::World world = stirred("[x, y, z]", count);
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    Ways ways(world.grains()->particles, 0.2);
    // Moments of the process for grains that start without a fluctuation, g over its deviation s:
    // d<xx>/dt = 2 s <xg>, d<xg>/dt = s <gg> - <xg> / T, d<gg>/dt = 2 (1 - <gg>) / T.
    double xx = 0, xg = 0, gg = 0;
    for (int n = 0; n < 100; ++n) {
        const double k = world.turbulence()->k().on(0)(1, 1, 1), epsilon = world.turbulence()->epsilon().on(0)(1, 1, 1);
        const double s = std::sqrt(2.0 / 3.0 * k), rate = epsilon / (0.3 * k), dt = world.next_step();
        world.step(*executor);
        ways.follow(world.grains()->particles);
        constexpr int parts = 1000;
        for (int m = 0; m < parts; ++m) {
            const double h = dt / parts;
            xx += h * 2 * s * xg;
            xg += h * (s * gg - rate * xg);
            gg += h * 2 * (1 - gg) * rate;
        }
    }
    MESSAGE("mean square ", ways.mean_square(), " m2, expected ", xx);
    // Of 3 x 4000 squares of normal numbers the mean has a standard deviation of sqrt(2 / 12000) = 1.3 %: three of it.
    CHECK(ways.mean_square() == test::relative(xx).epsilon(0.04));
}

TEST_CASE("grains that are well mixed between walls stay so")
{
    constexpr int count = 4000, layers = 8, steps = 150, from = 100;
    constexpr double width = 0.2;
    io::World world = stirred("[x, z]", count);
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    const auto& grains = world.grains()->particles;
    std::array<double, layers> mean{}; // number in each layer over that of grains spread evenly, from the walls inwards
    for (int n = 0; n < steps; ++n) {
        world.step(*executor);
        for (int g = 0; n >= from && g < grains.owned; ++g) {
            const double y = grains.position_of(g).y();
            mean[std::size_t(std::min(y, width - y) / width * 2 * layers)] += double(layers) / count / (steps - from);
        }
    }
    for (std::size_t j = 0; j < mean.size(); ++j) {
        MESSAGE("layer ", j, " from the walls: ", mean[j]);
        CHECK(std::abs(mean[j] - 1) < 0.14); // three standard deviations of counting 500
    }
}

TEST_CASE("heavy grains damp decaying turbulence as fast as their drag on it says")
{
    CoupledBox box;
    box.size = 16e-3 * Vec3::Ones();
    box.cells = {8, 8, 8};
    box.periodic = {io::Axis::x, io::Axis::y, io::Axis::z};
    box.diameter = 1e-3;
    box.density_ratio = 50; // neither does dispersion move them
    box.dt = 20e-3;
    io::Scene scene = scene_of(box, 1);
    scene.fluid->turbulence = io::TurbulenceKeys{io::TurbulenceModel::k_epsilon, 0.1, 0.1, 2e-3, 0.0};
    scene.coupling->dispersion = io::Switch::off;
    CoupledRun run(scene);
    std::vector<Vec3> places; // one in each cell
    for (int n = 0; n < 512; ++n) places.push_back(2e-3 * Vec3(n % 8 + 0.5, n / 8 % 8 + 0.5, n / 64 + 0.5));
    run.place(places);
    run.start();
    const auto& field = run.world().turbulence()->k();
    double k = field.on(0)(1, 2, 3), epsilon = run.world().turbulence()->epsilon().on(0)(1, 2, 3);
    constexpr double volume = std::numbers::pi / 6 * 1e-9, cell = 8e-9, fluid = 1000 * (1 - volume / cell), c_2 = 1.92;
    for (int n = 0; n < 40; ++n) {
        run.step();
        const auto& columns = run.world().exchange()->columns();
        const double drag = run.grains().columns[std::size_t(columns.drag)][0] / cell;
        const double mass = (run.grains().mass[0] + run.grains().columns[std::size_t(columns.added_mass)][0]) / cell;
        constexpr int parts = 200;
        for (int m = 0; m < parts; ++m) {
            const double h = run.world().clock().dt_before / parts, stokes = mass / drag * 6 * epsilon / k;
            const double rate = 2 * drag * (1 - std::exp(-0.25 * stokes)) / fluid, dissipation = epsilon;
            epsilon -= h * epsilon * (c_2 * epsilon / k + 1.2 * rate);
            k -= h * (dissipation + rate * k);
        }
    }
    MESSAGE("k = ", field.on(0)(1, 2, 3), " m2/s2, expected ", k);
    CHECK(k < 0.1 * 1.5e-4); // it has fallen far
    CHECK(field.on(0)(1, 2, 3) ==
          test::relative(k).epsilon(0.03)); // drag and dissipation one after the other, in steps of a twentieth of the time of decay
}

TEST_CASE("what turbulence does to grains the fluid pays for, in every mode")
{
    for (const io::CouplingMode mode : every_mode) {
        CAPTURE(int(mode));
        CoupledBox box;
        box.periodic = {io::Axis::x, io::Axis::z};
        box.gravity = {0, -9.81, 0};
        box.pressure_gradient = 2e3;
        box.mode = mode;
        io::Scene scene = scene_of(box, 60);
        scene.fluid->turbulence = io::TurbulenceKeys{io::TurbulenceModel::k_epsilon, 0.1, 0.3, {}, 0.0};
        CoupledRun run(scene);
        run.start({0.3, 0, 0}, {0.3, 0, 0});
        REQUIRE(run.world().exchange()->disperses());
        io::MomentumLedger books(run.world());
        for (int n = 0; n < 20; ++n) {
            run.step();
            books.update();
            CHECK(books.exchange_defect() < 1e-12); // rounding of sums over grains and cells
        }
    }
}
