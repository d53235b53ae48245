// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Implicit diffusion of a scalar, and what consumes it: V (w + dt s) q' - dt share div(D grad q') = V source + dt (1 - share)
// div(D grad q). Nothing diffuses through boundaries.
#include "physics/fluid/krylov.hpp"
#include "physics/steps/diffusion_multigrid.hpp"

namespace physics {

/// One equation; fields of which only the interior is read.
struct DiffusionEquation {
    const core::FaceField& diffusivity;      ///< w D on faces [m2/s]
    const core::ScalarField& capacity;       ///< w + dt s [-]
    const core::ScalarField& source;         ///< of the equation's right-hand side, without diffusion [unit of q]
    double dt;                               ///< [s]
    double tolerance = 1e-12;                ///< of the residual, relative to capacity times q, in the root mean square
    const core::ScalarField* free = nullptr; ///< 0 where q' = source / capacity whatever diffuses, else 1; none: 1 everywhere
};

class ScalarDiffusion {
public:
    /// @param pressure  Whose flat vectors and grids are used; must outlive the system. Collective.
    ScalarDiffusion(const SystemContext& context, const PressureSystem& pressure);

    /// Half of the diffusion takes the old values where that keeps them in their range, less where steps are too long for that: so
    /// it is second order in time for short steps, and nothing rings after long ones.
    /// @param q  Old values in, new out; one halo layer. What the solver leaves does not add to the sum of V (w + dt s) q.
    tasks::Job solve(tasks::Lane& lane, DiffusionEquation equation, core::ScalarField& q);

    /// Of the last solve: products with the operator.
    [[nodiscard]] int products() const { return products_; }

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    tasks::Job form_inflow(tasks::Lane& lane, core::ScalarField& q);
    tasks::Job choose_share(tasks::Lane& lane);
    /// The V-cycle, where it pays.
    tasks::Job prepare_multigrid(tasks::Lane& lane);
    tasks::Job form_right(tasks::Lane& lane, core::ScalarField& q);
    [[nodiscard]] const core::BlockGeometry& geometry(core::LocalBlock b) const { return context_.mesh.geometry(b); }
    [[nodiscard]] core::View<const double> part(core::LocalBlock b, std::span<const double> values) const
    {
        return {values.data() + layout_.origin(b), layout_.cells(b), 0};
    }
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(context_.mesh.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    SystemContext context_;
    const BlockLayout& layout_;
    KrylovWorkspace workspace_;
    core::ScalarField change_, inflow_, diagonal_, right_;
    core::VectorField gradient_;
    core::FaceField flux_;
    std::vector<double> residual_, solution_;
    const DiffusionEquation* equation_ = nullptr; ///< that is being solved
    DiffusionMultigrid multigrid_;
    bool by_multigrid_ = false;
    double number_ = 0.0;   ///< largest exchange of a cell in the step over its capacity
    double implicit_ = 1.0; ///< share of the new values
    int products_ = 0;
};

} // namespace physics
