// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What the grains of each cell come to: fraction, mean motion, granular temperature, contacts and stress; with a fluid or without.
#include "io/files/field_views.hpp"
#include "io/scene/scene.hpp"

namespace io {

class World;

/// Grains belong to the cell that holds their centre; cells should hold several. Sums run over the grains of a cell in the order of their
/// ids: the same bits on any number of ranks. Found when asked for, without messages.
class GrainFields {
public:
    explicit GrainFields(const World& world);
    /// @pre every grain on the rank that owns its place
    void find(const World& world);

    /// Volume of the grains over that of the cell [-].
    [[nodiscard]] const core::ScalarField& fraction() const { return fraction_; }
    /// Mean over their mass; 0 in empty cells [m/s].
    [[nodiscard]] const core::VectorField& velocity() const { return velocity_; }
    /// A third of the mean square of velocities against their mean, by mass [m2/s2].
    [[nodiscard]] const core::ScalarField& temperature() const { return temperature_; }
    /// Mean number of contacts with others, and with walls; empty unless the scene measures contacts [-].
    [[nodiscard]] const std::vector<core::ScalarField>& contacts() const { return contacts_; }
    /// xx yy zz yz zx xy of contacts, with walls, too, and of velocities against their mean, positive under pressure; empty unless the scene measures
    /// contacts [Pa].
    [[nodiscard]] const std::vector<core::ScalarField>& stress() const { return stress_; }

    /// All that are measured.
    [[nodiscard]] std::vector<FieldViews<const double>> all() const;

private:
    struct Cell;
    void write(core::LocalBlock block, const core::Index3& cell, const Cell& sums, double volume);

    core::ScalarField fraction_;
    core::VectorField velocity_;
    core::ScalarField temperature_;
    std::vector<core::ScalarField> contacts_, stress_;
};

/// For every cell of all ranks, in the order of blocks: grains of the first species, and all others. Collective.
[[nodiscard]] std::vector<std::array<std::int64_t, 2>> species_in_cells(const World& world);

/// Lacey's index of mixing from the counts of two kinds in cells: 0 where each cell holds one kind, 1 where chance has dealt them; 0 for a
/// single kind.
/// @source  Lacey (1954), J. Appl. Chem. 4, 257; variances weighted by the number in each cell, that of chance without replacement.
[[nodiscard]] double lacey_index(const std::vector<std::array<std::int64_t, 2>>& cells);

} // namespace io
