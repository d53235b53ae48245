// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The symmetric matrices of the least-squares gradient in the cells of a block.
#include "core/grid/geometry.hpp"

namespace core {

/// @param geometry  Its cell centres are read.
/// @param part      By side: do the values beyond it take part? Beyond boundaries that do, they are taken as mirrored about the
///                  value on the boundary; beyond those that do not, they must be as inside.
[[nodiscard]] GradientMatrices gradient_matrices(const BlockGeometry& geometry, const std::array<bool, 6>& part);

} // namespace core
