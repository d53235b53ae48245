// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Eight doubles that are worked on together: a whole cache line of a record, and eight records turned into columns and back.
#include "core/base/four.hpp"

namespace core {

using Eight = double __attribute__((vector_size(64)));

[[nodiscard]] inline Eight load_eight(const double* from)
{
    Eight value;
    std::memcpy(&value, from, sizeof(Eight));
    return value;
}

inline void store_eight(double* to, const Eight& value) { std::memcpy(to, &value, sizeof(Eight)); }

/// `low` and behind it `high`.
[[nodiscard]] inline Eight join(const Four& low, const Four& high) { return __builtin_shufflevector(low, high, 0, 1, 2, 3, 4, 5, 6, 7); }

/// Eight rows of eight become eight columns.
inline void transpose(Eight (&r)[8])
{
    Eight pair[8], quad[8];
    for (int k = 0; k < 8; k += 2) { // columns of two rows
        pair[k] = __builtin_shufflevector(r[k], r[k + 1], 0, 8, 2, 10, 4, 12, 6, 14);
        pair[k + 1] = __builtin_shufflevector(r[k], r[k + 1], 1, 9, 3, 11, 5, 13, 7, 15);
    }
    for (int k = 0; k < 8; k += 4) // columns a and a + 4 of four rows
        for (int odd = 0; odd < 2; ++odd) {
            quad[k + odd] = __builtin_shufflevector(pair[k + odd], pair[k + 2 + odd], 0, 1, 8, 9, 4, 5, 12, 13);
            quad[k + 2 + odd] = __builtin_shufflevector(pair[k + odd], pair[k + 2 + odd], 2, 3, 10, 11, 6, 7, 14, 15);
        }
    for (int k = 0; k < 4; ++k) {
        r[k] = __builtin_shufflevector(quad[k], quad[4 + k], 0, 1, 2, 3, 8, 9, 10, 11);
        r[4 + k] = __builtin_shufflevector(quad[k], quad[4 + k], 4, 5, 6, 7, 12, 13, 14, 15);
    }
}

} // namespace core
