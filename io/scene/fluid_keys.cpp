// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/fluid_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {

void describe(Schema& s, ReverseAt& p)
{
    s.required("axis_speed", p.axis_speed, "m/s", "Speed on the axis of the pipe at which the gradient changes sign", positive);
}

void describe(Schema& s, Drive& p)
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

void describe(Schema& s, Material& p)
{
    s.required("density", p.density, "kg/m3", "Density", positive);
    s.required("viscosity", p.viscosity, "m2/s", "Kinematic viscosity; 0 is an inviscid fluid", not_negative);
}

void describe(Schema& s, SpinKeys& p)
{
    s.required("rate", p.rate, "rad/s", "Angular velocity, for example '15 rpm'; negative turns the other way");
    s.value("axis", "Direction of the axis; the wall turns about it by the right-hand rule", direction_of(p.axis));
    s.value("point", p.point, "m", "A point of the axis");
}

void describe(Schema& s, Boundary& p)
{
    s.required("at", p.at, "", "Name of the boundary: wall, x_low and x_high of a pipe, x_low to z_high of a box, and so on");
    s.value("kind",
            "wall: the fluid sticks to it; slip: no friction along it; symmetry: a plane that halves the flow; inflow: the velocity "
            "is given; outflow: the pressure is given, and what flows back was at rest; pressure: it is given, and what flows in keeps its "
            "velocity. Particles go through none of them: 'outlets' take them away",
            choice_of(p.kind, boundary_kind_words));
    s.value("velocity", p.velocity, "m/s", "Of what flows in (with a profile, its mean), or of the wall");
    s.value("profile",
            "How what flows in is distributed: uniform, as without it; laminar: as developed laminar flow between the walls at the edge",
            choice_of(p.profile, inflow_profile_words));
    s.value("profile_file", p.profile_file, "",
            "A text file with a point of the inflow on each line, x y z in m and u v w in m/s, instead of the velocity");
    s.group("spin", p.spin, "Makes a round wall turn in itself, instead of a velocity");
    s.group("over_time", p.over_time, "Makes the velocity change in time: a factor, by a formula or a table");
    s.value("pressure", p.pressure, "Pa", "Where it is given, without the weight of the fluid; 0 without it");
}

void describe(Schema& s, ScalarEntry& p)
{
    s.required("at", p.at, "", "Name of the boundary");
    s.required("value", p.value, "1", "Value of what flows in there");
}

void describe(Schema& s, Scalar& p)
{
    s.required("name", p.name, "", "Name in results and metrics");
    s.value("diffusivity", p.diffusivity, "m2/s", "Diffusivity; 0 means that the flow alone carries it", not_negative);
    s.value("initial", p.initial, "1", "Value everywhere at the start");
    s.list("entering", p.entering, "Values of what flows in through boundaries; elsewhere it has the value of the cells inside");
}

void describe(Schema& s, TurbulenceKeys& p)
{
    s.required(
        "model",
        "none: the grid resolves all of the flow; k-epsilon: the standard model, with functions for the layers at walls, first cells "
        "from y+ = 30 to 150; abe-kondoh-nagano: k-epsilon down to the wall, first cells at y+ = 1, growing by a tenth at most",
        choice_of(p.model, turbulence_model_words));
    s.value("intensity", p.intensity, "1", "Fluctuations over the speed, at the start and where fluid flows in", positive);
    s.value("speed", p.speed, "m/s", "Speed that the intensity at the start refers to; without it, that of what flows in", positive);
    s.value("length", p.length, "m", "Mixing length at the start and where fluid flows in; without it, 7 % of the narrowest width",
            positive);
    s.value("roughness", p.roughness, "m", "Roughness of walls, as the height of sand grains", not_negative);
}

void describe(Schema& s, Fluid& p)
{
    s.value(
        "advection",
        "How the flow carries its velocity. lcsi: from where the water of each cell came from, steps bounded by accuracy alone; "
        "lcsi_spline: the same by local splines that nothing bounds, for comparison; finite_volume: by fluxes through faces, which keep "
        "all momentum: steps in which a cell loses at most its own fluid",
        choice_of(p.advection, advection_scheme_words));
    s.list("boundaries", p.boundaries, "Boundaries other than walls at rest");
    s.group("drive", p.drive, "What pushes the fluid along a periodic axis");
    s.list("scalars", p.scalars, "What the fluid carries along, such as dye: it does not act back");
    s.group("turbulence", p.turbulence, "Turbulence that the grid does not resolve");
    s.named_group("<material>", p.material, "The fluid, under a name of your choice such as water");
}

} // namespace io
