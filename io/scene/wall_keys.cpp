// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/wall_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {

static void describe(Schema& s, PlaneKeys& p)
{
    s.required("point", p.point, "m", "A point of it");
    s.required("normal", "Its normal, towards the particles; all behind it is solid", direction_of(p.normal));
}

static void describe(Schema& s, CylinderWallKeys& p)
{
    s.required("point", p.point, "m", "A point of its axis");
    s.required("axis", "Direction of its axis; it has no ends", direction_of(p.axis));
    s.required("radius", p.radius, "m", "Its radius", positive);
    s.value("particles", "On which side of it particles are", choice_of(p.particles, wall_side_words));
}

static void describe(Schema& s, TubeKeys& p)
{
    s.required("from", p.from, "m", "Beginning of its axis");
    s.required("to", p.to, "m", "End of its axis; both ends are open");
    s.required("radius", p.radius, "m", "Its radius at the beginning", positive);
    s.value("end_radius", p.end_radius, "m", "Its radius at the end, which makes it a cone; without it, the same", positive);
}

static void describe(Schema& s, DiscKeys& p)
{
    s.required("point", p.point, "m", "Its middle");
    s.required("normal", "Direction at right angles to it", direction_of(p.normal));
    s.required("radius", p.radius, "m", "Its radius", positive);
    s.value("hole", p.hole, "m", "Radius of a hole in its middle", not_negative);
}

static void describe(Schema& s, StlKeys& p)
{
    s.required("file", p.file, "", "An STL file, text or binary; particles meet both sides of its triangles");
    s.value("unit", p.unit, "m", "What 1 means in the file, for example '1 mm'", positive);
    s.value("at", p.at, "m", "Where the origin of the file lies");
    s.value("smooth_angle", p.smooth_angle, "rad", "Triangles that meet at a smaller angle are one round surface", between(0.0, 1.0));
    s.value("particles", "On which side of a closed surface particles are: none are placed on the other; without it, on both",
            choice_of(p.particles, wall_side_words));
}

static void describe(Schema& s, RotationKeys& p)
{
    s.required("point", p.point, "m", "A point of the axis at the start; the axis goes along with the wall");
    s.required("axis", "Direction of the axis; the wall turns about it by the right-hand rule", direction_of(p.axis));
    s.required("rate", p.rate, "rad/s", "Angular velocity, for example '15 rpm'; negative turns the other way");
}

static void describe(Schema& s, OscillationKeys& p)
{
    s.required("amplitude", p.amplitude, "m", "Vector that it sways by, to both sides");
    s.required("frequency", p.frequency, "Hz", "Swings in a second", positive);
    s.value("phase", p.phase, "rad", "Phase of the sine at the start; the wall begins where the scene says with any phase");
}

static void describe(Schema& s, MotionKeys& p)
{
    s.value("velocity", p.velocity, "m/s", "Velocity of all of it");
    s.group("rotation", p.rotation, "Makes it turn");
    s.group("oscillation", p.oscillation, "Makes it sway to and fro");
    s.value("start", p.start, "s", "Time at which it begins to move", not_negative);
    s.value("stop", p.stop, "s", "Time at which it comes to a halt; without it, it moves on", positive);
}

void describe(Schema& s, WallKeys& p)
{
    s.required("name", p.name, "", "Name in metrics and messages");
    s.value("material", p.material, "", "What it is made of, for contact.pairs and contact.materials; without it, 'wall'");
    s.exactly_one({"plane", "cylinder", "tube", "disc", "stl"});
    s.group("plane", p.plane, "An endless plane");
    s.group("cylinder", p.cylinder, "An endless cylinder");
    s.group("tube", p.tube, "A cylinder or cone with open ends; particles meet it from both sides");
    s.group("disc", p.disc, "A disc; particles meet it from both sides");
    s.group("stl", p.stl, "A surface of triangles from a file");
    s.group("motion", p.motion, "How it moves; while particles settle before t = 0 it does not. Fluids do not feel it");
}

} // namespace io
