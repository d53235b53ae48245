// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the fluid carries through the boundaries of a coupled world.
#include "io/run/world.hpp"

namespace io {

/// Sum of flux and velocity through the boundaries of a block in the last step, inward, as the advection of the scene has it [m4/s2].
/// @pre world.coupling()
[[nodiscard]] core::Vec3 momentum_through(World& world, core::LocalBlock b);

} // namespace io
