// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What metrics.csv says about each part of a world. All groups refer to the world and must not outlive it.
#include "io/run/world_metrics.hpp"

namespace io {

/// time [s], step, dt [s], and sub_steps where there are particles.
[[nodiscard]] MetricGroup step_metrics(World& world);
/// Kinetic energy [J], largest speed [m/s], divergence (net over through flux of the cells, root mean squares), iterations of
/// the pressure in the last step.
[[nodiscard]] MetricGroup fluid_metrics(World& world);
/// Energy of the turbulence [J], largest eddy viscosity over that of the fluid.
[[nodiscard]] MetricGroup turbulence_metrics(World& world);
/// Amount of each scalar in the fluid: its integral over the volume of the fluid [m3]; its least and largest value.
[[nodiscard]] MetricGroup scalar_metrics(World& world);
/// Speed on the axis [m/s]; flow rate of fluid along the drive: mean of phi u over the domain times its section [m3/s]; where the flow
/// is prescribed, the mean pressure gradient that the last step has found [Pa/m].
[[nodiscard]] MetricGroup drive_metrics(World& world);
/// Their number and kinetic energy, spin included [J].
[[nodiscard]] MetricGroup particle_metrics(World& world);
/// Kinetic, rotational, potential and elastic energy of the particles, what contacts dissipated and what walls gave so far [J]: the sum
/// less what walls gave changes by what a fluid gives, where particles come in or leave with what was booked for them, and where they
/// pass a periodic side along gravity. @pre output.energy_budget: kept
[[nodiscard]] MetricGroup energy_metrics(World& world);
/// Of each species that comes in the number so far; of each outlet the number and the mass that it has taken away [kg].
[[nodiscard]] MetricGroup traffic_metrics(World& world);
/// Of each wall of the scene's own, mean of the last step: force on it [N], torque on it about the point of its axis, or of its own if it
/// does not turn [N m], power that it gives to the particles [W].
[[nodiscard]] MetricGroup wall_metrics(World& world);
/// What output.grains asks for: mean number of contacts with others; granular temperature, its mean over the volume of the grains [m2/s2];
/// Lacey's index of the first species among the others: 0 where cells hold one kind, 1 where they hold what chance would give them.
[[nodiscard]] MetricGroup measured_metrics(World& world);
/// How far large ones lie above small ones: the difference of their mean heights over the mean diameter of the large, which are those above
/// the middle of all sizes. Along each level periodic axis the amplitudes of one to four waves of the amount of grains over its mean.
/// @pre gravity
[[nodiscard]] MetricGroup segregation_metrics(World& world);
/// Against gravity: mean and its standard error for each species, lowest and highest centre [m].
[[nodiscard]] MetricGroup height_metrics(World& world);
/// Volume of the solid in the cells [m3], its relative defect against the particles, largest solid fraction.
[[nodiscard]] MetricGroup solid_metrics(World& world);

/// Momentum, and the impulses of the last step, line by line [N s].
[[nodiscard]] MetricGroup momentum_metrics(const MomentumLedger& ledger);
/// The same of particles that the fluid does not feel, theirs alone.
[[nodiscard]] MetricGroup one_way_metrics(const OneWayBooks& books);

} // namespace io
