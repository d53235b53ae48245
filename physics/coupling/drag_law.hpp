// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The names of the drag laws (drag_laws.hpp).

namespace physics {

enum class DragLaw {
    di_felice,        ///< smooth in phi and slip: the default
    gidaspow,         ///< a switch from Ergun to Wen-Yu at phi = 0.8
    kawaguchi,        ///< the same with the numbers of the seed: exponent -2.7, drag coefficient 0.43 above Re = 1000
    gidaspow_smooth,  ///< the same, blended
    schiller_naumann, ///< one sphere alone
    beetstra,         ///< resolved arrays, to Re = 1000
    rong,             ///< resolved packings, to Re = 3000
    tenneti,          ///< resolved arrays, C = 0.1 to 0.5
    wen_yu,           ///< suspensions
    ergun             ///< packed beds
};

} // namespace physics
