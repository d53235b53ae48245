// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What moves over a bed of grains, and the stress that the fluid puts on the bed.
#include "io/run/metric_groups.hpp"
#include <array>
#include <span>

namespace io {

/// Grains in layers of equal thickness, one above the other, each sphere cut at the layers' borders.
struct BedLayers {
    double lowest = 0.0;        ///< where the first begins [m]
    double thickness = 0.0;     ///< of each [m]
    double area = 0.0;          ///< of each [m2]
    std::vector<double> solid;  ///< volume of the grains in each [m3]
    std::vector<double> motion; ///< integral of their speed over it [m4/s]

    /// Fraction that grains fill [-].
    [[nodiscard]] double fraction(std::size_t layer) const { return solid[layer] / (area * thickness); }
    /// Mean speed of the grains; 0 without any [m/s].
    [[nodiscard]] double speed(std::size_t layer) const { return solid[layer] > 0 ? motion[layer] / solid[layer] : 0.0; }
    [[nodiscard]] double middle(std::size_t layer) const { return lowest + (double(layer) + 0.5) * thickness; }
};

/// Volume of the part of a sphere that lies below a plane. @param height  Of the plane over the centre [m]. @returns [m3].
[[nodiscard]] double volume_below(double radius, double height);

/// Top of a bed, and where it begins to move [m].
struct MovingLayer {
    double top = 0.0, bottom = 0.0;
    [[nodiscard]] double thickness() const { return top - bottom; }
};

/// The top is the greatest height at which grains fill 8 % (O'Donoghue and Wright, 2004), between the middles of layers by a straight line.
/// From it down the layer reaches to where the mean speed of grains falls to `slowest`; it has no thickness where that is so at the top.
[[nodiscard]] MovingLayer moving_layer(const BedLayers& layers, double slowest);

/// The layers of a world: across the axis of the grid that is closest to gravity, a fifth of the smallest diameter thick. Collective.
/// @pre gravity
[[nodiscard]] BedLayers bed_layers(const World& world);

/// Volume of grains that passes a line, per time and length of the line, and so the sum of volume times velocity over the area of the
/// bed [m2/s]; top and thickness of the moving layer [m], in which the mean speed exceeds 0.02 sqrt(g d), d the smallest diameter. @pre gravity
[[nodiscard]] MetricGroup bed_metrics(World& world);

/// Stress that the fluid lost to grains and walls in the last step, less what the drive gave the fluid below the top of the bed, which flows
/// there without passing any stress on: in a steady flow the drive times the height of the fluid above the top [Pa]. @pre gravity
[[nodiscard]] MetricGroup bed_stress_metrics(World& world, const MomentumLedger& ledger);

} // namespace io
