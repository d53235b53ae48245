// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How far a run of a study is from the truth: watches the run without being part of its time.
#include "io/run/world.hpp"
#include "io/run/world_metrics.hpp"
#include "io/study/study.hpp"
#include "physics/fluid/womersley.hpp"

namespace io {

/// Errors relative to the size of what is measured: root mean square and largest.
struct ErrorNorms {
    double e_2 = 0.0, e_inf = 0.0;
};

/// Axial velocity against the exact oscillating flow, over all cells and all steps of the last period.
class WomersleyError {
public:
    /// Starts the world from the exact flow. Collective.
    WomersleyError(World& world, int periods);
    /// Collective.
    void after_step();
    /// Collective.
    [[nodiscard]] ErrorNorms norms() const;
    /// The axial velocity at the end, in the cells of this rank: compared from step to step size, it tells the order in time.
    [[nodiscard]] std::vector<double> trace() const;

private:
    World& world_;
    double start_;                                         ///< of the last period [s]
    std::vector<std::vector<std::complex<double>>> exact_; ///< amplitude in each cell of each own block
    double squares_ = 0, exact_squares_ = 0, worst_ = 0, largest_ = 0;
};

/// Mean heights and the speed on the axis at twenty equal times of a run.
class SampledCurves {
public:
    explicit SampledCurves(World& world);
    /// Collective.
    void after_step();
    /// Sample by sample.
    [[nodiscard]] const std::vector<double>& trace() const { return trace_; }

private:
    [[nodiscard]] std::vector<double> values() const;
    World& world_;
    std::vector<MetricGroup> groups_;
    std::vector<double> before_;
    double time_before_ = 0;
    std::vector<double> trace_;
    int next_ = 1;
};

/// Of two runs of equal length; relative to the largest value of the reference.
[[nodiscard]] ErrorNorms difference(const std::vector<double>& trace, const std::vector<double>& reference);

} // namespace io
