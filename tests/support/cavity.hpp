// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Flow in a square cavity under a lid that moves, compared with velocities on its middle lines.
#include "tests/support/fluid_run.hpp"
#include <span>

namespace test {

/// Place on a middle line, velocity across it (under the lid) or along it (down the sides).
struct CavityReference {
    double at, velocity;
};

struct Cavity {
    int cells = 32;
    double reynolds = 100;
    double squeeze = 0;   ///< of the cells towards the walls: those there are 1 - squeeze times as wide as even ones
    double until = 20;    ///< in units of side over lid speed
    double courant = 0.8; ///< of the lid over the cells below it
};

/// Makes the flow from rest and looks at it.
class CavityRun {
public:
    explicit CavityRun(const Cavity& cavity) : cells_(cavity.cells), run_(grid(cavity), parameters(cavity))
    {
        run_.start([](const Vec3&) { return Vec3(0, 0, 0); });
        const double dt = cavity.courant * (1 - cavity.squeeze) / cells_;
        while (run_.time() < cavity.until) run_.step(dt);
    }

    /// Horizontal velocity on x = 1/2 at a height.
    [[nodiscard]] double across(double height) const { return at(0.5, height).x(); }
    /// Vertical velocity on y = 1/2.
    [[nodiscard]] double down(double place) const { return at(place, 0.5).y(); }
    /// Root mean square difference on both lines.
    [[nodiscard]] double error(std::span<const CavityReference> below_lid, std::span<const CavityReference> from_side) const
    {
        double sum = 0;
        for (const CavityReference& r : below_lid) sum += std::pow(across(r.at) - r.velocity, 2);
        for (const CavityReference& r : from_side) sum += std::pow(down(r.at) - r.velocity, 2);
        return std::sqrt(sum / double(below_lid.size() + from_side.size()));
    }
    /// Largest change of a velocity in one more step, per time.
    [[nodiscard]] double unrest()
    {
        std::vector<Vec3> before;
        for_cells([&](int i, int j) { before.push_back(run_.velocity(0, i, j, 0)); });
        const double start = run_.time();
        run_.step(run_.fluid().state().clock.dt);
        double largest = 0;
        auto old = before.begin();
        for_cells([&](int i, int j) { largest = std::max(largest, (run_.velocity(0, i, j, 0) - *old++).norm()); });
        return largest / (run_.time() - start);
    }

private:
    static core::MultiBlock grid(const Cavity& c)
    {
        const auto squeezed = [s = c.squeeze](double x) { return x - s / (2 * std::numbers::pi) * std::sin(2 * std::numbers::pi * x); };
        const core::Box box{{0, 0, 0}, {1, 1, 1.0 / c.cells}, {c.cells, c.cells, 1}, {1, 1, 1}, {false, false, true}};
        return core::make_box(box, [=](const Vec3& x) { return Vec3(squeezed(x.x()), squeezed(x.y()), x.z()); });
    }
    static physics::FluidParameters parameters(const Cavity& c)
    {
        physics::FluidParameters p;
        p.viscosity = 1 / c.reynolds;
        p.boundaries["y_high"].velocity = Vec3(1, 0, 0);
        return p;
    }
    template <class Body>
    void for_cells(Body body) const
    {
        for (int j = 0; j < cells_; ++j)
            for (int i = 0; i < cells_; ++i) body(i, j);
    }

    /// Weights of the four cells around a place along one axis, cubic.
    struct Stencil {
        int first;
        std::array<double, 4> weights;
    };
    [[nodiscard]] Stencil around(double place) const
    {
        const auto centre = [&](int n) { return run_.centre(0, n, 0, 0).x(); }; // the same along both axes
        int above = 0;
        while (above < cells_ && centre(above) < place) ++above;
        Stencil s{std::clamp(above - 2, 0, cells_ - 4), {1, 1, 1, 1}};
        for (int n = 0; n < 4; ++n)
            for (int m = 0; m < 4; ++m)
                if (m != n) s.weights[std::size_t(n)] *= (place - centre(s.first + m)) / (centre(s.first + n) - centre(s.first + m));
        return s;
    }
    [[nodiscard]] Vec3 at(double x, double y) const
    {
        const Stencil along = around(x), up = around(y);
        Vec3 sum = Vec3::Zero();
        for (int m = 0; m < 4; ++m)
            for (int n = 0; n < 4; ++n)
                sum += along.weights[std::size_t(n)] * up.weights[std::size_t(m)] * run_.velocity(0, along.first + n, up.first + m, 0);
        return sum;
    }

    int cells_;
    FluidRun run_;
};

} // namespace test
