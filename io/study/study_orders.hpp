// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the runs of a study say together: orders of accuracy, and which of them nobody beats.
#include "io/study/study_run.hpp"
#include <optional>

namespace io {

/// Orders of one run; nothing where the study does not tell.
struct ObservedOrders {
    std::optional<double> h;  ///< from the errors of this run and of the next coarser cells
    std::optional<double> dt; ///< from the differences of this run and those with the next two larger steps
};

/// One for each run. Two runs are compared if all other choices are the same. Collective.
[[nodiscard]] std::vector<ObservedOrders> observed_orders(const std::vector<StudyRun>& runs, const core::Communicator& ranks);

/// The order p of a quantity at three decreasing steps with distances |q0 - q1| and |q1 - q2|; nothing if none fits.
[[nodiscard]] std::optional<double> order_from_differences(const std::array<double, 3>& steps, double first, double second);

/// Is there no run with both a smaller error and fewer core-seconds? One for each run; never a reference.
[[nodiscard]] std::vector<bool> pareto_front(const std::vector<StudyRun>& runs);

} // namespace io
