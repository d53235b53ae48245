// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/particle_keys.hpp"
#include "io/schema.hpp"

namespace io {

void describe(Schema& s, Initial& p)
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

void describe(Schema& s, Species& p)
{
    s.required("name", p.name, "", "Name in results and messages");
    s.required("count", p.count, "", "Number of particles", at_least(0));
    s.exactly_one({"diameter", "sizes"});
    s.value("diameter", p.diameter, "m", "Diameter of all of them", positive);
    s.group("sizes", p.sizes, "Distribution of their diameters");
    s.required("density", p.density, "kg/m3", "Density", positive);
    s.group("initial", p.initial, "Where they are at the start");
}

void describe(Schema& s, Contact& p)
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

} // namespace io
