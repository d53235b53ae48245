// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A V-cycle for implicit diffusion, capacity V x - div(factor grad x) = right: the pressure's grids with other coefficients. Built
// when the first equation comes for which it pays; until then it takes no memory.
#include "physics/steps/pressure_system.hpp"
#include <memory>

namespace physics {

class DiffusionMultigrid {
public:
    /// @param pressure  Whose grids are taken; must outlive this.
    DiffusionMultigrid(const SystemContext& context, const PressureSystem& pressure) : context_(context), pressure_(pressure) {}

    /// Does a V-cycle pay? Not where turbulence or grains make viscosity differ from cell to cell: coarse cells know nothing of jumps.
    /// @param number  Largest sum of a cell's diffusive exchange in the step over its capacity: twice its explicit limit would be 1.
    [[nodiscard]] bool pays(double number) const;

    /// Coefficients of the equation, to be filled for every block before set_up().
    struct Parts {
        core::FaceView<double> factor; ///< of the gradient, on all faces
        core::View<double> shift;      ///< capacity times volume, and what ties a cell to values that are given
    };
    /// Allocates when first called. No message.
    void prepare();
    [[nodiscard]] Parts parts(core::LocalBlock b) { return {factor_->on(b), shift_->on(b)}; }
    tasks::Job set_up(tasks::Lane& lane);
    /// Sizes of the right-hand sides to come.
    tasks::Job expect_right(tasks::Lane& lane, std::span<const double> right);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    SystemContext context_;
    const PressureSystem& pressure_;
    std::unique_ptr<SevenPointSolver> solver_; ///< none until it pays
    std::unique_ptr<core::FaceField> factor_;
    std::unique_ptr<core::ScalarField> shift_;
    std::vector<double> link_coefficients_;
};

} // namespace physics
