// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/coupling/mode.hpp"
#include <doctest/doctest.h>

using namespace physics;

TEST_CASE("the first step is iterated, soft ones are pipelined, stiff ones iterated, and the scene's wish counts where it is stable")
{
    const StabilityNumbers soft{0.2, 3.0, 1.65, 0.6}, stiff{20.0, 3.0, 1.65, 0.6}, stiffer{200.0, 3.0, 1.65, 0.6};
    CHECK(mode_of_step({}, soft, 0).mode == Mode::iterated);
    CHECK(mode_of_step({}, soft, 1).mode == Mode::pipelined);
    CHECK(mode_of_step({}, stiff, 1).mode == Mode::iterated);
    CHECK(mode_of_step(Mode::pipelined, stiff, 1).mode == Mode::pipelined);
    CHECK(mode_of_step(Mode::pipelined, stiffer, 1).mode == Mode::iterated);
    CHECK(mode_of_step(Mode::iterated, soft, 1).mode == Mode::iterated);
    CHECK(mode_of_step({}, {0.2, 0.01, 0.01, 0.01, 50.0}, 1).mode == Mode::concurrent); // dilute, with stiff contacts
    CHECK(mode_of_step({}, {0.2, 0.01, 0.01, 0.01, 0.5}, 1).mode == Mode::pipelined);   // dilute, but nothing to wait for
    CHECK(mode_of_step({}, {0.2, 0.01, 0.01, 0.01, 0.5}, 1).reason.find("little to wait for") != std::string::npos);
    CHECK(mode_of_step({}, {0.1, 1200.0, 0.004, 0.6}, 1).mode == Mode::pipelined); // gas, but a bed that must come to rest
    CHECK(mode_of_step(Mode::concurrent, {0.1, 1200.0, 0.004, 0.6}, 1).mode == Mode::concurrent);
    CHECK(mode_of_step(Mode::coarse, soft, 1).mode == Mode::coarse);
    // What the user asks for and would be unstable is not made: the next step is iterated, and the reason says so.
    const ModeChoice refused = mode_of_step(Mode::concurrent, soft, 1);
    CHECK(refused.mode == Mode::iterated);
    CHECK(refused.reason.find("'concurrent' is unstable") != std::string::npos);
}
