// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How the particles of a scene collide with each other and with walls, as the user describes it.
#include "physics/particles/parameters.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;
class Locations;
class Problems;
struct Scene;

// Enumerations stand with their words, in the same order.

using ContactLaw = physics::ContactModel;
inline constexpr std::array<std::string_view, 2> contact_law_words{"linear", "hertz"};

using physics::RollingModel;
inline constexpr std::array<std::string_view, 2> rolling_model_words{"constant", "spring"};

enum class WallShape { faces, primitive, none };
inline constexpr std::array<std::string_view, 3> wall_shape_words{"faces", "primitive", "none"};

/// The material of walls that name none.
inline constexpr std::string_view wall_word = "wall";

/// The material of a side of the grid.
struct ContactSide {
    std::string at, material;
    bool operator==(const ContactSide&) const = default;
};

/// Elastic constants of a material, where they are not those of all.
struct ContactMaterial {
    std::string of;
    double young_modulus = 0.0; ///< [Pa]
    double poisson_ratio = 0.0;
    bool operator==(const ContactMaterial&) const = default;
};

/// What is different between two materials.
struct ContactPair {
    std::array<std::string, 2> between;
    std::optional<ContactLaw> law;
    std::optional<double> stiffness; ///< [N/m]
    std::optional<double> restitution, friction, rolling_friction, twisting_friction;
    std::optional<double> cohesion; ///< [J/m2]
    bool operator==(const ContactPair&) const = default;
};

struct Contact {
    ContactLaw law = ContactLaw::linear;
    std::optional<double> stiffness;      ///< linear: normal [N/m]
    std::optional<double> collision_time; ///< linear: instead of the stiffness [s]
    std::optional<double> young_modulus;  ///< hertz: of particles and walls [Pa]
    std::optional<double> poisson_ratio;
    double restitution = 0.6;
    double friction = 0.4;
    double tangential_ratio = 2.0 / 7.0; ///< tangential over normal stiffness
    RollingModel rolling = RollingModel::spring;
    double rolling_friction = 0.0, twisting_friction = 0.0;
    double cohesion = 0.0;              ///< [J/m2]
    std::optional<double> impact_speed; ///< hertz: of the fastest impacts [m/s]
    int steps_per_contact = 30;
    WallShape walls = WallShape::faces;
    std::vector<ContactSide> sides;
    std::vector<ContactMaterial> materials;
    std::vector<ContactPair> pairs;
    bool operator==(const Contact&) const = default;
};

void describe(Schema& s, ContactSide& p);
void describe(Schema& s, ContactMaterial& p);
void describe(Schema& s, ContactPair& p);
void describe(Schema& s, Contact& p);

/// Names that exist, each pair once, and what the laws need.
void check_contact(const Scene& scene, const Locations& locations, Problems& problems);

} // namespace io
