// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The inside of a block from its six sides by transfinite interpolation.
#include "core/grid/multi_block.hpp"

namespace core {

/// Sets the inner vertices of a block from those of its sides: sums over faces less edges plus corners, linear in the index.
void fill_transfinite(Vertices& block);

} // namespace core
