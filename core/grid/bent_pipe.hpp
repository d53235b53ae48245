// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A round pipe along any sequence of straight pieces and circular arcs: the butterfly section carried along without twist.
#include "core/grid/butterfly.hpp"
#include "core/grid/multi_block.hpp"

namespace core {

/// A straight piece, or an arc.
struct PipePiece {
    double length = 0;           ///< along the axis, of a straight piece [m]
    double angle = 0;            ///< of an arc [rad]; 0: the piece is straight
    double radius = 0;           ///< of the axis of an arc [m]
    Vec3 towards = Vec3::Zero(); ///< side to which an arc bends; only its part normal to the axis counts
    int cells = 8;               ///< along the axis
    int blocks = 1;              ///< that the piece is cut into
};

struct BentPipe : Butterfly {
    std::vector<PipePiece> pieces; ///< the first begins at the origin and runs along x
    bool periodic = false;         ///< The two ends are the same place; they must look the same way.
};

/// Five blocks in each section, section after section. Boundary names: wall, start, end.
/// @throws ConfigError if cells do not divide into blocks, an arc is tighter than the pipe, or periodic ends differ.
[[nodiscard]] MultiBlock make_bent_pipe(const BentPipe& pipe);

} // namespace core
