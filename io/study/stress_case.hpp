// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A stiff or extreme case as a file: a scene, how it is varied, and what must hold while it runs and at its end.
#include "io/scene/scene_source.hpp"

namespace io {

/// What is measured; most are the largest of the run; final_*, settling_speed, creep, flow_speed and ledger are
/// those of its end.
enum class Measure {
    particle_speed,
    fluid_speed,
    energy,
    pressure,
    solid_fraction,
    momentum_defect,
    exchange_defect,
    final_particle_speed,
    final_rms_speed,
    settling_speed,
    slip_speed,
    creep,
    flow_speed,
    ledger,
    pressure_growth,
    continued_change,
    continued_pressure
};

struct MeasureWords {
    std::string_view word, unit, meaning;
};
inline constexpr std::array<MeasureWords, 17> measures{{
    {"particle_speed", "m/s", "Largest speed of a particle"},
    {"fluid_speed", "m/s", "Largest speed of the fluid"},
    {"energy", "J", "Kinetic energy of fluid and particles"},
    {"pressure", "Pa", "Largest magnitude of the dynamic pressure"},
    {"solid_fraction", "1", "Largest fraction of solid in a cell"},
    {"momentum_defect", "1", "Momentum that no impulse explains, over the largest term"},
    {"exchange_defect", "1", "Impulse given by the fluid and not taken by the particles, relative"},
    {"final_particle_speed", "m/s", "Largest speed of a particle at the end"},
    {"final_rms_speed", "m/s", "Root mean square speed of the particles at the end"},
    {"settling_speed", "m/s", "Mean speed along gravity of the particles against the fluid at the end"},
    {"slip_speed", "m/s", "Largest distance of the mean velocity of the particles from that of the fluid"},
    {"creep", "m", "Largest distance of a particle at the end from where it was after the first step"},
    {"flow_speed", "m/s", "Mean of fluid fraction times velocity along the drive at the end"},
    {"ledger", "N s", "Impulses owed to fluid and particles at the end"},
    {"pressure_growth", "1", "Largest pressure of any variant over that of the first"},
    {"continued_change", "m/s", "Largest change of a velocity of the fluid in the steps of go_on"},
    {"continued_pressure", "1", "Largest pressure after the steps of go_on over that before them"},
}};

/// A number must lie between the two.
struct Bounds {
    double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
    [[nodiscard]] bool hold(double x) const { return x >= low && x <= high; }
};
/// One value, which is the largest allowed, or [low, high].
[[nodiscard]] Value value_of(Bounds& place, std::string_view unit, Range range);

struct StressCriteria {
    std::array<std::optional<Bounds>, measures.size()> bounds;
    /// Measured by whoever runs the case, not while it runs.
    [[nodiscard]] static bool of_the_end(Measure m) { return m >= Measure::pressure_growth; }
    [[nodiscard]] const std::optional<Bounds>& of(Measure m) const { return bounds[std::size_t(m)]; }
};

/// Going on from a checkpoint of the end as another scene.
struct StressContinuation {
    std::vector<std::string> set;
    int steps = 0;
};

struct StressVariant {
    std::string name;
    std::vector<std::string> set;
    std::optional<std::string> refused; ///< The error that this variant must end in, instead of that of the case.
};

struct StressCase {
    std::string name, source, meaning;
    SceneSource scene;
    std::optional<int> steps;      ///< Instead of run.until.
    std::optional<double> squeeze; ///< Distances between particles are multiplied by it at the start.
    std::vector<StressVariant> variants;
    int halve_dt = 0; ///< Further variants, each with half the time step of the one before.
    std::optional<StressContinuation> go_on;
    StressCriteria criteria;
    std::vector<std::string> same_bits; ///< executors, or "restart"
    std::optional<std::string> refused; ///< The run must end in an error that contains this.
};

void describe(Schema& s, StressCase& stress);

/// The cases of a folder by name; those named, or all.
/// @throws core::ConfigError for a folder without cases, a case that does not exist, or mistakes in a file.
[[nodiscard]] std::vector<StressCase> read_stress_cases(const std::filesystem::path& folder, const std::vector<std::string>& names);

} // namespace io
