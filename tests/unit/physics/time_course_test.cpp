// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "physics/fluid/time_course.hpp"
#include "tests/support/relative.hpp"
#include <cmath>
#include <doctest/doctest.h>

namespace {

using physics::TableCourse;
using Between = TableCourse::Between;
using Beyond = TableCourse::Beyond;

const std::vector<TableCourse::Point> points{{0, 0}, {1, 2}, {3, 1}, {4, 1}, {5, 0}};

/// Midpoint rule with steps of `width`, which meet all points.
double brute_integral(const physics::TimeCourse& course, double begin, double end, double width)
{
    double sum = 0;
    const auto steps = std::llround((end - begin) / width);
    for (long long n = 0; n < steps; ++n) sum += width * physics::value_at(course, begin + (double(n) + 0.5) * width);
    return sum;
}

} // namespace

TEST_CASE("a table goes through its points, straight or without extremes of its own, and is held or repeated")
{
    for (const Between between : {Between::linear, Between::cubic})
        for (const Beyond beyond : {Beyond::hold, Beyond::repeat}) {
            const TableCourse table(points, between, beyond);
            for (const auto& p : points) CHECK(table.value(p.time) == p.value);
            CHECK(table.value(7) == (beyond == Beyond::hold ? 0 : table.value(2)));
            CHECK(table.value(-3) == (beyond == Beyond::hold ? 0 : table.value(2)));
            CHECK(table.value(3.5) == 1); // level between equal points
            for (double t = 0; t <= 5; t += 0.01) {
                CHECK(table.value(t) >= 0);
                CHECK(table.value(t) <= 2);
            }
        }
    CHECK(TableCourse(points, Between::linear, Beyond::hold).value(2) == 1.5);
}

TEST_CASE("cubics between points are fourth order away from extremes")
{
    const auto error = [](int count) {
        std::vector<TableCourse::Point> rising;
        for (int n = 0; n <= count; ++n) rising.push_back({double(n) / count, std::exp(double(n) / count)});
        const TableCourse table(rising, Between::cubic, Beyond::hold);
        double worst = 0;
        for (double t = 0.25; t <= 0.75; t += 0.0013) worst = std::max(worst, std::abs(table.value(t) - std::exp(t)));
        return worst;
    };
    // The slopes of Fritsch and Butland are second order on even points, so values are third order.
    CHECK(std::log2(error(20) / error(40)) > 2.8);
}

TEST_CASE("the mean of a course over a step is the integral over it, through any number of points")
{
    for (const Between between : {Between::linear, Between::cubic})
        for (const Beyond beyond : {Beyond::hold, Beyond::repeat}) {
            const physics::TimeCourse course = TableCourse(points, between, beyond);
            for (const auto& [begin, end] : {std::pair{0.25, 0.5}, {0.5, 4.5}, {-2.0, 1.5}, {2.0, 4.5}}) {
                const double brute = brute_integral(course, begin, end, 1.0 / 1024);
                CHECK((end - begin) * physics::mean_value(course, begin, end - begin) ==
                      test::relative(brute).epsilon(1e-5)); // of the midpoint rule, 1e-6 of second derivatives / 24
            }
        }
    const physics::TimeCourse harmonic = physics::HarmonicCourse{0.5, 2, 3, 0.2};
    CHECK(1.7 * physics::mean_value(harmonic, 0.4, 1.7) ==
          test::relative(0.5 * 1.7 + 2.0 / 3 * (std::sin(3 * 2.1 + 0.2) - std::sin(3 * 0.4 + 0.2))).epsilon(1e-14));
}

TEST_CASE("means over tiny steps are the value, however late")
{
    for (const double t : {0.3, 1.0, 1e3 + 0.3})
        for (const Between between : {Between::linear, Between::cubic}) {
            const physics::TimeCourse course = TableCourse(points, between, Beyond::repeat);
            CHECK(physics::mean_value(course, t, 1e-9) == test::relative(physics::value_at(course, t)).epsilon(1e-8)); // slope 2 [1/s]
        }
    CHECK(physics::largest_magnitude(TableCourse(points, Between::linear, Beyond::hold)) == 2);
}

TEST_CASE("tables out of order, of one point, or that would jump when repeated are refused")
{
    using core::ConfigError;
    CHECK_THROWS_AS(TableCourse({{0, 0}}, Between::linear, Beyond::hold), ConfigError);
    CHECK_THROWS_AS(TableCourse({{0, 0}, {2, 1}, {2, 3}}, Between::linear, Beyond::hold), ConfigError);
    CHECK_THROWS_AS(TableCourse({{0, 0}, {2, 1}}, Between::linear, Beyond::repeat), ConfigError);
}
