// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Several cell fields that are always treated alike: deposited, filtered, exchanged in one go.
#include "core/field/field.hpp"

namespace core {

/// `N` numbers in each cell, stored as N arrays.
template <std::size_t N>
class FieldBatch : public FieldStorage<N> {
public:
    FieldBatch(FieldInfo info, std::span<const Extents> cells) : FieldStorage<N>(std::move(info), shapes(cells)) {}
    [[nodiscard]] std::array<View<double>, N> on(LocalBlock b)
    {
        std::array<View<double>, N> views;
        for (std::size_t a = 0; a < N; ++a) views[a] = this->block(b)[a].view();
        return views;
    }
    [[nodiscard]] std::array<View<const double>, N> on(LocalBlock b) const
    {
        std::array<View<const double>, N> views;
        for (std::size_t a = 0; a < N; ++a) views[a] = this->block(b)[a].view();
        return views;
    }

private:
    static std::vector<std::array<Extents, N>> shapes(std::span<const Extents> cells)
    {
        std::vector<std::array<Extents, N>> all;
        for (const Extents e : cells) all.emplace_back().fill(e);
        return all;
    }
};

} // namespace core
