// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A state with a value that is no finite number, or with a grain outside, is not a state: found before anything else sees it.
#include "io/run/world.hpp"

namespace io {

/// Looks at all fields that are carried from step to step and at motion and places of all grains. Collective.
/// @throws core::NumericsError on all ranks, with field, block, cell and time, or the grain, of the first that is bad.
void require_finite(World& world);

} // namespace io
