// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/error.hpp"
#include "io/build/coupling_builder.hpp"
#include "physics/particles/contact_laws.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <doctest/doctest.h>
#include <numbers>

namespace {

physics::LubricationFilm film_of(const std::string& coupling)
{
    const io::Scene scene = test::scene_from_text(
        "name: films\ngrid: { box: { size: [1 cm, 1 cm, 1 cm], cells: [4, 4, 4] } }\n"
        "fluid: { oil: { density: 900 kg/m3, viscosity: 1e-4 m2/s } }\n"
        "particles: [ { name: balls, count: 3, diameter: 2 mm, density: 2500 kg/m3 } ]\ncontact: { stiffness: 1 kN/m }\n" +
        coupling + "run: { until: 1 s }\n");
    return io::lubrication_film(scene, io::census_of(scene));
}

} // namespace

TEST_CASE("a scene has films where it asks for them, in metres or in diameters")
{
    CHECK(!film_of("").acts());
    CHECK(!film_of("coupling: { drag: smooth }\n").acts());
    const auto film = film_of("coupling: { lubrication: { roughness: 1 um } }\n");
    CHECK(film.factor == test::relative(6 * std::numbers::pi * 0.09));
    CHECK(film.roughness == test::relative(1e-6));
    CHECK(film.range == test::relative(0.2e-3));
}

TEST_CASE("a film whose roughness is beyond its range is refused")
{
    physics::ParticleParameters parameters;
    parameters.film = film_of("coupling: { lubrication: { roughness: 0.2 d } }\n");
    CHECK_THROWS_AS((void)physics::pair_laws(parameters, 1e-6), core::ConfigError);
}
