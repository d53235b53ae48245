// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The forces of the fluid on the particles of a scene: what acts, what is left out, and how much that could be.
#include "io/scene/scene.hpp"
#include <string>

namespace io {

/// One line for each term, with the bound of what is left out (NUMERICS E). @pre scene.fluid and particles
[[nodiscard]] std::string force_report(const Scene& scene);

} // namespace io
