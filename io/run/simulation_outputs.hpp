// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Everything that a run writes while it goes on, each when it is due.
#include "io/run/interval_clock.hpp"
#include "io/run/log.hpp"
#include "io/run/progress.hpp"
#include "io/run/run_directory.hpp"
#include "io/run/world_metrics.hpp"
#include "io/run/world_pictures.hpp"
#include "io/run/world_profile.hpp"
#include "io/run/world_results.hpp"

namespace io {

class SimulationOutputs {
public:
    /// @param resumed  Goes on with the files of an earlier run. @pre world.compile(). Collective.
    SimulationOutputs(World& world, const RunDirectory& directory, Log& log, bool resumed);

    /// Whatever is due now. Collective.
    void write_due();
    /// Whatever is due after a step. Collective.
    void after_step();
    /// The last checkpoint, and the end of all files. Collective.
    void finish();
    [[nodiscard]] StepReport step_report() const;

private:
    void checkpoint();
    [[nodiscard]] Moment now() const;

    World& world_;
    RunDirectory directory_;
    Log& log_;
    IntervalClock metrics_clock_, results_clock_, pictures_clock_, checkpoint_clock_;
    WorldMetrics metrics_;
    std::optional<WorldResults> results_;   ///< none where they are never due
    std::optional<WorldProfile> profile_;   ///< if it is measured
    std::optional<WorldPictures> pictures_; ///< likewise
    std::int64_t last_saved_step_ = -1;
};

} // namespace io
