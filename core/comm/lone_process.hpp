// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Spares a process that runs alone, without mpirun, what MPI does at its start to find networks: half of the time that it takes to start.
#include <vector>

namespace core {

/// Tells Open MPI and hwloc through the environment to look for no network while this lives, unless something has started the process
/// together with others, or the environment already says what to use.
class LoneProcess {
public:
    LoneProcess();
    ~LoneProcess();
    LoneProcess(const LoneProcess&) = delete;
    LoneProcess& operator=(const LoneProcess&) = delete;

private:
    std::vector<const char*> said_; ///< variables to be taken back, lest programs that are started from here inherit them
};

} // namespace core
