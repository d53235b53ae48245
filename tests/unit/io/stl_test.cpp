// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// STL files in text and binary, and the triangles of walls.
#include "core/base/error.hpp"
#include "io/build/wall_shapes.hpp"
#include "io/files/stl.hpp"
#include "tests/unit/io/temporary_folder.hpp"
#include <doctest/doctest.h>
#include <fstream>
#include <numbers>

using core::Vec3;

namespace {

const std::string facet = "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1.5e0 0 0\n  vertex 0 -2 0.25\n endloop\nendfacet\n";

std::filesystem::path written(const std::filesystem::path& file, const std::string& content)
{
    std::ofstream(file, std::ios::binary) << content;
    return file;
}

std::string problem_of(const std::filesystem::path& file)
{
    try {
        (void)io::read_stl(file);
    } catch (const core::ConfigError& error) {
        return std::string(error.what()).substr(file.string().size());
    }
    return "";
}

} // namespace

TEST_CASE("an STL file in text and in binary holds the same triangles")
{
    const TemporaryFolder folder;
    const auto text = written(folder.path() / "text.stl", "solid two words\n" + facet + facet + "endsolid two words\n");
    const auto triangles = io::read_stl(text);
    REQUIRE(triangles.size() == 2);
    CHECK(triangles[1][0] == Vec3::Zero());
    CHECK(triangles[1][1] == Vec3(1.5, 0, 0));
    CHECK(triangles[1][2] == Vec3(0, -2, 0.25));
    io::write_stl(folder.path() / "binary.stl", triangles);
    CHECK(std::filesystem::file_size(folder.path() / "binary.stl") == 84 + 2 * 50);
    CHECK(io::read_stl(folder.path() / "binary.stl") == triangles);
}

TEST_CASE("what is wrong with an STL file is said with its line or byte")
{
    const TemporaryFolder folder;
    const auto file = folder.path() / "wall.stl";
    CHECK_THROWS_AS((void)io::read_stl(folder.path() / "missing.stl"), core::ConfigError);
    CHECK(problem_of(written(file, "solid a\nfacet normal 0 0 1\n outer loop\n  vertex 0 0 x\n")) ==
          ":4: a number is needed here, and this is 'x'");
    CHECK(problem_of(written(file, "solid a\n" + facet + "endsolod a\n")) ==
          ":9: 'facet' or 'endsolid' is needed here, and this is 'endsolod'");
    CHECK(problem_of(written(file, "solid a\n" + facet)) == ":9: 'facet' or 'endsolid' is needed here, and this is ''");
    CHECK(problem_of(written(file, "solid a\nendsolid a\n")) == ": there are no triangles in this file");
    io::write_stl(file, {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}});
    std::filesystem::resize_file(file, 84 + 49);
    CHECK(problem_of(file) == ": byte 0: this is no STL file in text, and as a binary one it would have 134 bytes, not 133");
    io::write_stl(file, {{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, std::nan(""), 0)}});
    CHECK(problem_of(file) == ": byte 124: triangle 1 has a corner that is no number");
}

TEST_CASE("tubes, cones and discs have the area of theirs")
{
    const auto area = [](const io::WallKeys& wall) {
        double sum = 0;
        for (const auto& [a, b, c] : io::triangles_of(wall)) sum += 0.5 * (b - a).cross(c - a).norm();
        return sum;
    };
    const double pi = std::numbers::pi, few = 1e-3; // 96 corners: pi^2 / (6 96^2) = 2e-4 for each direction around
    io::WallKeys wall;
    wall.tube = io::TubeKeys{Vec3(1, 1, 1), Vec3(1, 3, 1), 0.5, {}};
    CHECK(area(wall) == doctest::Approx(2 * pi * 0.5 * 2).epsilon(few));
    wall.tube->end_radius = 0.25;
    CHECK(area(wall) == doctest::Approx(pi * 0.75 * std::hypot(2, 0.25)).epsilon(few));
    wall.tube.reset();
    wall.disc = io::DiscKeys{Vec3(0, 0, 1), Vec3::UnitX(), 2, 0};
    CHECK(area(wall) == doctest::Approx(pi * 4).epsilon(few));
    wall.disc->hole = 1;
    CHECK(area(wall) == doctest::Approx(pi * 3).epsilon(few));
}
