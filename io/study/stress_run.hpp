// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Runs stress cases and judges them.
#include "io/study/stress_case.hpp"

namespace io {

/// What one criterion of one variant came to.
struct StressVerdict {
    std::string stress_case, variant, criterion;
    std::string measured, bound;
    bool passed = false;
};

/// Runs all variants of a case on this process alone. Errors of the run are verdicts, too.
[[nodiscard]] std::vector<StressVerdict> run_stress_case(const StressCase& stress);

/// One line for each verdict.
[[nodiscard]] std::string table_text(const std::vector<StressVerdict>& verdicts);

} // namespace io
