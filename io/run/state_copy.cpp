// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/run/state_copy.hpp"
#include "io/run/carried_fields.hpp"

namespace io {
namespace {

/// Calls visit(array) for the arrays of all carried fields, always in the same order.
template <class Visit>
void for_each_array(World& world, Visit visit)
{
    for_each_carried_field(world, [&](auto& field) {
        for (core::LocalBlock b = 0; b < world.mesh().own_count(); ++b)
            for (std::size_t a = 0; a < field.arrays; ++a) visit(field.data(b, a));
    });
}

} // namespace

void StateCopy::take(World& world)
{
    std::size_t next = 0;
    for_each_array(world, [&](const std::vector<double>& values) {
        if (next == arrays_.size()) arrays_.emplace_back();
        arrays_[next++] = values;
    });
    clock_ = world.clock();
    if (const auto* grains = world.grains()) {
        particles_ = grains->particles;
        history_ = grains->history;
        traffic_ = world.traffic()->state();
    }
}

void StateCopy::put_back(World& world) const
{
    std::size_t next = 0;
    for_each_array(world, [&](std::vector<double>& values) { values = arrays_[next++]; });
    world.clock() = clock_;
    if (auto* grains = world.grains()) {
        grains->particles = particles_;
        grains->history = history_;
        world.traffic()->restore(traffic_);
    }
}

} // namespace io
