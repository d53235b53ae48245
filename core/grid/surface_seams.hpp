// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Closes a surface where flat walls of blocks meet whose points do not match.
#include "core/grid/surface.hpp"

namespace core {

/// Vertices of others that lie on an edge of a quadrilateral become its own, which is cut into triangles.
void close_seams(Surface& surface);

} // namespace core
