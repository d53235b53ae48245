// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Everything that a run writes while it goes on, each when it is due.
#include "io/log.hpp"
#include "io/progress.hpp"
#include "io/run_directory.hpp"
#include "io/world.hpp"
#include <chrono>

namespace io {

class SimulationOutputs {
public:
    /// @param resumed  Goes on with the files of an earlier run. Collective.
    SimulationOutputs(World& world, const RunDirectory& directory, Log& log, bool resumed);
    ~SimulationOutputs();

    /// Whatever is due at the present step. Collective.
    void write_due();
    /// The last checkpoint, and the end of all files. Collective.
    void finish();
    [[nodiscard]] StepReport step_report() const;

private:
    void checkpoint();
    [[nodiscard]] bool checkpoint_is_due();

    World& world_;
    RunDirectory directory_;
    Log& log_;
    std::chrono::steady_clock::time_point last_checkpoint_ = std::chrono::steady_clock::now();
    double last_checkpoint_time_ = 0;
    std::int64_t last_saved_step_ = -1;
};

} // namespace io
