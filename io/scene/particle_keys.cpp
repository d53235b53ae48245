// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/particle_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {

void describe(Schema& s, Initial& p)
{
    s.value(
        "arrangement",
        "Where the particles are at the start: at random without touching; on a cubic lattice; packed in face-centred cubes from wall to "
        "wall; dense at random, up to random close packing. That of the first species without a file for all",
        choice_of(p.arrangement, arrangement_words));
    describe(s, p.region);
    s.value("velocity", p.velocity, "m/s", "Their velocity");
    s.value("spacing", p.spacing, "1",
            "Packed: distance of neighbours in largest diameters, as near as whole cubes fit; below 1 a bed is squeezed "
            "and holds itself",
            positive);
    s.value("overlaps", "Relax: before the start all particles are pushed apart until none overlaps, whatever their arrangement",
            choice_of(p.overlaps, overlaps_words));
}

void describe(Schema& s, InflowKeys& p)
{
    s.exactly_one({"rate", "mass_rate"});
    s.value("rate", p.rate, "1/s", "Particles that come in, per time", positive);
    s.value("mass_rate", p.mass_rate, "kg/s", "Mass of particles that comes in, per time", positive);
    describe(s, p.region);
    s.value("velocity", p.velocity, "m/s", "Velocity with which they come in");
    s.value("begin", p.begin, "s", "When they begin to come", not_negative);
    s.value("end", p.end, "s", "When they cease to come; without it, never", positive);
}

void describe(Schema& s, Outlet& p)
{
    s.required("name", p.name, "", "Name in metrics.csv");
    describe(s, p.region);
}

void describe(Schema& s, Species& p)
{
    s.required("name", p.name, "", "Name in results and messages");
    s.value("material", p.material, "",
            "What they are made of, for contact.pairs and contact.materials; several species may share it. Without it, their own name");
    s.exactly_one({"count", "volume_fraction", "file"});
    s.value("count", p.count, "", "Number of particles at the start", at_least(0));
    s.value("volume_fraction", p.volume_fraction, "1", "Share of their room that they fill at the start, instead of a count",
            between(0.0, 0.74));
    s.value("file", p.file, "",
            "A table of particles (x, y, z, diameter, density, species; or with a velocity), or a checkpoint of another run");
    s.exactly_one({"diameter", "sizes", "file"});
    s.value("diameter", p.diameter, "m", "Diameter of all of them", positive);
    s.group("sizes", p.sizes, "Distribution of their diameters");
    s.required("density", p.density, "kg/m3", "Density", positive);
    s.group("initial", p.initial, "Where they are at the start");
    s.group("inflow", p.inflow, "More of them that come in while the run goes on");
}

} // namespace io
