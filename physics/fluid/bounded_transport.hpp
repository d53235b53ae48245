// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Finite-volume transport of what a fluid carries: fluxes of high order, corrected so that no value leaves the range of its
// neighbours. One explicit step of w q, where w is the share of a cell that the carrying fluid fills:
//   w' V = w V - dt sum F,   w' V q' = w V q - dt sum (F q_upwind + c A),   A = F (q_face - q_upwind),   0 <= c <= 1.
// It is stable, and bounded, where no more than w V leaves a cell in a step.
#include "core/grid/mesh.hpp"
#include <algorithm>
#include <limits>

namespace physics {

/// Where the faces of a block are: [axis of the faces][component], as FaceView has them [m].
using FaceCentres = std::array<std::array<core::Array3<double>, 3>, 3>;
[[nodiscard]] FaceCentres face_centres(const core::Vertices& vertices);

/// What is carried, as its fluxes need it; all with one halo layer.
struct CarriedValue {
    core::View<const double> value;          ///< q at the start of the step; beyond boundaries that of what enters there
    core::View<const double> half;           ///< q in the cell's centre in the middle of the step
    core::VectorView<const double> gradient; ///< of q [1/m]
};

/// q - dt/2 u . grad q.
/// @param carrier  w u [m/s].
void middle_of_step(double dt, core::View<const double> share, core::VectorView<const double> carrier, core::View<const double> value,
                    core::VectorView<const double> gradient, core::View<double> half);

/// Fluxes of the upwind values, and what those of high order add to them. The value on a face is that of its upwind cell in the
/// middle of the step, continued by the gradient, with a share of the second difference that makes it third order on uniform
/// grids: q + g . r + (q_down - q - g . d) / 6. Exact for linear fields on any grid.
/// @source  kappa = 1/3 of van Leer's family (1985), written with gradients.
/// @param flux         Of the carrying fluid [m3/s].
/// @param[out] upwind  F q_upwind.
/// @param[out] added   A.
void transport_fluxes(const core::BlockGeometry& geometry, const FaceCentres& centres, core::FaceView<const double> flux,
                      const CarriedValue& q, core::FaceView<double> upwind, core::FaceView<double> added);

/// The same in one, not bounded: F (q_upwind + high order).
void transport_flux(const core::BlockGeometry& geometry, const FaceCentres& centres, core::FaceView<const double> flux,
                    const CarriedValue& q, core::FaceView<double> out);

/// What is added to the value on a face of the second difference along the line between cells.
inline constexpr double share_of_second_difference = 1.0 / 6;

/// Sum of the fluxes that leave each cell [m3/s].
void outflow_of_cells(const core::BlockGeometry& geometry, core::FaceView<const double> flux, core::View<double> outflow);
/// The largest of that over the volume of the cell [1/s].
[[nodiscard]] double largest_outflow_rate(const core::BlockGeometry& geometry, core::FaceView<const double> flux);

/// Share of a flux that leaves a cell in its range: `room` is what is left of that.
[[nodiscard]] inline double share_within(double room, double capacity, double flux)
{
    constexpr double nothing = std::numeric_limits<double>::min(); // so that 0 / 0 does not arise
    return std::min(1.0, std::max(room, 0.0) * capacity / (flux + nothing));
}

/// How much of the added fluxes a cell can take and give without leaving the range of its old and its neighbours' old values.
/// @source  Zalesak (1979), eqs. (7)-(12), bounds from old values alone.
/// @param low          Value after the step with upwind fluxes alone.
/// @param capacity     w' V / dt [m3/s].
/// @param[out] gain    Share of the fluxes into the cell.
/// @param[out] loss    Share of the fluxes out of it.
void flux_shares(const core::BlockGeometry& geometry, core::View<const double> value, core::View<const double> low,
                 core::View<const double> capacity, core::FaceView<const double> added, core::View<double> gain, core::View<double> loss);

/// Reduces added fluxes to what both cells can take; both shares with one halo layer.
void reduce_fluxes(const core::BlockGeometry& geometry, core::View<const double> gain, core::View<const double> loss,
                   core::FaceView<double> added);

} // namespace physics
