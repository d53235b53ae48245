// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/build/placement_room.hpp"
#include "io/scene/scene.hpp"

namespace io {

void Scene::resolve()
{
    if (grid.pipe && !grid.pipe->cells && !grid.pipe->size) grid.pipe->size = PipeSize::medium;
    if (fluid && !particles.empty() && !coupling) coupling.emplace();
    for (Species& species : particles)
        if (species.volume_fraction) {
            species.count = filling_count(*this, species);
            species.volume_fraction.reset();
        }
}

} // namespace io
