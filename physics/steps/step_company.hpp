// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Stages of others in the step of fluid and grains: turbulence, scalars.
#include "tasks/stage_graph.hpp"
#include <functional>

namespace physics {

/// Declared in the lane of the fluid, where it begins a step and where its new velocity is known.
struct StepCompany {
    std::function<void(tasks::StageGraph&)> before, after;
};

} // namespace physics
