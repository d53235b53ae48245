// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What may run at the same time, read from a plan and not from clocks.
#include "tasks/plan.hpp"
#include <string_view>

namespace tasks {

/// Kept stages of other lanes that may run while the first kept stage called `stage` does: no path of dependencies leads from
/// any of its tasks to any of theirs, nor back. In the order of the text, each name once.
[[nodiscard]] std::vector<std::string> stages_beside(const Plan& plan, std::string_view stage);

} // namespace tasks
