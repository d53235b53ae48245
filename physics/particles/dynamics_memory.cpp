// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// ParticleDynamics: what particles and lists take of the memory.
#include "physics/particles/dynamics.hpp"

namespace physics {
namespace {

template <class T>
std::size_t room(const std::vector<T>& values)
{
    return values.capacity() * sizeof(T);
}

template <class... Vectors>
std::size_t room_of_all(const Vectors&... vectors)
{
    return (room(vectors) + ...);
}

std::size_t room_of(const core::ParticleSet& p)
{
    std::size_t bytes = room_of_all(p.id, p.species);
    core::ParticleSet::for_each_column(p, [&](const core::Column& column) { bytes += room(column); });
    return bytes;
}

std::size_t room_of(const core::PairList& pairs, const core::NearPairs& near)
{
    std::size_t bytes = room_of_all(pairs.first, pairs.second, pairs.image, pairs.row_begin, pairs.places);
    bytes += room_of_all(near.row, near.row_end, near.order);
    for (const auto& column : near.spring) bytes += room(column);
    return bytes;
}

} // namespace

std::size_t ParticleDynamics::bytes() const
{
    return room_of(particles) + room_of(pairs_, near_) +
           room_of_all(history.start, history.other, history.spring, forces_.forces, forces_.couples, forces_.books) + records_.bytes() +
           room_of_all(reference_[0], reference_[1], reference_[2]);
}

} // namespace physics
