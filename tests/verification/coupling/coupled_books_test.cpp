// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: timeout=300
// The books of momentum of a pipe with everything on: every line is measured by itself, and together they explain each step.
#include "io/run/momentum_ledger.hpp"
#include "io/run/world.hpp"
#include "tests/support/relative.hpp"
#include "tests/support/scene_from_text.hpp"
#include <cstdio>
#include <doctest/doctest.h>

namespace {

using core::Vec3;

io::Scene pipe(const std::string& coupling)
{
    return test::small_pipe("pressure_gradient: 20 kPa/m, reverse_at: { axis_speed: 0.5 m/s }", coupling);
}

const std::string all_on = "added_mass: on, lift: on, torque: on";

} // namespace

TEST_CASE("drive, weight, walls, advection and what is owed explain all change of momentum, each line measured by itself")
{
    for (const std::string& coupling : {all_on, all_on + ", mode: coarse", all_on + ", mode: concurrent", all_on + ", mode: iterated"}) {
        io::World world(pipe(coupling), core::Communicator::self());
        world.settle(core::SerialTeam());
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        io::MomentumLedger books(world);
        double defect = 0, exchange = 0, couple = 0;
        std::vector<double> largest(io::MomentumImpulses::outer_lines().size());
        for (int step = 0; step < 60; ++step) {
            world.step(*executor);
            books.update();
            defect = std::max(defect, books.defect());
            exchange = std::max(exchange, books.exchange_defect());
            couple = std::max(couple, books.impulses().couple.norm());
            for (std::size_t n = 0; n < largest.size(); ++n) {
                const auto& line = io::MomentumImpulses::outer_lines()[n];
                largest[n] = std::max(largest[n], (books.impulses().*line.impulse).norm());
            }
        }
        std::printf("%s: unexplained %.1e, exchange %.1e, couples %.1e N m s; largest impulses:", coupling.c_str(), defect, exchange,
                    couple);
        for (std::size_t n = 0; n < largest.size(); ++n) std::printf(" %s %.1e", io::MomentumImpulses::outer_lines()[n].name, largest[n]);
        std::printf(" N s\n");
        // What is left is the solver's share of the viscous change, 1e-8 of it, and rounding.
        CHECK(defect < 1e-9);
        CHECK(exchange < 1e-12);
        CHECK(couple > 0);
    }
}

TEST_CASE("a line of the books that is left out or wrong is noticed")
{
    io::World world(pipe(all_on), core::Communicator::self());
    world.settle(core::SerialTeam());
    const auto executor = tasks::make_executor({"serial"}, world.compile());
    io::MomentumLedger books(world);
    std::vector<double> without(io::MomentumImpulses::outer_lines().size());
    for (int step = 0; step < 20; ++step) {
        world.step(*executor);
        books.update();
        for (std::size_t n = 0; n < without.size(); ++n) {
            const auto& line = io::MomentumImpulses::outer_lines()[n];
            without[n] = std::max(without[n], books.defect(books.impulses().outer() - books.impulses().*line.impulse));
        }
    }
    for (std::size_t n = 0; n < without.size(); ++n) {
        const std::string name = io::MomentumImpulses::outer_lines()[n].name;
        INFO("without ", name);
        const bool is_of_open_domains = name == "traffic" || name == "through"; // traffic_two_ranks has those
        CHECK((without[n] > 1e-6) != is_of_open_domains);
    }
    SUBCASE("fluid that gains a tenth of a per cent from nowhere")
    {
        world.step(*executor);
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            for (double& u : world.fluid()->state().velocity.data(b, 0)) u *= 1.001;
        books.update();
        CHECK(books.defect() > 1e-6);
    }
    SUBCASE("friction that is not what was applied")
    {
        world.step(*executor);
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            for (double& u : world.fluid()->fields().predicted.data(b, 0)) u *= 1.1;
        books.update();
        CHECK(books.defect() > 1e-6);
    }
    SUBCASE("a grain that is pushed by nobody")
    {
        world.step(*executor);
        world.grains()->particles.velocity[1][0] += 0.01;
        books.update();
        CHECK(books.defect() > 1e-6);
        CHECK(books.exchange_defect() > 1e-6);
    }
}

TEST_CASE("lift pushes the fluid as it pushes the grains, and torque is recorded as what the fluid does not lose")
{
    const auto run = [](const char* lift) {
        io::World world(pipe(std::string("added_mass: off, torque: on, lift: ") + lift), core::Communicator::self());
        const auto executor = tasks::make_executor({"serial"}, world.compile());
        auto& p = world.grains()->particles;
        for (double& w : p.spin[2]) w = 200.0; // [1/s]
        io::MomentumLedger books(world);
        double spin = 0, couple = 0, contact = 0;
        for (int i = 0; i < p.owned; ++i) spin -= p.inertia[std::size_t(i)] * 200.0;
        for (int step = 0; step < 5; ++step) {
            world.step(*executor);
            books.update();
            CHECK(books.exchange_defect() < 1e-12);
            couple += books.impulses().couple.z();
            const int twist = world.coupling()->exchange().wet_columns().twist + 2;
            for (int i = 0; i < p.owned; ++i) contact += p.columns[std::size_t(twist)][std::size_t(i)];
        }
        for (int i = 0; i < p.owned; ++i) spin += p.inertia[std::size_t(i)] * p.spin[2][std::size_t(i)];
        // All change of spin is the fluid's couple or the contacts': a sum of some hundred rounded terms.
        CHECK(couple < 0);
        CHECK(spin == test::relative(couple + contact).epsilon(1e-10));
        return books.totals().grains;
    };
    CHECK((run("on") - run("off")).norm() > 1e-9); // lift does act [N s]
}
