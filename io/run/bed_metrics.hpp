// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What moves over a bed of grains, and the stress that the fluid puts on the bed.
#include "io/run/bed_layers.hpp"
#include "io/run/metric_groups.hpp"

namespace io {

/// Top of a bed, and where it begins to move [m].
struct MovingLayer {
    double top = 0.0, bottom = 0.0;
    [[nodiscard]] double thickness() const { return top - bottom; }
};

/// The top is the greatest height at which grains fill 8 % (O'Donoghue and Wright, 2004), between the middles of layers by a straight line.
/// From it down the layer reaches to where the mean speed of grains falls to `slowest`; it has no thickness where that is so at the top.
[[nodiscard]] MovingLayer moving_layer(const BedLayers& layers, double slowest);

/// Volume of grains that passes a line, per time and length of the line, and so the sum of volume times velocity over the area of the
/// bed [m2/s]; top and thickness of the moving layer [m], in which the mean speed exceeds 0.02 sqrt(g d), d the smallest diameter. @pre gravity
[[nodiscard]] MetricGroup bed_metrics(World& world);

/// Stress that the fluid lost to grains and walls in the last step, less what the drive gave the fluid below the top of the bed, which flows
/// there without passing any stress on: in a steady flow the drive times the height of the fluid above the top [Pa]. @pre gravity
[[nodiscard]] MetricGroup bed_stress_metrics(World& world, const MomentumLedger& ledger);

} // namespace io
