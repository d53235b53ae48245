// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs the cases of a study in this process and measures what each costs and how far off it is.
#include "io/study/study.hpp"
#include "io/study/study_error.hpp"
#include <functional>

namespace io {

/// Who computes.
struct StudyResources {
    std::string executor = "auto";
    int threads = 1;
};

/// What came of one case.
struct StudyRun {
    std::vector<int> choice;
    std::vector<std::string> labels;
    int ranks = 1, threads = 1;
    long cells = 0, particles = 0, steps = 0;
    double h = 0;          ///< edge of a cell: over the section of a pipe, over the volume of a box [m]
    double dt = 0;         ///< mean time step [s]
    double tolerance = 0;  ///< of the pressure
    double iterations = 0; ///< of the pressure, mean over the steps
    double wall = 0;       ///< real time of the stepping alone [s]
    double processor = 0;  ///< processor time of all threads and ranks in it [s]
    ErrorNorms error;
    bool is_reference = false; ///< its error is not known
    std::vector<double> trace; ///< of this rank; see study_error.hpp
    std::vector<std::string> warnings;
    std::vector<std::string> metrics;         ///< of an ensemble: names of
    std::vector<double> at_start, at_the_end; ///< their values

    [[nodiscard]] double core_seconds() const { return wall * ranks * threads; }
    [[nodiscard]] double cell_steps_per_second() const { return double(cells) * double(steps) / wall; }
};

/// Runs all cases. Collective.
/// @param told  Is called with every run as it is done.
[[nodiscard]] std::vector<StudyRun> run_study(const StudyPlan& plan, const core::Communicator& ranks, const StudyResources& resources,
                                              const std::function<void(const StudyRun&)>& told);

} // namespace io
