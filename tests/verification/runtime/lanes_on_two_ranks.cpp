// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ctest: ranks=2 timeout=120
#include "tests/support/two_lanes_ranks.hpp"

TEST_CASE("two lanes that talk between two ranks give the bits of one rank, in any order and on one thread")
{
    support::check_two_lanes_on_all_ranks();
}
