// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Derivatives along a grid line of points one index apart, from splines (NUMERICS A1): fourth-order slopes, curvatures.
#include "core/base/vec3.hpp"
#include <span>

namespace core {

/// How a curvature follows from the second difference d of the points: M(i-1) + c M(i) + M(i+1) = (c + 2) d(i).
enum class Curvature {
    cubic_spline, ///< c = 4, the cubic spline through the points: second order, as in Ushijima & Nezu (2001)
    compact       ///< c = 10: fourth order on the same three points
};

/// Slopes at all points of a line: those of the cubic spline whose ends have one-sided slopes of fourth order (of second
/// order on lines of fewer than five points).
void line_slopes(std::span<const Vec3> points, std::span<Vec3> slopes);

/// Curvatures at the points of a line. A spline has a continuous third derivative at its first inner points (not-a-knot);
/// the compact form has one-sided curvatures of third order at its ends.
void line_curvatures(std::span<const Vec3> points, Curvature kind, std::span<Vec3> curvatures);

/// Moves the inner points of a line along its spline so that the arc lengths from its start are `shares` of the whole.
void respace(std::span<Vec3> points, std::span<const double> shares);

} // namespace core
