// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Weights of the local C1 Hermite interpolation with fourth-order slopes, on the seven points around a cell.
#include <array>
#include <cmath>

namespace physics {

/// Weights of the points -3 ... 3 for the value at offset s, |s| <= 1: cubic Hermite between two points, slopes
/// (f[-2] - 8 f[-1] + 8 f[1] - f[2]) / 12. Six points carry weight; the seventh makes the window the same for both signs.
/// Amplifies no mode for any s.
/// @param[out] w  Written with stride `stride`.
inline void hermite_weights(double s, double* w, std::ptrdiff_t stride)
{
    const double t = std::abs(s), t2 = t * t, t3 = t2 * t;
    const double near_value = 1 - 3 * t2 + 2 * t3, far_value = 3 * t2 - 2 * t3;
    const double near_slope = (t - 2 * t2 + t3) / 12, far_slope = (t3 - t2) / 12;
    const double a = near_slope;                 // two before
    const double b = far_slope - 8 * near_slope; // one before
    const double c = near_value - 8 * far_slope; // the near point
    const double d = far_value + 8 * near_slope; // the far point
    const double e = 8 * far_slope - near_slope; // one behind
    const double f = -far_slope;                 // two behind
    const bool up = s >= 0;
    w[0] = up ? 0 : f;
    w[stride] = up ? a : e;
    w[2 * stride] = up ? b : d;
    w[3 * stride] = c;
    w[4 * stride] = up ? d : b;
    w[5 * stride] = up ? e : a;
    w[6 * stride] = up ? f : 0;
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
