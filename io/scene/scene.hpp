// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A scene as the user describes it: plain structs in SI units, with the defaults.
#include "io/scene/contact_keys.hpp"
#include "io/scene/coupling_keys.hpp"
#include "io/scene/fluid_keys.hpp"
#include "io/scene/particle_keys.hpp"
#include "io/scene/wall_keys.hpp"
#include <algorithm>

namespace io {

struct Gravity {
    core::Vec3 direction = -core::Vec3::UnitY();
    double magnitude = 9.81; ///< [m/s2]
    bool operator==(const Gravity&) const = default;
};

struct Limits {
    double cfl = 1.0;            ///< Cells crossed by the fluid in a step; of finite volumes, share of a cell that leaves it, at most 1.
    double particle_move = 0.25; ///< Largest move of a particle in a step, in widths of the filter.
    bool operator==(const Limits&) const = default;
};

struct Run {
    double settle = 0.0;             ///< [s] before t = 0, without the drive.
    double until = 0.0;              ///< [s]
    std::optional<double> time_step; ///< [s]; without it, the largest that the limits allow.
    Limits limits;
    int random_seed = 1;
    std::optional<double> wall_clock; ///< [s] of real time, after which the run stops with a checkpoint.
    bool operator==(const Run&) const = default;
};

/// What is measured of the grains, beside their number, energy and heights.
enum class GrainMeasure { contacts, motion, mixing, transport, segregation, profile };
inline constexpr std::array<std::string_view, 6> grain_measure_words{"contacts", "motion", "mixing", "transport", "segregation", "profile"};

using EnergyBudget = physics::Budget;
inline constexpr std::array<std::string_view, 2> energy_budget_words{"none", "kept"};

struct Output {
    Interval results, pictures;
    Interval checkpoint;
    Interval metrics{Interval::Clock::steps, 1.0};
    int keep_checkpoints = 2;
    std::vector<GrainMeasure> grains;
    EnergyBudget energy_budget = EnergyBudget::none; ///< of the particles
    bool operator==(const Output&) const = default;
};

struct Solver {
    double tolerance = 1e-8; ///< Relative residual of the pressure.
    bool operator==(const Solver&) const = default;
};

struct Scene {
    std::string name;
    Grid grid;
    std::optional<Fluid> fluid;
    std::optional<Gravity> gravity;
    std::vector<Species> particles;
    std::vector<Outlet> outlets;
    std::optional<Contact> contact;
    std::vector<WallKeys> walls;      ///< Beside those of the grid.
    std::optional<Coupling> coupling; ///< Present when there are both fluid and particles.
    Run run;
    Output output;
    Solver solver;
    bool operator==(const Scene&) const = default;

    [[nodiscard]] bool measures(GrainMeasure what) const
    {
        return std::find(output.grains.begin(), output.grains.end(), what) != output.grains.end();
    }
    /// Fills in what other keys decide: the size of a pipe, the coupling of fluid and particles.
    void resolve();
};

} // namespace io
