// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A vector on every face of one side of a block.
#include "core/base/vec3.hpp"
#include "core/grid/extents.hpp"
#include <algorithm>
#include <vector>

namespace physics {

class SideVectors {
public:
    /// The same on all faces.
    explicit SideVectors(const core::Vec3& everywhere = core::Vec3::Zero()) : values_{everywhere} {}
    /// @param value  Of the face with the indices (i, j, k), that along the side's axis being its own.
    template <class Value>
    SideVectors(core::Extents cells, core::Side side, Value value)
        : first_((core::axis_of(side) + 1) % 3), second_((core::axis_of(side) + 2) % 3), count_{cells[first_], cells[second_]}
    {
        core::Index3 face;
        face[core::axis_of(side)] = core::is_high(side) ? cells[core::axis_of(side)] : 0;
        for (face[second_] = 0; face[second_] < count_[1]; ++face[second_])
            for (face[first_] = 0; face[first_] < count_[0]; ++face[first_]) values_.push_back(value(face));
    }

    /// All of them times a factor.
    [[nodiscard]] SideVectors scaled(double factor) const
    {
        SideVectors result = *this;
        for (core::Vec3& v : result.values_) v *= factor;
        return result;
    }
    /// At a cell or face on the side; beyond the edges of the side, that of the nearest face.
    [[nodiscard]] const core::Vec3& operator[](core::Index3 at) const
    {
        if (values_.size() == 1) return values_.front();
        const int a = std::clamp(at[first_], 0, count_[0] - 1), b = std::clamp(at[second_], 0, count_[1] - 1);
        return values_[std::size_t(a) + std::size_t(count_[0]) * std::size_t(b)];
    }

private:
    int first_ = 0, second_ = 1;
    std::array<int, 2> count_{1, 1};
    std::vector<core::Vec3> values_;
};

} // namespace physics
