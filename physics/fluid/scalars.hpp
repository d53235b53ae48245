// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a fluid carries without being changed by it: dye, heat, salt.
#include "core/grid/mesh.hpp"
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace physics {

struct ScalarParameters {
    std::string name;
    double diffusivity = 0;                   ///< [m2/s]
    double initial = 0;                       ///< everywhere
    std::map<std::string, double> entering{}; ///< value of what flows in, by boundary; elsewhere that of the cells inside
};

/// What a scalar is in fluid that enters through each side of a block; none: the value of the cells inside.
using EntryValues = std::array<std::optional<double>, 6>;

/// One entry for each block of this rank.
[[nodiscard]] inline std::vector<EntryValues> entry_values(const core::Mesh& mesh, const std::map<std::string, double>& by_name)
{
    std::vector<EntryValues> values(std::size_t(mesh.own_count()));
    for (const core::Boundary& boundary : mesh.topology().boundaries)
        if (const auto given = by_name.find(boundary.name); given != by_name.end() && mesh.local(boundary.block) >= 0)
            values[std::size_t(mesh.local(boundary.block))][std::size_t(boundary.side)] = given->second;
    return values;
}

/// The fields that are carried, and the share of each cell that the fluid which carries them fills.
struct ScalarSet {
    ScalarSet(const core::Mesh& mesh, const std::vector<ScalarParameters>& scalars)
        : share({"share of the carrier", "1", 0, true}, mesh.own_cells())
    {
        share.allocate();
        for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) std::fill(share.data(b, 0).begin(), share.data(b, 0).end(), 1.0);
        for (const ScalarParameters& scalar : scalars) {
            values.emplace_back(core::FieldInfo{scalar.name, "", 1, true}, mesh.own_cells());
            values.back().allocate();
            for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
                std::fill(values.back().data(b, 0).begin(), values.back().data(b, 0).end(), scalar.initial);
        }
    }

    std::deque<core::ScalarField> values; ///< in the order of their parameters; a deque: fields are known by their address
    core::ScalarField share;              ///< w: 1, or the fluid fraction, to what the solver of the pressure leaves [-]
};

} // namespace physics
