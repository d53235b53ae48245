// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Entry point of every test program: doctest inside MPI, so that a test may run on any number of ranks.
#define DOCTEST_CONFIG_IMPLEMENT
#include "core/base/floating_point_traps.hpp"
#include "core/comm/communicator.hpp"
#include <doctest/doctest.h>

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
    core::trap_floating_point_errors();
    doctest::Context context(argc, argv);
    return context.run();
}
