// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The fields that the next step reads: what checkpoints hold and what a step that failed must give back.
#include "io/run/world.hpp"

namespace io {

/// Calls visit(field) for every field that is carried from step to step.
template <class Visit>
void for_each_carried_field(World& world, Visit visit)
{
    if (auto* fluid = world.fluid()) {
        auto& state = fluid->state();
        visit(state.velocity);
        visit(state.velocity_before);
        visit(state.pressure);
        visit(state.flux);
        if (fluid->by_finite_volumes()) visit(state.flux_before);
    }
    if (auto* turbulence = world.turbulence()) {
        visit(turbulence->k());
        visit(turbulence->epsilon());
        visit(turbulence->strain());
        visit(turbulence->forcing());
    }
    if (auto* scalars = world.scalars()) {
        for (auto& field : scalars->fields().values) visit(field);
        visit(scalars->fields().share);
    }
    if (auto* coupling = world.coupling()) {
        visit(coupling->fields().fraction);
        visit(coupling->fields().acceleration);
        visit(coupling->fields().ledger);
    }
    if (auto* one_way = world.one_way()) visit(one_way->acceleration());
}

} // namespace io
