// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Momentum of a fluid that fills a share of each cell, carried by fluxes through faces: what must be true of any share.
#include "physics/fluid/limited_momentum.hpp"
#include "core/comm/halo.hpp"
#include "core/grid/box.hpp"
#include "physics/fluid/cell_loops.hpp"
#include "physics/fluid/gradient.hpp"
#include "physics/fluid/parameters.hpp"
#include <cmath>
#include <cstdio>
#include <doctest/doctest.h>
#include <functional>
#include <numbers>

namespace {

using core::Vec3;
constexpr double pi = std::numbers::pi;

core::MultiBlock line(
    core::Extents cells, std::function<Vec3(const Vec3&)> place = [](const Vec3& x) { return x; })
{
    return core::make_box({{0, 0, 0}, {1, 1, 1}, cells, {1, 1, 1}, {true, true, true}}, place);
}

/// A flow through the cells of one block, periodic in all directions.
class Carried {
public:
    explicit Carried(core::MultiBlock grid)
        : mesh(std::move(grid), 0, 1),
          exchange_(mesh, ranks_, 1, 1, core::HaloShape::faces),
          walls_(physics::make_walls(mesh, {})),
          centres_(physics::face_centres(mesh.vertices(0))),
          share(scalar()),
          share_after(scalar()),
          velocity(vector()),
          middle_(vector()),
          carrier(vector()),
          acceleration(vector()),
          after_(vector()),
          gradients_{vector(), vector(), vector()},
          flux({"flux", "", 0, false}, mesh.own_cells()),
          momentum_{flux, flux, flux}
    {
        for (auto* f : {&share, &share_after}) f->allocate();
        for (auto* f : {&velocity, &middle_, &carrier, &acceleration, &after_, &gradients_[0], &gradients_[1], &gradients_[2]})
            f->allocate();
        for (auto* f : {&flux, &momentum_[0], &momentum_[1], &momentum_[2]}) f->allocate();
    }
    /// Carries the velocity for dt, and lets the acceleration act.
    void step(double dt)
    {
        const auto& geometry = mesh.geometry(0);
        exchange_.fill(velocity);
        for (int c = 0; c < 3; ++c)
            physics::gradient(geometry, geometry.gradient, velocity.on(0).component(c), gradients_[std::size_t(c)].on(0));
        physics::map_components(
            middle_.on(0), [dt](double u, double a) { return u + 0.5 * dt * a; }, velocity.on(0), acceleration.on(0));
        const std::array<core::VectorView<const double>, 3> g{gradients_[0].on(0), gradients_[1].on(0), gradients_[2].on(0)};
        physics::middle_velocity(dt, carrier.on(0), middle_.on(0), g, middle_.on(0));
        for (auto* f : {&middle_, &carrier, &gradients_[0], &gradients_[1], &gradients_[2]}) exchange_.fill(*f);
        physics::limited_momentum_flux(
            {{geometry, walls_[0], walls_[0], centres_}, flux.on(0), {velocity.on(0), middle_.on(0), g}, carrier.on(0), dt},
            {momentum_[0].on(0), momentum_[1].on(0), momentum_[2].on(0)});
        physics::carry_momentum({geometry, 0, share.on(0), velocity.on(0), dt}, flux.on(0),
                                {momentum_[0].on(0), momentum_[1].on(0), momentum_[2].on(0)}, share_after.on(0), after_.on(0));
        physics::map_components(
            velocity.on(0), [dt](double u, double a) { return u + dt * a; }, after_.on(0), acceleration.on(0));
    }
    [[nodiscard]] Vec3 momentum(const core::ScalarField& phi) const
    {
        Vec3 sum = Vec3::Zero();
        for (int c = 0; c < 3; ++c)
            sum[c] = physics::sum_cells([](double v, double w, double u) { return v * w * u; }, mesh.geometry(0).volume.view(), phi.on(0),
                                        velocity.on(0).component(c));
        return sum;
    }

private:
    core::ScalarField scalar() const { return {{"scalar", "", 1, false}, mesh.own_cells()}; }
    core::VectorField vector() const { return {{"vector", "", 1, false}, mesh.own_cells()}; }
    core::Communicator ranks_ = core::Communicator::self();

public:
    core::Mesh mesh;

private:
    core::HaloExchange exchange_;
    std::vector<physics::BlockWalls> walls_;
    physics::FaceCentres centres_;

public:
    core::ScalarField share, share_after;
    core::VectorField velocity;

private:
    core::VectorField middle_;

public:
    core::VectorField carrier, acceleration;

private:
    core::VectorField after_;
    std::array<core::VectorField, 3> gradients_;

public:
    core::FaceField flux;

private:
    std::array<core::FaceField, 3> momentum_;
};

/// A steady flow of 1 m/s through shares along x, which `filled` integrates; beside it a velocity across, that the flow carries.
struct ThroughShares {
    std::function<double(double)> filled, across;
};

Carried start(const ThroughShares& flow, int n)
{
    Carried run(line({n, 1, 1}));
    const double h = 1.0 / n;
    for (int i = 0; i < n; ++i) {
        const double low = i * h, high = low + h, phi = (flow.filled(high) - flow.filled(low)) / h;
        run.share.on(0)(i, 0, 0) = phi;
        run.carrier.on(0).x(i, 0, 0) = run.velocity.on(0).x(i, 0, 0) = 1 / phi;
        run.velocity.on(0).y(i, 0, 0) = flow.across(0.5 * (flow.filled(low) + flow.filled(high)));
    }
    physics::map_cells(
        run.flux.on(0).i, [](double) { return 1.0; }, run.flux.on(0).i); // through faces of 1 m2
    return run;
}

/// Mean |u - exact| after a fifth of a turn, of the flow and of what it carries across.
std::array<double, 2> error(int n)
{
    const auto filled = [](double x) { return 0.7 * x - 0.2 / (2 * pi) * (std::cos(2 * pi * x) - 1); };
    const auto across = [](double s) { return std::sin(2 * pi * s / 0.7); };
    Carried run = start({filled, across}, n);
    for (int i = 0; i < n; ++i) { // what keeps the flow steady: u du/dx
        const double x = (i + 0.5) / n, phi = 0.7 + 0.2 * std::sin(2 * pi * x);
        run.acceleration.on(0).x(i, 0, 0) = -0.4 * pi * std::cos(2 * pi * x) / (phi * phi * phi);
    }
    const double end = 0.14;
    const int steps = n / 2;
    for (int step = 0; step < steps; ++step) run.step(end / steps);
    std::array<double, 2> sum{};
    for (int i = 0; i < n; ++i) {
        const double low = filled(double(i) / n), high = filled((i + 1.0) / n);
        sum[0] += std::abs(run.velocity.on(0).x(i, 0, 0) - 1 / (n * (high - low))) / n;
        sum[1] += std::abs(run.velocity.on(0).y(i, 0, 0) - across(0.5 * (low + high) - end)) / n;
    }
    return sum;
}

} // namespace

TEST_CASE("a uniform flow stays uniform, whatever share it fills and whatever the fluxes are")
{
    Carried run(line({6, 5, 4}, [](const Vec3& x) {
        return Vec3(x + 0.04 * Vec3(std::sin(2 * pi * x.y()), std::sin(2 * pi * x.z()), std::sin(2 * pi * x.x())));
    }));
    int n = 0;
    const auto some = [&n](double) { return std::fmod(0.618034 * ++n, 1.0); };
    physics::map_cells(
        run.share.on(0), [&](double x) { return 0.4 + 0.6 * some(x); }, run.share.on(0));
    physics::map_faces(
        run.flux.on(0), [&](double x) { return 1e-2 * (some(x) - 0.5); }, run.flux.on(0));
    const Vec3 u(0.3, -0.7, 0.2);
    for (int c = 0; c < 3; ++c)
        physics::map_cells(
            run.velocity.on(0).component(c), [v = u[c]](double) { return v; }, run.velocity.on(0).component(c));
    run.step(0.1);
    double most = 0;
    for (int c = 0; c < 3; ++c)
        core::for_each_cell(run.mesh.geometry(0).cells,
                            [&](int i, int j, int k) { most = std::max(most, std::abs(run.velocity.on(0).component(c)(i, j, k) - u[c])); });
    CHECK(most < 1e-15); // a last digit
}

TEST_CASE("what a flow carries through shares that change smoothly is of second order, and the flow itself as well")
{
    const auto coarse = error(40), fine = error(80), finest = error(160);
    for (const std::size_t n : {0, 1}) {
        const double order = std::log2(fine[n] / finest[n]);
        std::printf("%s: errors %.2e %.2e %.2e, order %.2f\n", n == 0 ? "flow" : "carried across", coarse[n], fine[n], finest[n], order);
        CHECK(order > 1.9);
        CHECK(finest[n] < 1e-3);
    }
}

TEST_CASE("where the share jumps by 0.4 in a cell, what is carried stays in its range and its momentum is kept")
{
    const int n = 60;
    const auto filled = [](double x) { return x < 0.5 ? x : 0.5 + 0.6 * (x - 0.5); };
    const auto step_across = [](double s) { return s > 0.2 && s < 0.4 ? 1.0 : 0.0; };
    const auto none = [](double) { return 0.0; };
    struct Case {
        bool along, across; ///< Is the flow itself carried, from 1 to 1 / 0.6 m/s and back? Is a step across it?
        double excess;      ///< over the largest difference of the vectors
    };
    // One component alone is carried without excess. The differences of vectors that change in two components where the other one does
    // not may be cut less than each of the two alone.
    for (const Case& c : {Case{false, true, 1e-12}, {true, false, 1e-12}, {true, true, 0.1}}) {
        Carried run = start({filled, c.across ? step_across : none}, n);
        const Vec3 before = run.momentum(run.share);
        double low = 0, high = c.across ? 1 : 0, slow = 1, fast = 1 / 0.6;
        for (int step = 0; step < 3 * n; ++step) {
            if (!c.along) std::fill(run.velocity.data(0, 0).begin(), run.velocity.data(0, 0).end(), 1.0);
            run.step(0.5 / n); // 0.83 of the fluid leaves the cells that are filled by 0.6
            for (int i = 0; i < n; ++i) {
                const double v = run.velocity.on(0).y(i, 0, 0), u = run.velocity.on(0).x(i, 0, 0);
                low = std::min(low, v);
                high = std::max(high, v);
                slow = std::min(slow, u);
                fast = std::max(fast, u);
            }
        }
        std::printf("across from %.4f to %.4f, along from %.4f to %.4f m/s\n", low, high, slow, fast);
        CHECK(low >= -c.excess);
        CHECK(high <= 1 + c.excess);
        CHECK(slow >= 1 - c.excess);
        CHECK(fast <= 1 / 0.6 + c.excess);
        CHECK(std::abs(run.momentum(run.share)[1] - before[1]) < 1e-14);
    }
}
