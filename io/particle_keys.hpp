// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a scene and how they collide, as the user describes them.
#include "core/base/vec3.hpp"
#include "io/size_keys.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

// Enumerations stand with their words, in the same order.

enum class Arrangement { random, lattice, packed };
inline constexpr std::array<std::string_view, 3> arrangement_words{"random", "lattice", "packed"};

enum class ContactLaw { linear };
inline constexpr std::array<std::string_view, 1> contact_law_words{"linear"};

enum class WallShape { faces, primitive };
inline constexpr std::array<std::string_view, 2> wall_shape_words{"faces", "primitive"};

/// Where the particles of a species are at the start.
struct Initial {
    Arrangement arrangement = Arrangement::random;
    std::optional<core::Vec3> low, high;      ///< Corners of the region of the centres [m]; the whole domain without them.
    core::Vec3 velocity = core::Vec3::Zero(); ///< [m/s]
    double spacing = 1.0;                     ///< packed: distance of neighbours in diameters; below 1 they press on each other.
    bool operator==(const Initial&) const = default;
};

struct Species {
    std::string name;
    int count = 0;
    std::optional<double> diameter; ///< [m]
    std::optional<SizeKeys> sizes;  ///< instead of the one diameter
    double density = 0.0;           ///< [kg/m3]
    Initial initial;
    bool operator==(const Species&) const = default;
};

struct Contact {
    ContactLaw law = ContactLaw::linear;
    double stiffness = 0.0; ///< normal [N/m]
    double restitution = 0.6;
    double friction = 0.4;
    double tangential_ratio = 2.0 / 7.0; ///< tangential over normal stiffness
    int steps_per_contact = 30;
    WallShape walls = WallShape::faces;
    bool operator==(const Contact&) const = default;
};

void describe(Schema& s, Initial& p);
void describe(Schema& s, Species& p);
void describe(Schema& s, Contact& p);

} // namespace io
