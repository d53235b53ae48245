// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/ending.hpp"

#include <mpi.h>

#include <chrono>
#include <cstdlib>
#include <thread>

namespace core {

bool all_arrive_within(const Communicator& ranks, double seconds)
{
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(*static_cast<const MPI_Comm*>(ranks.native()), &request);
    for (int done = 0; done == 0;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done != 0) break;
        if (Clock::now() > deadline) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return true;
}

void abort_all_ranks(int exit_code)
{
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::_Exit(exit_code);
}

} // namespace core
