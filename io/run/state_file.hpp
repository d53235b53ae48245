// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The state of a world to and from checkpoints: everything that the next step reads, and nothing else.
#include "io/files/checkpoint.hpp"
#include "io/run/world.hpp"

namespace io {

/// Writes a checkpoint. Collective. @return its path. @throws core::FileError on all ranks.
std::string save_state(World& world, const std::string& directory, int keep);

/// Sets the state of a world that was made from the same scene, on any number of ranks. Collective.
/// @throws core::FileError if the checkpoint lacks something or belongs to another scene.
void load_state(const CheckpointReader& checkpoint, World& world);

} // namespace io
