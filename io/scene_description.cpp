// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene_description.hpp"

namespace io {

static void describe(Schema& s, PipeCells& p)
{
    s.required("across", p.across, "", "Cells over the diameter, a multiple of 4: half of them in the core", at_least(4));
    s.required("along", p.along, "", "Cells along the axis, a multiple of blocks_along", at_least(1));
}

static void describe(Schema& s, PipeGrid& p)
{
    s.required("diameter", p.diameter, "m", "Inner diameter", positive);
    s.required("length", p.length, "m", "Length along the axis, which is x", positive);
    s.value("size", "Number of cells: small 2,160, medium 6,144 (the default), large 20,736", choice_of(p.size, pipe_size_words));
    s.group("cells", p.cells, "Cells of your own, instead of a named size");
    s.value("blocks_along", p.blocks_along, "", "Blocks along the axis, five in each section", at_least(1));
    s.value("core_fraction", p.core_fraction, "1", "Half diagonal of the core over the radius", between(0.2, 0.8));
}

static void describe(Schema& s, BoxGrid& p)
{
    s.required("size", p.size, "m", "Lengths of the edges; one corner is the origin", positive);
    s.required("cells", p.cells, "", "Cells along each edge", at_least(1));
    s.value("blocks", p.blocks, "", "Blocks along each edge; each divides the cells", at_least(1));
}

static void describe(Schema& s, Grid& p)
{
    s.exactly_one({"pipe", "box", "wavy_box", "annulus", "bent_pipe", "stepped_channel", "blocks"});
    s.group("pipe", p.pipe, "A straight round pipe");
    s.group("box", p.box, "A rectangular box");
    s.group("wavy_box", p.wavy_box, "A box bent to sine waves");
    s.group("annulus", p.annulus, "The space between two round pipes");
    s.group("bent_pipe", p.bent_pipe, "A round pipe along straight pieces and arcs");
    s.group("stepped_channel", p.stepped_channel, "A channel whose floor steps down; with periodic ends, one with a trench");
    s.group("blocks", p.blocks, "Blocks from a file");
    s.group("elliptic", p.elliptic, "Generate the insides of all blocks by a Poisson system, from what lies on their sides");
    s.value("periodic", "Axes along which the domain repeats", choices_of(p.periodic, axis_words));
}

static void describe(Schema& s, ReverseAt& p)
{
    s.required("axis_speed", p.axis_speed, "m/s", "Speed on the axis of the pipe at which the gradient changes sign", positive);
}

static void describe(Schema& s, Drive& p)
{
    s.exactly_one({"pressure_gradient", "flow_rate", "bulk_velocity"});
    s.value("pressure_gradient", p.pressure_gradient, "Pa/m", "Mean pressure drop per length; with a frequency, its amplitude");
    s.value("flow_rate", p.flow_rate, "m3/s",
            "Volume of fluid and particles that flows through each section, exact at the end of each step; the pressure drop follows");
    s.value("bulk_velocity", p.bulk_velocity, "m/s", "The flow rate over the mean area of the sections, instead of it");
    s.value("axis", "Axis along which it acts; it must be periodic", choice_of(p.axis, axis_words));
    s.value("frequency", p.frequency, "Hz", "Makes it harmonic: a cosine of time", positive);
    s.group("over_time", p.over_time, "Makes it change in time: a factor, by a formula or a table");
    s.group("reverse_at", p.reverse_at, "Makes the gradient change sign when the flow is fast enough");
}

static void describe(Schema& s, Material& p)
{
    s.required("density", p.density, "kg/m3", "Density", positive);
    s.required("viscosity", p.viscosity, "m2/s", "Kinematic viscosity; 0 is an inviscid fluid", not_negative);
}

static void describe(Schema& s, Boundary& p)
{
    s.required("at", p.at, "", "Name of the boundary: wall, x_low and x_high of a pipe, x_low to z_high of a box, and so on");
    s.value("kind",
            "wall: the fluid sticks to it; slip: no friction along it; symmetry: a plane that halves the flow; inflow: the velocity "
            "is given; outflow: the pressure is given, and what flows back was at rest; pressure: it is given, and what flows in keeps its "
            "velocity",
            choice_of(p.kind, boundary_kind_words));
    s.value("velocity", p.velocity, "m/s", "Of what flows in (with a profile, its mean), or of the wall");
    s.value("profile",
            "How what flows in is distributed: uniform, as without it; laminar: as developed laminar flow between the walls at the edge",
            choice_of(p.profile, inflow_profile_words));
    s.value("profile_file", p.profile_file, "",
            "A text file with a point of the inflow on each line, x y z in m and u v w in m/s, instead of the velocity");
    s.group("over_time", p.over_time, "Makes the velocity change in time: a factor, by a formula or a table");
    s.value("pressure", p.pressure, "Pa", "Where it is given, without the weight of the fluid; 0 without it");
}

static void describe(Schema& s, ScalarEntry& p)
{
    s.required("at", p.at, "", "Name of the boundary");
    s.required("value", p.value, "1", "Value of what flows in there");
}

static void describe(Schema& s, Scalar& p)
{
    s.required("name", p.name, "", "Name in results and metrics");
    s.value("diffusivity", p.diffusivity, "m2/s", "Diffusivity; 0 means that the flow alone carries it", not_negative);
    s.value("initial", p.initial, "1", "Value everywhere at the start");
    s.list("entering", p.entering, "Values of what flows in through boundaries; elsewhere it has the value of the cells inside");
}

static void describe(Schema& s, TurbulenceKeys& p)
{
    s.required("model", "none: the grid resolves all of the flow; k-epsilon: the standard model, with wall functions",
               choice_of(p.model, turbulence_model_words));
    s.value("intensity", p.intensity, "1", "Fluctuations over the speed, at the start and where fluid flows in", positive);
    s.value("speed", p.speed, "m/s", "Speed that the intensity at the start refers to; without it, that of what flows in", positive);
    s.value("length", p.length, "m", "Mixing length at the start and where fluid flows in; without it, 7 % of the narrowest width",
            positive);
    s.value("roughness", p.roughness, "m", "Roughness of walls, as the height of sand grains", not_negative);
}

static void describe(Schema& s, Fluid& p)
{
    s.value(
        "advection",
        "How the flow carries its velocity. lcsi: from where the water of each cell came from, steps bounded by accuracy alone; "
        "lcsi_spline: the same by local splines that nothing bounds, for comparison; finite_volume: by fluxes through faces, which keep "
        "all momentum: steps in which a cell loses at most its own fluid, no particles",
        choice_of(p.advection, advection_scheme_words));
    s.list("boundaries", p.boundaries, "Boundaries other than walls at rest");
    s.group("drive", p.drive, "What pushes the fluid along a periodic axis");
    s.list("scalars", p.scalars, "What the fluid carries along, such as dye: it does not act back");
    s.group("turbulence", p.turbulence, "Turbulence that the grid does not resolve");
    s.named_group("<material>", p.material, "The fluid, under a name of your choice such as water");
}

static void describe(Schema& s, Gravity& p)
{
    s.required("direction", "Direction of the weight", direction_of(p.direction));
    s.value("magnitude", p.magnitude, "m/s2", "Acceleration", not_negative);
}

static void describe(Schema& s, Initial& p)
{
    s.value("arrangement",
            "Where the particles are at the start: at random; on a cubic lattice; packed in face-centred cubes from wall to wall, "
            "that of the first species for all",
            choice_of(p.arrangement, arrangement_words));
    s.value("low", p.low, "m", "Low corner of the region of their centres; without it, all of the domain");
    s.value("high", p.high, "m", "High corner of the region of their centres; without it, all of the domain");
    s.value("velocity", p.velocity, "m/s", "Their velocity");
    s.value("spacing", p.spacing, "1",
            "Packed: distance of neighbours in largest diameters, as near as whole cubes fit; below 1 a bed is squeezed "
            "and holds itself",
            positive);
}

static void describe(Schema& s, Species& p)
{
    s.required("name", p.name, "", "Name in results and messages");
    s.required("count", p.count, "", "Number of particles", at_least(0));
    s.required("diameter", p.diameter, "m", "Diameter", positive);
    s.required("density", p.density, "kg/m3", "Density", positive);
    s.group("initial", p.initial, "Where they are at the start");
}

static void describe(Schema& s, Contact& p)
{
    s.value("law", "Contact law; linear is a spring and a dashpot", choice_of(p.law, contact_law_words));
    s.required("stiffness", p.stiffness, "N/m", "Normal stiffness of a contact", positive);
    s.value("restitution", p.restitution, "1", "Normal speed after over before a dry collision", Range{0.0, 1.0, true});
    s.value("friction", p.friction, "1", "Coulomb coefficient between particles and with walls", not_negative);
    s.value("tangential_ratio", p.tangential_ratio, "1", "Tangential over normal stiffness", between(0.0, 1.0));
    s.value("steps_per_contact", p.steps_per_contact, "", "Sub-steps in the shortest collision", at_least(10));
    s.value("walls", "Walls that particles meet: the faces of boundary cells, or the exact pipe or box",
            choice_of(p.walls, wall_shape_words));
}

static void describe(Schema& s, Coupling& p)
{
    s.value("mode", "What waits for what in a step; auto chooses by the fluid", choice_of(p.mode, coupling_mode_words));
    s.value("filter", p.filter, "", "Width of the filter between particles and fluid", not_negative);
    s.value("preset",
            "standard: drag of Di Felice, force of the pressure gradient and viscous stress, lift of Lun & Liu; "
            "seed: as printed by Ushijima & Nezu (2001), units repaired: Ergun to a fluid fraction of 0.8 and Wen-Yu with exponent -2.7 "
            "above, rho V Du/Dt instead of the pressure gradient, added mass 1/2, lift coefficient 0.4 times the speed of the surface over "
            "that of the slip, no shear lift",
            choice_of(p.preset, coupling_preset_words));
    s.value("drag", "smooth: Di Felice; seed: the switch from Ergun to Wen-Yu at 0.8; without it, the preset's",
            choice_of(p.drag, drag_law_words));
    s.value("added_mass", "Added mass; auto: unless the particles are much denser than the fluid", choice_of(p.added_mass, switch_words));
    s.value("lift", "Lift of spinning particles; auto: unless they are much denser than the fluid", choice_of(p.lift, switch_words));
    s.value("magnus",
            "Lift law. lun_liu: falls with the Reynolds number, to a fifth at 1000; rubinow_keller: theory for Reynolds numbers below 1; "
            "seed: a fifth of that throughout; without it, the preset's",
            choice_of(p.magnus, magnus_law_words));
    s.value("torque", "Torque of the fluid on spinning particles; auto: by its estimated size", choice_of(p.torque, switch_words));
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
    s.value("keep_checkpoints", p.keep_checkpoints, "", "Newest checkpoints that are kept", at_least(1));
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
    s.group("contact", p.contact, "How particles collide; needed when there are particles");
    s.group("coupling", p.coupling, "How fluid and particles act on each other");
    s.required_group("run", p.run, "How long the run is, and its steps");
    s.group("output", p.output, "What is written, and when");
    s.group("solver", p.solver, "How exactly equations are solved");
}

} // namespace io
