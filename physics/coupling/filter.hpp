// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The coupling filter S: diffusion over a pseudo-time bandwidth^2 / 4, hence a Gaussian exp(-r^2 / bandwidth^2), as a
// polynomial of fixed degree in the conservative Laplacian. Symmetric in the volume-weighted product, keeps constants and
// volume sums to round-off; all fields of a batch share one pass over the coefficients.
#include "core/base/team.hpp"
#include "physics/fluid/multigrid_messages.hpp"
#include "physics/fluid/seven_point.hpp"
#include <functional>
#include <span>
#include <vector>

namespace physics {

struct FilterOptions {
    double bandwidth = 0.0;    ///< [m]
    double undershoot = 1e-6;  ///< a single filled cell may become negative elsewhere by this part of its content
    int most_degree = 1000;
    int fields = 16;           ///< most fields in one batch
};

/// exp(-a (1 + y)) on -1 <= y <= 1 as a sum of Chebyshev polynomials, cut where the rest is below `tolerance` and scaled so
/// that its value at y = -1 is 1.
/// @return coefficients of T_0, T_1, ...
/// @source  Abramowitz & Stegun 9.6.34: the coefficients are modified Bessel functions.
[[nodiscard]] std::vector<double> chebyshev_exponential(double a, double tolerance);

class Filter {
public:
    Filter(const BlockTopology& topology, const FilterOptions& options);

    /// @param transmissibility  Area over distance of faces and links [m]; without shift.
    /// @param volume            Of the cells [m3].
    void load(const core::Team& team, const Coefficients& transmissibility, const core::ScalarField& volume);
    /// Bound of the eigenvalues of the Laplacian on this rank [1/m2].
    [[nodiscard]] double eigenvalue_bound() const;
    /// Chooses the polynomial.
    /// @param bound  Largest eigenvalue_bound() of all ranks.
    /// @throws ConfigError if the degree is beyond most_degree: cells far thinner than the bandwidth.
    void set_bound(double bound);
    /// Most fields in one batch.
    [[nodiscard]] int room() const { return options_.fields; }
    [[nodiscard]] int degree() const { return int(coefficients_.size()) - 1; }

    /// Field `n` of the batch in and out: a density, that is a quantity per volume, as its part in each block.
    void put(const core::Team& team, int n, const std::function<core::View<const double>(core::LocalBlock)>& density);
    void take(const core::Team& team, int n, const std::function<core::View<double>(core::LocalBlock)>& density) const;
    void put(const core::Team& team, int n, const core::ScalarField& density)
    {
        put(team, n, [&](core::LocalBlock b) { return density.on(b); });
    }
    void take(const core::Team& team, int n, core::ScalarField& density) const
    {
        take(team, n, [&](core::LocalBlock b) { return density.on(b); });
    }

    /// Filters the first `fields` of the batch on one rank.
    void run(const core::Team& team, int fields);
    /// One of degree() passes, 1, 2, ...; between passes the ghosts of the batch are exchanged.
    void pass(const core::Team& team, int number, int fields);
    /// Starts the exchange of the ghosts that pass `number` needs.
    void start_ghosts(int number, int fields, const core::Communicator& communicator, core::Pending& pending);
    [[nodiscard]] bool has_ghosts() const { return !mesh_.exchanges.empty(); }
    [[nodiscard]] const BlockLayout& layout() const { return mesh_.layout; }

private:
    /// The same cell of several fields: coefficients and neighbours are looked up once for all of them.
    struct alignas(64) Octet {
        double field[8];
    };
    static constexpr int fields_per_octet = 8;
    /// Fields 8 g to 8 g + 7, flat as in BlockLayout.
    struct Group {
        std::vector<Octet> sum;              ///< of the terms so far
        std::array<std::vector<Octet>, 2> t; ///< the last two Chebyshev polynomials times the fields
    };
    void pass_piece(int piece, int number, Group& group);

    FilterOptions options_;
    std::vector<int> link_source_;
    LevelMesh mesh_;
    SevenPoint<double> matrix_;
    std::vector<double> inverse_volume_;
    double bound_ = 0.0;
    std::vector<double> coefficients_{1.0};
    std::vector<Group> groups_;
    std::vector<LevelMessages> messages_;
};

} // namespace physics
