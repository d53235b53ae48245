// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Implicit viscosity for all components of a velocity at once, as one unknown: for domains with seams that turn. Each component
// beyond such a seam is made of all those on this side, so that components solved in turn would settle slowly.
#include "physics/fluid/krylov.hpp"
#include "physics/steps/unknown.hpp"
#include <functional>

namespace physics {

class JoinedComponents {
public:
    /// The equation of one component; all components have the same, but for what joins them.
    struct Equation {
        double diffusion; ///< share * dt * viscosity [m2]
        /// Makes ready for right-hand sides of some size.
        std::function<tasks::Job(tasks::Lane&, std::span<const double>)> expect_right;
        /// Preconditions one component.
        std::function<tasks::Job(tasks::Lane&, std::span<const double>, std::span<double>)> precondition;
    };

    /// @param layout  Of flat vectors of one component; must outlive this. Collective.
    JoinedComponents(const SystemContext& context, const BlockLayout& layout);

    /// Finds the change of velocity that leaves no residual.
    /// @param options    Tolerances of all components together.
    /// @param residual   [m4/s]
    /// @param gaining    Both gain what is found [m/s].
    /// @param[out] iterations  Products with the operator.
    tasks::Job solve(tasks::Lane& lane, const Equation& equation, const KrylovOptions& options, const core::VectorField& residual,
                     std::array<core::VectorField*, 2> gaining, int& iterations);

    tasks::Job apply(tasks::Lane& lane, std::span<const double> in, std::span<double> out);
    tasks::Job precondition(tasks::Lane& lane, std::span<const double> in, std::span<double> out);

private:
    template <class T>
    [[nodiscard]] core::View<T> component(core::LocalBlock b, int c, std::span<T> all) const;
    template <class Body>
    void for_blocks(tasks::Lane& lane, Body body) const
    {
        lane.team().run(context_.mesh.own_count(), [&](int b) { body(core::LocalBlock(b)); });
    }

    SystemContext context_;
    const BlockLayout& single_;
    BlockLayout layout_; ///< the components of a block one after the other
    KrylovWorkspace workspace_;
    core::VectorField value_;
    core::TensorField gradient_; ///< of the components; unused where all faces are straight
    core::FaceField flux_;
    std::vector<double> right_, solution_, single_in_, single_out_;
    const Equation* equation_ = nullptr; ///< that is being solved
};

} // namespace physics
