// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One unknown of a linear system with all that the full operator needs: halos, gradients, fluxes. Vectors of the solver
// are flat; here they are spread over the blocks.
#include "core/grid/mesh.hpp"
#include "physics/fluid/block_layout.hpp"
#include "physics/fluid/boundary_halo.hpp"
#include "physics/fluid/diffusion.hpp"
#include "physics/fluid/mesh_links.hpp"
#include "physics/fluid/viscosity_ratio.hpp"
#include "tasks/stage_graph.hpp"
#include <optional>

namespace physics {

/// Parts of the run that every system of equations refers to; all must outlive it.
struct SystemContext {
    const core::Mesh& mesh;
    const std::vector<BlockWalls>& walls; ///< of each block of this rank
    tasks::HaloFiller& halos;
    bool pressure_is_given = false;                  ///< on some boundary of the domain
    bool walls_slip = false;                         ///< somewhere in the domain
    const ViscosityRatio* viscosity_ratio = nullptr; ///< none: 1 everywhere
    bool is_straight = false;                        ///< All blocks of the domain are: no flux asks for the gradients in cells.

    [[nodiscard]] FaceFactors viscosity_factors(core::LocalBlock b) const
    {
        return viscosity_ratio ? viscosity_ratio->on(b) : std::nullopt;
    }
};

class Unknown {
public:
    /// Allocates. Collective.
    Unknown(const SystemContext& context, const BlockLayout& layout, const std::string& name);

    /// Calls body(block) for every block, on the team of the lane.
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(context_.mesh.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    /// Spreads `in`, fills halos, mirrors at boundaries, forms the fluxes of the gradient.
    /// @param component  Of a change of velocity; none: `in` is a change of pressure.
    /// @post flux holds the compact flux of grad `in`.
    tasks::Job form_fluxes(tasks::Lane& lane, std::optional<int> component, std::span<const double> in);

    core::ScalarField value;
    core::VectorField gradient;
    core::FaceField flux;

private:
    SystemContext context_;
    const BlockLayout& layout_;
};

} // namespace physics
