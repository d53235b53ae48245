// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/units.hpp"
#include "tests/support/relative.hpp"
#include <doctest/doctest.h>

TEST_CASE("a quantity is the double nearest to its decimal value in SI")
{
    const io::Units units;
    CHECK(units.read("2 mm", "m").value == 2e-3);
    CHECK(units.read("2mm", "m").value == 2e-3);
    CHECK(units.read("4.5 ms", "s").value == 4.5e-3);
    CHECK(units.read("33.3 kPa/m", "Pa/m").value == 33300.0);
    CHECK(units.read("1e-6 m2/s", "m2/s").value == 1e-6);
    CHECK(units.read("1 cSt", "m2/s").value == 1e-6);
    CHECK(units.read("5 kN/m", "N/m").value == 5000.0);
    CHECK(units.read("1 g/cm3", "kg/m3").value == 1000.0);
    CHECK(units.read("-3.25e+2 um", "m").value == -3.25e-4);
    CHECK(units.read("+7 m", "m").value == 7.0);
    CHECK(units.read("0.3", "1").value == 0.3);
}

TEST_CASE("units that are no powers of ten convert too")
{
    const io::Units units;
    CHECK(units.read("2 hours", "s").value == test::relative(7200.0).epsilon(1e-14)); // one rounding
    CHECK(units.read("1 inch", "m").value == test::relative(0.0254).epsilon(1e-14));
    CHECK(units.read("50 %", "1").value == test::relative(0.5).epsilon(1e-14));
}

TEST_CASE("a quantity without its unit, or with a wrong one, is refused and told which unit is needed")
{
    const io::Units units;
    for (const char* text : {"2", "2 kg", "2 mn", "2 3 m", "mm", "", "two mm", "2 m s", "nan m", "inf m", "0x10 m", "1e999 m"}) {
        CAPTURE(text);
        const auto result = units.read(text, "m");
        CHECK(!result.error.empty());
        CHECK(result.hint.find("unit of m, for example '2 mm'") != std::string::npos);
    }
    CHECK(!units.read("30 degC", "K").error.empty());
    CHECK(!units.read("1 mm", "1").error.empty());
}

TEST_CASE("a number written as text reads back as the same bits")
{
    for (double x : {0.1, 1.0 / 3.0, 5e-324, 1.7976931348623157e308, -0.0, 33300.0}) CHECK(io::parse_number(io::number_text(x)) == x);
}
