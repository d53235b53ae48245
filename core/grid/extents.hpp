// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Integer boxes and the six sides of a block.
#include <array>
#include <cstddef>
#include <string_view>

namespace core {

using BlockId = int;

struct Index3 {
    int i = 0, j = 0, k = 0;
    [[nodiscard]] int operator[](int axis) const { return axis == 0 ? i : axis == 1 ? j : k; }
    [[nodiscard]] int& operator[](int axis) { return axis == 0 ? i : axis == 1 ? j : k; }
    bool operator==(const Index3&) const = default;
};

struct Extents {
    int ni = 0, nj = 0, nk = 0;
    /// Numbers that arrays with a halo keep behind it, for sub-faces (sub_face_values.hpp); not counted by size().
    int sub_face_values = 0;
    int sub_faces = 0; ///< on the sides of the block: what fields on faces keep beside them
    [[nodiscard]] std::ptrdiff_t size() const { return std::ptrdiff_t(ni) * nj * nk; }
    [[nodiscard]] int operator[](int axis) const { return axis == 0 ? ni : axis == 1 ? nj : nk; }
    [[nodiscard]] bool contains(Index3 c) const { return c.i >= 0 && c.j >= 0 && c.k >= 0 && c.i < ni && c.j < nj && c.k < nk; }
    bool operator==(const Extents& e) const { return ni == e.ni && nj == e.nj && nk == e.nk; }
};

/// A side of a block: 2 * axis + (0 low, 1 high).
enum class Side { i_low, i_high, j_low, j_high, k_low, k_high };
inline constexpr std::array<Side, 6> all_sides{Side::i_low, Side::i_high, Side::j_low, Side::j_high, Side::k_low, Side::k_high};
inline constexpr std::array<std::string_view, 6> side_words{"i_low", "i_high", "j_low", "j_high", "k_low", "k_high"};
[[nodiscard]] constexpr int axis_of(Side s) { return static_cast<int>(s) / 2; }
[[nodiscard]] constexpr bool is_high(Side s) { return static_cast<int>(s) % 2 == 1; }
[[nodiscard]] constexpr Side side_of(int axis, bool high) { return static_cast<Side>(2 * axis + (high ? 1 : 0)); }

/// Calls body(i, j, k) for every cell of the box [low, high), i fastest.
template <class Body>
void for_each(Index3 low, Index3 high, Body body)
{
    for (int k = low.k; k < high.k; ++k)
        for (int j = low.j; j < high.j; ++j)
            for (int i = low.i; i < high.i; ++i) body(i, j, k);
}

template <class Body>
void for_each_cell(Extents cells, Body body)
{
    for_each({0, 0, 0}, {cells.ni, cells.nj, cells.nk}, body);
}

} // namespace core
