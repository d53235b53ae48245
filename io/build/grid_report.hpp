// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The grid of a scene in words: its blocks, what lies beyond each of their sides, and its boundaries.
#include "core/grid/mesh.hpp"

namespace io {

/// Lines of text without an end of line after the last. Of many blocks only the first are shown one by one.
[[nodiscard]] std::string grid_report(const core::Mesh& mesh);

} // namespace io
