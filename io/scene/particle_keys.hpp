// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The particles of a scene, as the user describes them.
#include "io/scene/region_keys.hpp"
#include "io/scene/size_keys.hpp"
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

class Schema;

// Enumerations stand with their words, in the same order.

enum class Arrangement { random, lattice, packed, dense };
inline constexpr std::array<std::string_view, 4> arrangement_words{"random", "lattice", "packed", "dense"};

enum class Overlaps { keep, relax };
inline constexpr std::array<std::string_view, 2> overlaps_words{"keep", "relax"};

/// Where the particles of a species are at the start.
struct Initial {
    Arrangement arrangement = Arrangement::random;
    RegionKeys region;                        ///< of the centres; the whole domain without it
    core::Vec3 velocity = core::Vec3::Zero(); ///< [m/s]
    double spacing = 1.0;                     ///< packed: distance of neighbours in diameters; below 1 they press on each other.
    Overlaps overlaps = Overlaps::keep;
    bool operator==(const Initial&) const = default;
};

/// Particles that come in while the run goes on: a number of them in a time, or a mass.
struct InflowKeys {
    std::optional<double> rate;               ///< [1/s]
    std::optional<double> mass_rate;          ///< [kg/s]
    RegionKeys region;                        ///< of the centres
    core::Vec3 velocity = core::Vec3::Zero(); ///< [m/s]
    double begin = 0.0;                       ///< [s]
    std::optional<double> end;                ///< [s]
    bool operator==(const InflowKeys&) const = default;
};

/// One of count, volume_fraction and file; one of diameter, sizes and file.
struct Species {
    std::string name;
    std::string material;                  ///< empty: of its own name
    std::optional<int> count;              ///< at the start
    std::optional<double> volume_fraction; ///< what they fill of their room; resolved to a count
    std::string file;                      ///< where their places and sizes are
    std::optional<double> diameter;        ///< [m]
    std::optional<SizeKeys> sizes;         ///< instead of the one diameter
    double density = 0.0;                  ///< [kg/m3]
    Initial initial;
    std::optional<InflowKeys> inflow;
    bool operator==(const Species&) const = default;
};

/// A region that particles do not leave: those whose centre comes into it are taken away.
struct Outlet {
    std::string name;
    RegionKeys region;
    bool operator==(const Outlet&) const = default;
};

void describe(Schema& s, Initial& p);
void describe(Schema& s, InflowKeys& p);
void describe(Schema& s, Species& p);
void describe(Schema& s, Outlet& p);

} // namespace io
