// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// A checkpoint is the same for any number of ranks, and failures are seen by all of them.
// ctest: ranks=4 timeout=120
#include "core/base/error.hpp"
#include "tests/support/sample_state.hpp"
#include "tests/support/shared_folder.hpp"

#include <doctest/doctest.h>

#include <csignal>
#include <fstream>
#include <sys/resource.h>

using support::State;
namespace fs = std::filesystem;

TEST_CASE("written by all and read by one, or the other way round: the same state")
{
    const auto world = core::Communicator::world(), self = core::Communicator::self();
    const support::SharedFolder shared(world);
    const std::string &folder = shared.path(), own = folder + "/" + std::to_string(world.rank());
    const State whole = support::whole_state(2.0);
    State share = support::share_of_state(world);
    share.fill(2.0, world.rank(), world.size());
    CHECK(share.digest(7, world) == whole.digest(7, self));

    const std::string together = share.write(folder, 7, world), alone = whole.write(own, 7, self);
    CHECK(io::CheckpointReader(together, self).digest() == whole.digest(7, self));
    CHECK(io::newest_good_checkpoint(folder, world).path == together);

    State read_alone({{4, 3, 2, 1, 0}, support::block_total});
    read_alone.read(together, self);
    CHECK(read_alone.digest(7, self) == whole.digest(7, self));

    State read_together = support::share_of_state(world);
    read_together.read(folder + "/0/" + fs::path(alone).filename().string(), world);
    CHECK(read_together.digest(7, world) == whole.digest(7, self));
}

TEST_CASE("a full disk is an error on all ranks, and the checkpoint before it stays")
{
    const auto world = core::Communicator::world();
    const support::SharedFolder shared(world);
    const std::string& folder = shared.path();
    State share = support::share_of_state(world);
    share.fill(2.0, world.rank(), world.size());
    const std::string good = share.write(folder, 1, world);
    rlimit old{};
    ::getrlimit(RLIMIT_FSIZE, &old);
    std::signal(SIGXFSZ, SIG_IGN);
    for (const rlim_t bytes : {1'000, 100'000, 300'000}) { // a limit on the size of files acts like a full disk
        const rlimit small{bytes, old.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &small);
        CHECK_THROWS_AS((void)share.write(folder, 2, world), core::FileError);
        ::setrlimit(RLIMIT_FSIZE, &old);
        const auto choice = io::newest_good_checkpoint(folder, world);
        CHECK(choice.path == good);
        CHECK(choice.refused.empty());
    }
    CHECK_NOTHROW((void)share.write(folder, 3, world));
}

TEST_CASE("a folder that cannot be made is an error on all ranks")
{
    const auto world = core::Communicator::world();
    const support::SharedFolder shared(world);
    const std::string& folder = shared.path();
    if (world.rank() == 0) std::ofstream(folder + "/file") << "x";
    world.barrier();
    CHECK_THROWS_AS(io::CheckpointWriter(folder + "/file/below", 1, world), core::FileError);
}
