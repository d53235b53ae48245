// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Damping ratio and coefficient of restitution of a contact whose force never pulls.

namespace physics {

/// Restitution of a head-on impact with spring, dashpot and a force that never pulls [-]. The same for a linear spring with a
/// constant dashpot and for Hertz' spring with a dashpot that grows with the fourth root of the overlap.
/// @param damping  Damping ratio zeta = c / (2 sqrt(m k)), not negative; for Hertz' spring k is 5/6 of the tangent stiffness.
/// @source  Schwager and Poeschel (2007), Coefficient of restitution and linear-dashpot model revisited.
[[nodiscard]] double restitution_of(double damping);

/// The inverse of restitution_of(). @throws core::ConfigError unless 0.01 <= restitution <= 1.
[[nodiscard]] double damping_of(double restitution);

} // namespace physics
