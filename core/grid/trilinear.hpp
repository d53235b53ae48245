// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The trilinear map of one cell, from [0, 1]^3 to space, and its inverse by Newton.
#include "core/grid/multi_block.hpp"
#include <optional>

namespace core {

class TrilinearCell {
public:
    TrilinearCell(const Vertices& vertices, Index3 cell);
    [[nodiscard]] Vec3 position(const Vec3& xi) const;
    [[nodiscard]] Mat3 jacobian(const Vec3& xi) const;
    /// xi with position(xi) = x, which may lie outside [0, 1]^3; nothing if Newton does not converge.
    [[nodiscard]] std::optional<Vec3> inverse(const Vec3& x, Vec3 xi) const;

private:
    /// Coefficients of 1, u, v, w, uv, vw, wu, uvw.
    std::array<Vec3, 8> c_;
};

} // namespace core
