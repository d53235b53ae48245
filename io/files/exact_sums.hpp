// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Sums over particles whose bits depend neither on the order of the particles nor on the ranks that have them.
#include "core/comm/communicator.hpp"

namespace io {

/// The sum of each column over the values of all ranks. Values are counted in units of 2^-80 of a power of two above the
/// largest, so integer sums carry them; what is smaller is cut off. Up to eight million values in a column. Collective.
[[nodiscard]] std::vector<double> exact_sums(const core::Communicator& ranks, const std::vector<std::vector<double>>& columns);

} // namespace io
