// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The discrete Poisson system of a block: its residual with spline derivatives, and steps towards its solution.
#include "core/grid/control_functions.hpp"
#include "core/grid/sparse_solve.hpp"

namespace core {

/// Holds the derivatives of the present vertices, and solves for their next move.
class EllipticSystem {
public:
    EllipticSystem(Extents vertices, Curvature kind);

    /// One step with frozen metrics: central differences on the left, the residual with spline derivatives on the right.
    /// @param relaxation  Of the move.
    /// @return largest move of a vertex [m].
    double advance(Vertices& block, const ControlFunctions& control, double relaxation);

private:
    struct Coefficients {
        std::array<double, 3> pure;  ///< J^2 g^pp
        std::array<double, 3> mixed; ///< 2 J^2 g^qr, opposite to p
        std::array<double, 3> first; ///< of dx/dxi_m
    };
    void differentiate(const Vertices& block);
    [[nodiscard]] Coefficients coefficients(Index3 c, const ControlFunctions& control) const;
    [[nodiscard]] Vec3 residual(const Vertices& block, Index3 c, const Coefficients& a) const;
    void add_row(Index3 c, const Coefficients& a, double scale);
    [[nodiscard]] int number(Index3 c) const; ///< of an inner vertex, or -1

    Extents extents_;
    Curvature kind_;
    std::array<Array3<Vec3>, 3> slope_, curvature_;
    std::vector<Eigen::Triplet<double>> entries_;
    SparseSolver solver_;
};

} // namespace core
