// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How wide hats over the cell centres spread what a grain deposits.

namespace physics {

/// Mean over the directions of the square of the width of a cell, and of its share that the hats between two centres spread over [m2].
struct GridSpread {
    double cell = 0.0;
    double hat = 0.0; ///< part (1 - part) of each direction times the square
};

} // namespace physics
