// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a stage does with its resources. The kernel gets exactly this: read-only where the stage only reads.
#include "tasks/resource.hpp"
#include <tuple>

namespace tasks {

enum class Mode {
    read,        ///< the values of the block, and its halo if declared with halo()
    write,       ///< every value is new: what was there before does not matter
    update,      ///< old values are read, new ones written
    update_halo, ///< reads the interior, sets values in the halo: boundary conditions
};

template <Resource R, Mode M>
struct Access {
    R* resource;
    core::HaloReach halo{}; ///< what the kernel reads around the block
    static constexpr Mode mode = M;
    using Type = R;

    /// The resource, const where it is only read.
    [[nodiscard]] auto& bound() const
    {
        if constexpr (M == Mode::read) return std::as_const(*resource);
        else return *resource;
    }
    /// What the kernel of an each_block stage gets for block b.
    [[nodiscard]] decltype(auto) on(LocalBlock b) const
    {
        if constexpr (Divided<R>) return bound().on(b);
        else return whole();
    }
    /// What the kernel of a whole stage gets.
    [[nodiscard]] auto& whole() const
    {
        if constexpr (Holder<R>) return bound().get();
        else return bound();
    }
};

/// A field that is read together with layers of its neighbours' cells.
template <Resource R>
struct WithHalo {
    R& resource;
    core::HaloReach reach;
};

/// reads(halo(u, 2)): the stage reads u and two layers around each block, edges and corners too; the graph fills them when
/// they are stale.
template <Resource R>
[[nodiscard]] WithHalo<R> halo(R& field, int width)
{
    static_assert(has_halo<R>, "only a ScalarField, VectorField or TensorField has a halo");
    return {field, {width, core::HaloShape::full}};
}

/// reads(beside(u)): the stage reads u and the cells straight beyond the sides of each block.
template <Resource R>
[[nodiscard]] WithHalo<R> beside(R& field)
{
    static_assert(has_halo<R>, "only a ScalarField, VectorField or TensorField has a halo");
    return {field, core::beside};
}

/// reads(hats(u)): the stage samples u at the places of grains.
template <Resource R>
[[nodiscard]] WithHalo<R> hats(R& field)
{
    static_assert(has_halo<R>, "only a ScalarField, VectorField or TensorField has a halo");
    return {field, {1, core::HaloShape::hats}};
}

namespace detail {

template <Mode M, Resource R>
[[nodiscard]] Access<R, M> access(R& resource)
{
    return {&resource, {}};
}

template <Mode M, Resource R>
[[nodiscard]] Access<R, M> access(WithHalo<R> field)
{
    static_assert(M != Mode::write && M != Mode::update_halo, "the graph fills halos: a stage can only read them");
    return {&field.resource, field.reach};
}

} // namespace detail

template <class... Resources>
[[nodiscard]] auto reads(Resources&&... resources)
{
    return std::tuple{detail::access<Mode::read>(resources)...};
}

template <class... Resources>
[[nodiscard]] auto writes(Resources&&... resources)
{
    return std::tuple{detail::access<Mode::write>(resources)...};
}

template <class... Resources>
[[nodiscard]] auto updates(Resources&&... resources)
{
    return std::tuple{detail::access<Mode::update>(resources)...};
}

template <class... Resources>
[[nodiscard]] auto updates_halo(Resources&&... resources)
{
    return std::tuple{detail::access<Mode::update_halo>(resources)...};
}

} // namespace tasks
