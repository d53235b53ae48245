// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a fluid carries through the sub-faces between blocks whose points do not match (bounded_transport.hpp): one flux of it through
// each, the same for both blocks to the last bit, and bounds from the cells on both sides rather than from what is interpolated.
// Blocks without such sides return at once.
#include "physics/fluid/bounded_transport.hpp"

namespace physics {

/// As transport_fluxes().
void sub_face_transport_fluxes(const core::BlockGeometry& geometry, core::FaceView<const double> flux, const CarriedValue& q,
                               core::FaceView<double> upwind, core::FaceView<double> added);

/// Sum of the fluxes that leave a cell beside sub-faces.
[[nodiscard]] double outflow_of(const core::BlockGeometry& geometry, const core::JoinedCell& at, core::FaceView<const double> flux);

/// As flux_shares(), of cells beside sub-faces.
void sub_face_flux_shares(const core::BlockGeometry& geometry, core::View<const double> value, core::View<const double> low,
                          core::View<const double> capacity, core::FaceView<const double> added, core::View<double> gain,
                          core::View<double> loss);

/// As reduce_fluxes(), with the sums on faces.
void reduce_sub_face_fluxes(const core::BlockGeometry& geometry, core::View<const double> gain, core::View<const double> loss,
                            core::FaceView<double> added);

} // namespace physics
