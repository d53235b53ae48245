// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Which stages may run while the grains move: what each coupling mode promises, read from the graph and not from clocks.
#include "tasks/overlap.hpp"
#include "tests/support/coupled_run.hpp"
#include <algorithm>
#include <doctest/doctest.h>

using namespace test;

namespace {

std::vector<std::string> beside_moving_grains(io::CouplingMode mode, io::AdvectionScheme advection = io::AdvectionScheme::lcsi)
{
    CoupledBox box;
    box.blocks = {2, 1, 1};
    box.gravity = {0, -9.81, 0};
    box.viscosity = 1e-5;
    box.mode = mode;
    io::Scene scene = scene_of(box, 40);
    scene.coupling->lift = io::Switch::on;
    scene.fluid->advection = advection;
    io::World world(scene, core::Communicator::self());
    return tasks::stages_beside(world.compile(), "move grains");
}

bool contains(const std::vector<std::string>& names, const char* name) { return std::ranges::find(names, name) != names.end(); }

} // namespace

TEST_CASE("in coarse and concurrent the fluid predicts, projects and answers while the grains move")
{
    for (const auto& [mode, assumed] : {std::pair(io::CouplingMode::coarse, "move grains with longer sub-steps"),
                                        std::pair(io::CouplingMode::concurrent, "fly grains held back")}) {
        const auto beside = beside_moving_grains(mode);
        for (const char* stage : {assumed, "sum over assumed grains", "predict with grains", "solve pressure with grains",
                                  "correct velocity with grains", "correct pressure with grains", "filter answer for grains"}) {
            INFO(stage);
            CHECK(contains(beside, stage));
        }
        // What is owed on both sides needs both.
        CHECK(!contains(beside, "ledger"));
        CHECK(!contains(beside, "owe grains"));
    }
}

TEST_CASE("in pipelined and iterated advection and viscosity run while the grains move, and the projection waits")
{
    for (const io::CouplingMode mode : {io::CouplingMode::pipelined, io::CouplingMode::iterated}) {
        const auto beside = beside_moving_grains(mode);
        CHECK(contains(beside, "advected velocity"));
        CHECK(!contains(beside, "solve pressure with grains"));
        CHECK(!contains(beside, "filter answer for grains"));
    }
}

TEST_CASE("finite volumes carry the fluid while the grains move, in every mode, and agree with them afterwards")
{
    for (const io::CouplingMode mode : every_mode) {
        const auto beside = beside_moving_grains(mode, io::AdvectionScheme::finite_volume);
        CHECK(contains(beside, "advect velocity between grains"));
        CHECK(!contains(beside, "make the flux agree with the grains"));
    }
}
