// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/exact_sum.hpp"
#include "core/base/random.hpp"
#include <algorithm>
#include <doctest/doctest.h>
#include <vector>

namespace {

core::ExactSum sum_of(const std::vector<double>& values)
{
    core::ExactSum sum;
    for (const double x : values) sum.add(x);
    return sum;
}

} // namespace

TEST_CASE("an exact sum loses nothing to larger terms that cancel")
{
    CHECK(sum_of({1e60, 1.0, -1e60}).value() == 1.0);
    CHECK(sum_of({1e60, -1e-60, -1e60}).value() == -1e-60);
    CHECK(sum_of({0.1, 0.2, -0.1, -0.2}).value() == 0.0);
    CHECK(sum_of({}).value() == 0.0);
    for (const double x : {1.0, -1.0, 0.1, -3.7e-30, 1.2345e25, -4294967296.0}) CHECK(sum_of({x}).value() == x);
}

TEST_CASE("an exact sum has the same bits in any order and from any parts")
{
    std::vector<double> values;
    for (int n = 0; n < 1000; ++n) {
        const auto u = core::random_uniform(3, n, 0);
        values.push_back((u[0] - 0.5) * std::ldexp(1.0, int(80 * u[1]) - 40));
    }
    const double all = sum_of(values).value();
    long double reference = 0; // 64 bits: terms down to 2^-40 below 2^40 leave some rounding
    for (const double x : values) reference += x;
    CHECK(std::abs(all - double(reference)) < 1e-4);
    std::reverse(values.begin(), values.end());
    CHECK(sum_of(values).value() == all);
    core::ExactSum first = sum_of({values.begin(), values.begin() + 317});
    first.add(sum_of({values.begin() + 317, values.end()}));
    CHECK(first.value() == all);
    core::ExactSum::Digits together = sum_of({values.begin(), values.begin() + 500}).parts();
    const auto rest = sum_of({values.begin() + 500, values.end()}).parts();
    for (std::size_t n = 0; n < together.size(); ++n) together[n] += rest[n];
    core::ExactSum joined;
    joined.add(together);
    CHECK(joined.value() == all);
}
