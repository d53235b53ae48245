// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sub-faces too small to carry a flux of their own.
#include "core/grid/side_overlap.hpp"

namespace core {

/// Gives sub-faces that are smaller than `smallest` of their faces to the largest neighbour on the same face of the master.
void merge_slivers(const SideTiling& master, const SideTiling& other, double smallest, SideOverlap& result);

} // namespace core
