// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_writer.hpp"
#include "tests/support/source_root.hpp"
#include "tests/unit/io/scene_text.hpp"
#include <algorithm>
#include <doctest/doctest.h>
#include <filesystem>

namespace {

std::vector<std::filesystem::path> shipped_scenes()
{
    std::vector<std::filesystem::path> scenes;
    for (const auto& entry : std::filesystem::directory_iterator(test::source_root() / "configs"))
        if (std::filesystem::exists(entry.path() / "scene.yaml")) scenes.push_back(entry.path());
    std::sort(scenes.begin(), scenes.end());
    return scenes;
}

/// Contacts with a value other than the default for many keys.
io::Contact some_contact()
{
    io::Contact contact;
    contact.law = io::ContactLaw::hertz;
    contact.young_modulus = 1e8 / 3.0;
    contact.poisson_ratio = 0.3;
    contact.rolling = io::RollingModel::constant;
    contact.rolling_friction = 0.02;
    contact.impact_speed = 2.0;
    contact.steps_per_contact = 50;
    contact.walls = io::WallShape::primitive;
    contact.materials = {{"wall", 1e9 / 3.0, 0.2}};
    contact.pairs.resize(1);
    contact.pairs[0].between = {"-5", "wall"};
    contact.pairs[0].friction = 0.7;
    contact.pairs[0].cohesion = 0.1;
    return contact;
}

} // namespace

TEST_CASE("every scene in configs/ has no mistakes, and its resolved text reads back as the same scene")
{
    CHECK(shipped_scenes().size() >= 3);
    for (const auto& folder : shipped_scenes()) {
        CAPTURE(folder.string());
        const io::Scene scene = io::read_scene(folder);
        const auto [again, problems] = io::read_scene_text("resolved", io::scene_text(scene));
        CHECK(problems->text() == "");
        CHECK(again == scene);
    }
}

TEST_CASE("every value survives the resolved text")
{
    io::Scene scene = io::read_scene_text("scene.yaml", test_scene::good).scene;
    scene.name = "quotes \" \\ and: colons # ünïcode";
    scene.grid.pipe.reset();
    scene.grid.box = io::BoxGrid{{0.1, 1.0 / 3.0, 0.2}, {4, 6, 8}, {1, 2, 4}};
    scene.grid.periodic = {io::Axis::x, io::Axis::z};
    scene.fluid->material.name = "null";
    scene.fluid->boundaries.resize(2);
    scene.fluid->boundaries[0].at = "y_low";
    scene.fluid->boundaries[0].kind = io::BoundaryKind::slip;
    scene.fluid->boundaries[1].at = "y_high";
    scene.fluid->boundaries[1].velocity = core::Vec3(0.1, 0, 1.0 / 3.0);
    scene.fluid->drive.emplace();
    scene.fluid->drive->pressure_gradient = -3.0;
    scene.fluid->drive->axis = io::Axis::z;
    scene.fluid->drive->over_time.emplace();
    scene.fluid->drive->over_time->table = {{-1.0, 0.1}, {1.0 / 3.0, 0.2}};
    scene.fluid->drive->over_time->between = io::BetweenPoints::cubic;
    scene.fluid->drive->over_time->beyond = io::BeyondTable::hold;
    scene.gravity = io::Gravity{core::Vec3(1, 2, -2) / 3.0, 1.62};
    io::Species& sieved = scene.particles.emplace_back();
    sieved.name = "-5";
    sieved.count = 3;
    sieved.density = 2500.0;
    sieved.sizes.emplace();
    sieved.sizes->share_of = physics::ShareOf::number;
    sieved.sizes->sieve = {{1e-3 / 3.0, 0.0}, {2e-3, 1.0}};
    sieved.initial = {.arrangement = io::Arrangement::packed,
                      .region = {core::Vec3(0.02, 0.02, 0.02), core::Vec3(0.03, 0.04, 0.05), {}, {}},
                      .velocity = core::Vec3(0.0, -0.1, 1e-300),
                      .spacing = 0.99,
                      .overlaps = io::Overlaps::relax};
    scene.contact = some_contact();
    scene.coupling = io::Coupling{.mode = io::CouplingMode::iterated,
                                  .filter = {0.003, false},
                                  .preset = io::CouplingPreset::seed,
                                  .drag = io::DragLaw::tenneti,
                                  .magnus = io::MagnusLaw::rubinow_keller,
                                  .added_mass = io::AddedMass::zuber,
                                  .size_mixture = io::Switch::on,
                                  .lift = io::Switch::off,
                                  .shear_lift = io::Switch::on,
                                  .torque = io::Switch::on,
                                  .history = io::Switch::off,
                                  .own_disturbance = io::Switch::on};
    scene.run = {0.5, 2.0, 1e-3, {0.7}, 42, 3600.0};
    scene.output.results = {io::Interval::Clock::steps, 10.0};
    scene.output.pictures = {};
    scene.output.checkpoint = {io::Interval::Clock::wall, 60.0};
    scene.output.metrics = {};
    scene.output.keep_checkpoints = 5;
    scene.solver.tolerance = 1e-11;
    scene.resolve();
    const auto [again, problems] = io::read_scene_text("resolved", io::scene_text(scene));
    CHECK(problems->text() == "");
    CHECK(again == scene);
}

TEST_CASE("a key is explained by its path or its end, and a misspelled one is suggested")
{
    const std::string stiffness = io::explain("contact.stiffness");
    CHECK(io::explain("contact.steps_per_contact") == io::explain("steps_per_contact"));
    CHECK(stiffness.find("a quantity in N/m (> 0)") != std::string::npos);
    CHECK(io::explain("particles.density").find("required") != std::string::npos);
    CHECK(io::explain("restitution").find("default 0.6") != std::string::npos);
    CHECK(io::explain("particles.count") == io::explain("particles.*.count"));
    CHECK(io::explain("grid.pipe").find("grid.pipe.cells.across") != std::string::npos);
    CHECK_THROWS_WITH(static_cast<void>(io::explain("stifness")), "there is no key 'stifness'; did you mean 'stiffness'?");
}

TEST_CASE("every key says what it means")
{
    const auto keys = io::all_keys();
    CHECK(keys.size() > 70);
    for (const auto& key : keys) {
        CAPTURE(key.path);
        CHECK(key.meaning.size() > 4);
        CHECK(io::explain(key.path).starts_with(key.path + "\n"));
    }
}
