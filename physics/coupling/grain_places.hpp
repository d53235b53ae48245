// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where the grains of a rank lie among the cells: the operator B of the exchange (sample) and its transpose (deposit),
// before the filter (NUMERICS B0, B3). Grains are visited in the order of their ids, so that no sum depends on how they
// are stored or shared among ranks.
#include "core/field/sample.hpp"
#include "core/particles/domain.hpp"
#include "core/particles/particle_set.hpp"
#include "physics/coupling/grid_spread.hpp"
#include <span>
#include <unordered_map>

namespace physics {

class GrainPlaces {
public:
    /// Finds the cell of every owned grain, starting from where it was.
    /// @throws NumericsError naming a grain that lies in no cell of this rank's blocks.
    void locate(const core::Mesh& mesh, const core::Locator& locator, const core::Domain& domain, const core::ParticleSet& grains);

    /// Indices of the grains in a block, by ascending id.
    [[nodiscard]] std::span<const int> in_block(core::LocalBlock b) const
    {
        return {order_.data() + first_[std::size_t(b)], order_.data() + first_[std::size_t(b) + 1]};
    }
    [[nodiscard]] const core::HatStencil& stencil(int grain) const { return stencils_[std::size_t(grain)]; }
    /// How wide the hats spread what a grain deposits. @param geometry  Of the grain's block.
    [[nodiscard]] GridSpread spread(int grain, const core::BlockGeometry& geometry) const;
    [[nodiscard]] const core::Location& location(int grain) const { return locations_[std::size_t(grain)]; }

    /// Adds the quantity of each grain of the block to the cells round it; halos still have to go home.
    void deposit(core::LocalBlock b, std::span<const double> quantity, core::View<double> field) const;
    /// Sets the value at each grain of the block; the first halo layer of the field must be filled, walls included.
    void sample(core::LocalBlock b, core::View<const double> field, std::span<double> value) const;
    /// The same for fields of one shape, one column each: bits are the same.
    void sample(core::LocalBlock b, std::span<const core::View<const double>> fields, std::span<std::vector<double>> columns) const;

private:
    void sort_into_blocks(const core::Mesh& mesh, const core::ParticleSet& grains);

    std::vector<core::Location> locations_; ///< of each owned grain
    std::vector<core::HatStencil> stencils_;
    std::unordered_map<std::int64_t, core::Location> last_; ///< by id: where to begin the search, which no result depends on
    std::vector<int> order_, first_;
};

} // namespace physics
