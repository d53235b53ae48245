// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The closed set of drag laws as functions: a loop over grains is compiled once for each of them.
#include "physics/coupling/drag_beetstra.hpp"
#include "physics/coupling/drag_law.hpp"
#include "physics/coupling/drag_mixture.hpp"
#include "physics/coupling/drag_rong.hpp"
#include "physics/coupling/drag_tenneti.hpp"

namespace physics {

/// Calls use(law) with the chosen law as a function of DragInput, for loops without a branch inside.
template <class Use>
auto with_drag_law(DragLaw chosen, Use use)
{
    switch (chosen) {
    case DragLaw::di_felice: return use([](const DragInput& in) { return drag_di_felice(in); });
    case DragLaw::gidaspow: return use([](const DragInput& in) { return drag_gidaspow(in); });
    case DragLaw::kawaguchi: return use([](const DragInput& in) { return drag_kawaguchi(in); });
    case DragLaw::gidaspow_smooth: return use([](const DragInput& in) { return drag_gidaspow_smooth(in); });
    case DragLaw::schiller_naumann: return use([](const DragInput& in) { return drag_schiller_naumann(in); });
    case DragLaw::beetstra: return use([](const DragInput& in) { return drag_beetstra(in); });
    case DragLaw::rong: return use([](const DragInput& in) { return drag_rong(in); });
    case DragLaw::tenneti: return use([](const DragInput& in) { return drag_tenneti(in); });
    case DragLaw::wen_yu: return use([](const DragInput& in) { return drag_wen_yu(in); });
    case DragLaw::ergun: break;
    }
    return use([](const DragInput& in) { return drag_ergun(in); });
}

} // namespace physics
