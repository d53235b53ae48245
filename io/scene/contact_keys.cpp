// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/contact_keys.hpp"
#include "io/scene/schema.hpp"

namespace io {
namespace {

constexpr Range restitution_range = between(0.01, 1.0);

} // namespace

void describe(Schema& s, ContactSide& p)
{
    s.required("at", p.at, "", "Name of the side, as in fluid.boundaries");
    s.required("material", p.material, "", "What it is made of");
}

void describe(Schema& s, ContactMaterial& p)
{
    s.required("of", p.of, "", "Name of a material: of a species its name unless it says another, of walls 'wall'");
    s.required("young_modulus", p.young_modulus, "Pa", "Young's modulus", positive);
    s.required("poisson_ratio", p.poisson_ratio, "1", "Poisson's ratio", between(0.0, 0.5));
}

void describe(Schema& s, ContactPair& p)
{
    s.required("between", p.between, "", "Names of two materials: of a species its name unless it says another, of walls 'wall'");
    s.value("law", "Their contact law", choice_of(p.law, contact_law_words));
    s.value("stiffness", p.stiffness, "N/m", "Linear: their normal stiffness", positive);
    s.value("restitution", p.restitution, "1", "Their restitution", restitution_range);
    s.value("friction", p.friction, "1", "Their Coulomb coefficient", not_negative);
    s.value("rolling_friction", p.rolling_friction, "1", "Their coefficient of rolling friction", not_negative);
    s.value("twisting_friction", p.twisting_friction, "1", "Their coefficient of twisting friction", not_negative);
    s.value("cohesion", p.cohesion, "J/m2", "Their work of adhesion", not_negative);
}

void describe(Schema& s, Contact& p)
{
    s.value("law", "Contact law: linear springs and dashpots; or hertz, elastic spheres after Hertz and Mindlin",
            choice_of(p.law, contact_law_words));
    s.value("stiffness", p.stiffness, "N/m", "Linear: normal stiffness of a contact", positive);
    s.value("collision_time", p.collision_time, "s",
            "Linear: instead of the stiffness, how long a head-on contact of particles of mean mass lasts", positive);
    s.value("young_modulus", p.young_modulus, "Pa", "Hertz: Young's modulus of particles and walls", positive);
    s.value("poisson_ratio", p.poisson_ratio, "1", "Hertz: Poisson's ratio of particles and walls", between(0.0, 0.5));
    s.value("restitution", p.restitution, "1", "Normal speed after over before a dry collision", restitution_range);
    s.value("friction", p.friction, "1", "Coulomb coefficient between particles and with walls", not_negative);
    s.value("tangential_ratio", p.tangential_ratio, "1", "Linear: tangential over normal stiffness", between(0.0, 1.0));
    s.value("rolling", "Torque against rolling and twisting: constant; or of a spring that yields, which holds particles at rest",
            choice_of(p.rolling, rolling_model_words));
    s.value("rolling_friction", p.rolling_friction, "1", "Greatest torque against rolling over normal force and reduced radius",
            not_negative);
    s.value("twisting_friction", p.twisting_friction, "1", "Greatest torque against twisting over normal force and reduced radius",
            not_negative);
    s.value("cohesion", p.cohesion, "J/m2", "Work of adhesion w: surfaces that touch attract each other with 2 pi w R (DMT)", not_negative);
    s.value("impact_speed", p.impact_speed, "m/s",
            "Hertz: speed of the fastest impacts, for which the sub-step is made; without it, the greatest of the speeds in the scene "
            "and of a fall through the domain",
            positive);
    s.value("steps_per_contact", p.steps_per_contact, "", "Sub-steps in the shortest collision", at_least(20));
    s.value("walls", "What particles meet at the boundary of the grid: the faces of its cells, the exact pipe or box, or nothing",
            choice_of(p.walls, wall_shape_words));
    s.list("sides", p.sides, "Sides of the grid that are made of a material of their own");
    s.list("materials", p.materials, "Hertz: materials with elastic constants of their own");
    s.list("pairs", p.pairs, "What is different between two materials");
}

} // namespace io
