// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// What points sample and deposit beside sides whose points do not match.
#include "core/comm/halo.hpp"
#include "core/field/sample.hpp"
#include "tests/support/joined_boxes.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>
#include <random>
#include <utility>

using core::Mesh, core::Vec3;

namespace {

/// Two boxes of length 1 that meet at x = 1, with 6 and `fine` cells along each edge.
core::MultiBlock two_boxes(int fine)
{
    return test::joined({{{0, 0, 0}, {1, 1, 1}, {6, 6, 6}, {1, 1, 1}, {}}, {{1, 0, 0}, {2, 1, 1}, {fine, fine, fine}, {1, 1, 1}, {}}}, {},
                        [](const Vec3& x) { return x; });
}

class Sampling {
public:
    explicit Sampling(core::MultiBlock grid)
        : mesh_(std::move(grid), 0, 1),
          locator_(mesh_),
          halo_(mesh_, core::Communicator::self(), 1, 1, core::HaloShape::hats),
          field_({"f", "", 1, false}, mesh_.own_cells()),
          deposit_({"q", "", 1, false}, mesh_.own_cells())
    {
        field_.allocate();
        deposit_.allocate();
    }
    template <class Value>
    void set(Value value)
    {
        for_cells([&](core::LocalBlock b, int i, int j, int k) { field_.on(b)(i, j, k) = value(mesh_.geometry(b).centre(i, j, k)); });
        halo_.fill(field_);
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) core::mirror_even(mesh_, b, field_.on(b));
    }
    double at(const Vec3& x)
    {
        const auto stencil = core::hat_stencil(mesh_, locator_.find(x).value());
        return core::sample(stencil, std::as_const(field_).on(stencil.block));
    }
    void put(const Vec3& x, double quantity)
    {
        const auto stencil = core::hat_stencil(mesh_, locator_.find(x).value());
        core::deposit(stencil, quantity, deposit_.on(stencil.block));
    }
    void send_home()
    {
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b) core::mirror_even_transpose(mesh_, b, deposit_.on(b));
        halo_.add_home(deposit_);
    }
    template <class Use>
    void for_cells(Use use)
    {
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b)
            core::for_each_cell(mesh_.own_cells()[std::size_t(b)], [&](int i, int j, int k) { use(b, i, j, k); });
    }
    core::ScalarField& field() { return field_; }
    core::ScalarField& deposited() { return deposit_; }

private:
    Mesh mesh_;
    core::Locator locator_;
    core::HaloExchange halo_;
    core::ScalarField field_, deposit_;
};

} // namespace

TEST_CASE("a linear field is sampled as it is on both sides, and a curved one without a step")
{
    for (const int fine : {9, 12, 24}) {
        Sampling sampling(two_boxes(fine));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> inside(0.2, 0.8); // no wall next to the cells around
        const auto linear = [](const Vec3& x) { return 2 * x.x() - 3 * x.y() + x.z(); };
        sampling.set(linear);
        double worst = 0;
        for (int n = 0; n < 300; ++n) {
            const Vec3 x(0.5 + inside(random), inside(random), inside(random));
            worst = std::max(worst, std::abs(sampling.at(x) - linear(x)));
        }
        CHECK(worst < 1e-13); // round-off of values of 3
        const auto curved = [](const Vec3& x) { return std::sin(2 * x.x()) * std::cos(2 * x.y()) * std::cos(x.z()); };
        sampling.set(curved);
        double step = 0;
        for (int n = 0; n < 300; ++n) {
            const Vec3 x(1, inside(random), inside(random));
            step = std::max(step, std::abs(sampling.at(x - Vec3(1e-7, 0, 0)) - sampling.at(x + Vec3(1e-7, 0, 0))));
        }
        INFO("ratio 6:", fine, ", step ", step);
        // Linear interpolation along two axes, on both sides: h^2 / 8 of a second derivative of 4, half of it weighed.
        CHECK(step < 0.5 * 2 * 4 / 8.0 / 36);
    }
}

TEST_CASE("beside such sides, too, sampling and depositing are transposes and conserve, and nothing is less than what was put")
{
    Sampling sampling(test::wavy_halves({{6, 8, 6}, {4, 12, 9}}, 0.2, 0));
    std::mt19937 random(5);
    std::uniform_real_distribution<double> number(0, 1);
    sampling.set([&](const Vec3&) { return number(random); });
    double sampled = 0, deposited = 0, total = 0, least = 1;
    for (int n = 0; n < 500; ++n) {
        const Vec3 x = 2 * std::numbers::pi * Vec3(0.1 + 0.8 * number(random), 0.1 + 0.8 * number(random), 0.1 + 0.8 * number(random));
        const double quantity = number(random);
        sampled += quantity * sampling.at(x);
        sampling.put(x, quantity);
        total += quantity;
    }
    sampling.send_home();
    sampling.for_cells([&](core::LocalBlock b, int i, int j, int k) {
        const double q = sampling.deposited().on(b)(i, j, k);
        deposited += sampling.field().on(b)(i, j, k) * q;
        total -= q;
        least = std::min(least, q);
    });
    CHECK(sampled == test::relative(deposited).epsilon(1e-12)); // round-off of some thousand products
    CHECK(std::abs(total) < 1e-12);
    CHECK(least >= 0);
}
