// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Sizes of particles in scenes.
#include "io/build/grain_census.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <cmath>

using test_scene::problem_of;
using test_scene::with;

namespace {

std::string sized(const std::string& sizes) { return with("diameter: 2 mm", "sizes: { " + sizes + " }"); }

} // namespace

TEST_CASE("sizes are given in one way, with what their shares are shares of")
{
    CHECK(problem_of(sized("share_of: mass, list: [[1 mm, 1], [2 mm, 1]]")) == "");
    CHECK(problem_of(sized("share_of: number, sieve: [[1 mm, 0], [2 mm, 1]]")) == "");
    CHECK(problem_of(sized("share_of: mass, lognormal: { median: 2 mm, deviation: 1.3, smallest: 1 mm, largest: 4 mm }")) == "");
    CHECK(problem_of(sized("list: [[1 mm, 1], [2 mm, 1]]")) == "9:27 'share_of' is missing");
    CHECK(problem_of(sized("share_of: mass")) == "9:27 'list' is missing");
    CHECK(problem_of(sized("share_of: mass, list: [[2 mm, 1], [1 mm, 1]]")) ==
          "9:70 the lengths of a table must increase, and 0.001 m follows 0.002 m");
    CHECK(problem_of(sized("share_of: mass, sieve: [[1 mm, 0], [2 mm, 0.9]]")).starts_with("9:27 what passes a sieve must go from 0"));
    CHECK(problem_of(sized("share_of: mass, list: [[1 mm, 1], [60 mm, 1]]")) == "9:27 the particles are larger than the domain");
    CHECK(problem_of(with("diameter: 2 mm", "diameter: 2 mm, sizes: { share_of: mass, list: [[1 mm, 1], [2 mm, 1]] }")) ==
          "9:43 'diameter' excludes 'sizes'");
    CHECK(problem_of(with("diameter: 2 mm, ", "")) == "9:5 'diameter' is missing");
}

TEST_CASE("the numbers of a scene with sizes are those of its particles")
{
    const io::Scene scene = test::scene_from_text(sized("share_of: number, list: [[1 mm, 4], [2 mm, 1]]"));
    const io::GrainCensus census = io::census_of(scene);
    CHECK(census.count == 10);
    CHECK(census.cubes == test::relative(8e-9 + 2 * 8e-9).epsilon(1e-12));
    CHECK(census.mean_diameter() == test::relative(std::cbrt(2.4e-9)).epsilon(1e-12));
    CHECK(census.smallest == 1e-3);
    CHECK(census.largest == 2e-3);
    CHECK(io::size_report(scene) == "S: 10 of 1 to 2 mm; 10, 50 and 90 % of the mass up to 1, 2 and 2 mm\n"); // a third is small
}
