// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Weights of interpolation on the seven points around a cell: local C1 Hermite with fourth-order slopes, local splines, linear.
#include <array>
#include <cmath>

namespace physics {

/// Writes the weights of six points, the third of which is the middle one of seven and the fourth lies towards the sign of s.
inline void put_six_weights(double s, const std::array<double, 6>& six, double* w, std::ptrdiff_t stride)
{
    const auto [a, b, c, d, e, f] = six;
    const bool up = s >= 0;
    w[0] = up ? 0 : f;
    w[stride] = up ? a : e;
    w[2 * stride] = up ? b : d;
    w[3 * stride] = c;
    w[4 * stride] = up ? d : b;
    w[5 * stride] = up ? e : a;
    w[6 * stride] = up ? f : 0;
}

/// Weights of the points -3 ... 3 for the value at offset s, |s| <= 1: cubic Hermite between two points, slopes
/// (f[-2] - 8 f[-1] + 8 f[1] - f[2]) / 12. Six points carry weight; the seventh makes the window the same for both signs.
/// Amplifies no mode for any s.
/// @param[out] w  Written with stride `stride`.
inline void hermite_weights(double s, double* w, std::ptrdiff_t stride)
{
    const double t = std::abs(s), t2 = t * t, t3 = t2 * t;
    const double near_value = 1 - 3 * t2 + 2 * t3, far_value = 3 * t2 - 2 * t3;
    const double near_slope = (t - 2 * t2 + t3) / 12, far_slope = (t3 - t2) / 12;
    put_six_weights(s,
                    {near_slope, far_slope - 8 * near_slope, near_value - 8 * far_slope, far_value + 8 * near_slope,
                     8 * far_slope - near_slope, -far_slope},
                    w, stride);
}

/// The same for the cubic spline through the six points, without curvature at its ends: the literal local spline. Amplifies the modes
/// of a few cells by up to 0.33 % at each use.
/// @source  Ushijima (1994) in name; six points and natural ends are our reading (NUMERICS A5).
inline void spline_weights(double s, double* w, std::ptrdiff_t stride)
{
    // The curvatures beside the value are 6/209 times (-15, 60, -16, 4) and (4, -16, 60, -15) of the second differences.
    const double t = std::abs(s), u = 1 - t;
    const double near = (u * u * u - u) / 209, far = (t * t * t - t) / 209;
    const double p = 4 * far - 15 * near, q = 60 * near - 16 * far, r = 60 * far - 16 * near, v = 4 * near - 15 * far;
    put_six_weights(s, {p, q - 2 * p, p - 2 * q + r + u, q - 2 * r + v + t, r - 2 * v, v}, w, stride);
}

/// The same for linear interpolation between two points.
inline void linear_weights(double s, double* w, std::ptrdiff_t stride)
{
    const double t = std::abs(s);
    w[0] = w[stride] = w[5 * stride] = w[6 * stride] = 0;
    w[2 * stride] = s < 0 ? t : 0;
    w[3 * stride] = 1 - t;
    w[4 * stride] = s < 0 ? 0 : t;
}

} // namespace physics
