// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/grid/wavy_box.hpp"
#include "core/base/error.hpp"
#include <cmath>
#include <numbers>

namespace core {

MultiBlock make_wavy_box(const Box& box, const Waves& waves)
{
    const Vec3 number = 2 * std::numbers::pi * waves.count * (box.high - box.low).cwiseInverse();
    // The map's Jacobian is 1 plus the product of three slopes.
    const double steepness = std::pow(std::abs(waves.amplitude), 3) * number.prod();
    require<ConfigError>(steepness < 1, text("waves of amplitude ", waves.amplitude, " m fold the box: their slopes multiply to ",
                                             steepness, ", which must be below 1"));
    return make_box(box, [=](const Vec3& x) {
        const Vec3 phase = number.cwiseProduct(x - box.low);
        return Vec3(x + waves.amplitude * Vec3(std::sin(phase.y()), std::sin(phase.z()), std::sin(phase.x())));
    });
}

} // namespace core
