// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A run from a scene to its results: settle, step, write, stop.
#include "io/run/log.hpp"
#include "io/run/run_directory.hpp"
#include "io/run/simulation_outputs.hpp"
#include "io/run/stop_requests.hpp"
#include "io/run/world.hpp"
#include "tasks/trace.hpp"

namespace io {

struct SimulationOptions {
    std::filesystem::path directory;
    RunDirectory::Existing existing = RunDirectory::Existing::refuse;
    std::string executor = "auto";
    int threads = 1;
    bool trace = false;
    std::optional<double> until;      ///< where to end instead of scene.run.until [s]; no step is longer or shorter for it
    std::vector<std::string> command; ///< for the manifest
};

class Simulation {
public:
    /// Makes the run directory and the world; reads the newest good checkpoint when the run is resumed. Collective.
    Simulation(const Scene& scene, const core::Communicator& ranks, const SimulationOptions& options);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;
    ~Simulation();

    /// Runs to the end, or to the step at which somebody asked to stop; the state is in a checkpoint then.
    /// @return why it stopped, or none at the end.
    /// @throws core::Error on all ranks alike if a step fails; the state before it is in a checkpoint then.
    StopReason run();

    [[nodiscard]] World& world() { return world_; }

private:
    Simulation(const Scene& scene, core::MultiBlock blocks, const core::Communicator& ranks, const SimulationOptions& options);
    void resume();
    void settle();
    StopReason stop_early();
    void step();
    void report_plan();

    SimulationOptions options_;
    core::Communicator ranks_;
    RunDirectory directory_;
    Console console_;
    Log log_;
    StopRequests requests_;
    World world_;
    StopReason early_stop_ = StopReason::none; ///< asked for while the grains settled
    tasks::Trace trace_;
    std::unique_ptr<tasks::Executor> executor_;
    std::unique_ptr<SimulationOutputs> outputs_;
};

} // namespace io
