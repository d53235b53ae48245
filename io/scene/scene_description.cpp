// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_description.hpp"

namespace io {

static void describe(Schema& s, Gravity& p)
{
    s.required("direction", "Direction of the weight", direction_of(p.direction));
    s.value("magnitude", p.magnitude, "m/s2", "Acceleration", not_negative);
}

static void describe(Schema& s, Limits& p)
{
    s.value("cfl", p.cfl, "1",
            "Cells that the fluid may cross in a step; with finite_volume, share of a cell's fluid that may leave it, at most 1", positive);
    s.value("particle_move", p.particle_move, "1", "Widths of the coupling filter that a particle may move in a step", positive);
}

static void describe(Schema& s, Run& p)
{
    s.value("settle", p.settle, "s", "Time before t = 0 in which the particles settle, without the drive", not_negative);
    s.required("until", p.until, "s", "Simulated time at which the run ends", positive);
    s.value("time_step", p.time_step, "s", "Fixed time step; without it, the largest within the limits", positive);
    s.group("limits", p.limits, "What bounds the time step");
    s.value("random_seed", p.random_seed, "", "Seed of all random choices", at_least(0));
    s.value("wall_clock", p.wall_clock, "s", "Real time after which the run stops with a checkpoint", positive);
}

static void describe(Schema& s, Output& p)
{
    s.value("results", p.results, "", "Fields and particles, for ParaView");
    s.value("pictures", p.pictures, "", "Pictures");
    s.value("checkpoint", p.checkpoint, "", "Checkpoints, from which a run goes on with the same bits");
    s.value("metrics", p.metrics, "", "Rows of metrics.csv");
    s.value(
        "grains",
        "Measured of the grains, in metrics.csv and in the cells of results: contacts (coordination, stress), motion (fraction, mean "
        "velocity, granular temperature), mixing (Lacey's index, metrics only), transport (what moves over a bed and the stress that "
        "drives it, metrics only), segregation (large above small, waves of a bed; metrics only), profile (layers of a bed in profile.csv, "
        "with each of the results)",
        choices_of(p.grains, grain_measure_words));
    s.value("keep_checkpoints", p.keep_checkpoints, "", "Newest checkpoints that are kept", at_least(1));
    s.value("energy_budget", "Where the energy of the particles goes, in metrics.csv: kept costs some time in every contact",
            choice_of(p.energy_budget, energy_budget_words));
}

static void describe(Schema& s, Solver& p)
{
    s.value("tolerance", p.tolerance, "1", "Relative residual at which the pressure is solved", Range{0.0, 0.1, true});
}

void describe(Schema& s, Scene& p)
{
    s.required("name", p.name, "", "What the scene is");
    s.required_group("grid", p.grid, "The domain and its cells");
    s.group("fluid", p.fluid, "The fluid; without it, the particles are dry");
    s.group("gravity", p.gravity, "Weight; without it, there is none");
    s.list("particles", p.particles, "Species of spheres; without them, the fluid is alone");
    s.list("outlets", p.outlets, "Regions in which particles are taken away");
    s.group("contact", p.contact, "How particles collide; needed when there are particles");
    s.list("walls", p.walls, "Walls that particles meet beside those of the grid; they may move");
    s.group("coupling", p.coupling, "How fluid and particles act on each other");
    s.required_group("run", p.run, "How long the run is, and its steps");
    s.group("output", p.output, "What is written, and when");
    s.group("solver", p.solver, "How exactly equations are solved");
}

} // namespace io
