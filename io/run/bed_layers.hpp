// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A bed of grains as layers, one above the other.
#include "io/run/world.hpp"

namespace io {

/// Grains in layers of equal thickness, each sphere cut at the layers' borders.
struct BedLayers {
    double lowest = 0.0;                       ///< where the first begins [m]
    double thickness = 0.0;                    ///< of each [m]
    std::vector<double> room;                  ///< volume of the domain in each [m3]
    std::vector<double> solid;                 ///< volume of the grains in each [m3]
    std::vector<double> motion;                ///< integral of their speed over it [m4/s]
    std::vector<std::vector<double>> solid_of; ///< volume of each species in each layer [m3]

    [[nodiscard]] std::size_t count() const { return solid.size(); }
    /// Fraction that grains fill; 0 where the domain has no room [-].
    [[nodiscard]] double fraction(std::size_t layer) const { return room[layer] > 0 ? solid[layer] / room[layer] : 0.0; }
    /// Mean speed of the grains; 0 without any [m/s].
    [[nodiscard]] double speed(std::size_t layer) const { return solid[layer] > 0 ? motion[layer] / solid[layer] : 0.0; }
    [[nodiscard]] double middle(std::size_t layer) const { return lowest + (double(layer) + 0.5) * thickness; }
};

/// Volume of the part of a sphere that lies below a plane. @param height  Of the plane over the centre [m]. @returns [m3].
[[nodiscard]] double volume_below(double radius, double height);

/// Where the layers of a world lie: across the axis of the grid that is closest to gravity, about a fifth of the smallest diameter thick.
class BedLayering {
public:
    /// Collective. @pre gravity, grains with sizes
    explicit BedLayering(const World& world);
    /// The grains as they are now. Collective.
    [[nodiscard]] BedLayers of(const World& world) const;
    /// Mean area of the layers [m2].
    [[nodiscard]] double area() const { return area_; }

private:
    [[nodiscard]] std::vector<double> room_of(const World& world, std::size_t count) const;

    int axis_ = 1;
    double up_ = 1.0; ///< sense of the axis that points against gravity
    double area_ = 0.0;
    BedLayers empty_;
};

} // namespace io
