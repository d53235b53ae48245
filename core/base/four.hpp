// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Four doubles that are worked on together: records of particles and contacts, turned into columns and back. The functions
// that take a double as well let one formula serve both.
#include <cmath>
#include <cstring>

namespace core {

using Four = double __attribute__((vector_size(32)));

[[nodiscard]] inline Four load_four(const double* from)
{
    Four value;
    std::memcpy(&value, from, sizeof(Four));
    return value;
}

inline void store_four(double* to, const Four& value) { std::memcpy(to, &value, sizeof(Four)); }

[[nodiscard]] inline Four lesser(const Four& a, const Four& b) { return a < b ? a : b; }
[[nodiscard]] inline Four greater(const Four& a, const Four& b) { return a > b ? a : b; }
[[nodiscard]] inline Four square_root(const Four& a) { return Four{std::sqrt(a[0]), std::sqrt(a[1]), std::sqrt(a[2]), std::sqrt(a[3])}; }
[[nodiscard]] inline double lesser(double a, double b) { return a < b ? a : b; }
[[nodiscard]] inline double greater(double a, double b) { return a > b ? a : b; }
[[nodiscard]] inline double square_root(double a) { return std::sqrt(a); }

/// Four rows of four become four columns.
inline void transpose(Four& a, Four& b, Four& c, Four& d)
{
    const Four ab_even = __builtin_shufflevector(a, b, 0, 4, 2, 6), ab_odd = __builtin_shufflevector(a, b, 1, 5, 3, 7);
    const Four cd_even = __builtin_shufflevector(c, d, 0, 4, 2, 6), cd_odd = __builtin_shufflevector(c, d, 1, 5, 3, 7);
    a = __builtin_shufflevector(ab_even, cd_even, 0, 1, 4, 5);
    b = __builtin_shufflevector(ab_odd, cd_odd, 0, 1, 4, 5);
    c = __builtin_shufflevector(ab_even, cd_even, 2, 3, 6, 7);
    d = __builtin_shufflevector(ab_odd, cd_odd, 2, 3, 6, 7);
}

} // namespace core
