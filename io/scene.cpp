// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene.hpp"

namespace io {

void Scene::resolve()
{
    if (grid.pipe && !grid.pipe->cells && !grid.pipe->size) grid.pipe->size = PipeSize::medium;
    if (fluid && !particles.empty() && !coupling) coupling.emplace();
}

} // namespace io
