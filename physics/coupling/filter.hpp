// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The coupling filter S: diffusion over a pseudo-time bandwidth^2 / 4, hence a Gaussian exp(-r^2 / bandwidth^2), as a
// polynomial of fixed degree in the conservative Laplacian. Symmetric in the volume-weighted product, keeps constants and
// volume sums to round-off. Its second moment is exact; where explicit steps do, it makes nothing negative.
#include "physics/coupling/filter_group.hpp"
#include <vector>

namespace physics {

struct FilterOptions {
    double bandwidth = 0.0;   ///< [m]
    int most_steps = 100;     ///< explicit; beyond, where cells are thin, fewer Chebyshev terms do
    double undershoot = 1e-6; ///< of those: a single filled cell may become negative elsewhere by this part of its content
    int most_degree = 1000;
    int fields = 16; ///< most fields in one batch
};

class Filter {
public:
    Filter(const BlockTopology& topology, const FilterOptions& options);
    Filter(const Filter&) = delete;
    Filter& operator=(const Filter&) = delete;

    /// @param transmissibility  Of faces and links, as spreading() in mesh_links.hpp [m]; without shift.
    /// @param volume            Of the cells [m3].
    void load(const core::Team& team, const Coefficients& transmissibility, const core::ScalarField& volume);
    /// Bound of the eigenvalues of the Laplacian on this rank [1/m2].
    [[nodiscard]] double eigenvalue_bound() const { return own_bound_; }
    /// Chooses the polynomial. @pre load()
    /// @param bound  Largest eigenvalue_bound() of all ranks.
    /// @throws ConfigError if the degree is beyond most_degree: cells far thinner than the bandwidth.
    void set_bound(double bound);
    /// Most fields in one batch.
    [[nodiscard]] int room() const { return options_.fields; }
    [[nodiscard]] int degree() const { return operator_.polynomial.degree(); }

    /// A batch of fields in and out: densities, that is quantities per volume.
    void put(const core::Team& team, int fields, const FieldsIn& densities);
    void take(const core::Team& team, int fields, const FieldsOut& densities) const;

    /// Filters the batch where no ghosts are.
    void run(const core::Team& team, int fields);
    /// One of degree() passes, 1, 2, ...; between passes the ghosts of the batch are exchanged.
    void pass(const core::Team& team, int number, int fields);
    /// Starts the exchange of the ghosts that pass `number` needs.
    void start_ghosts(int number, int fields, const core::Communicator& communicator, core::Pending& pending);
    [[nodiscard]] bool has_ghosts() const { return !operator_.mesh.exchanges.empty(); }
    [[nodiscard]] const BlockLayout& layout() const { return operator_.mesh.layout; }

private:
    /// Calls body(group, number of its first field, its number of fields) for the groups that hold `fields`.
    template <class Groups, class Body>
    static void for_groups(Groups& groups, int fields, Body body)
    {
        for (int first = 0; first < fields; first += FilterGroup::width)
            body(groups[std::size_t(first / FilterGroup::width)], first, std::min(FilterGroup::width, fields - first));
    }

    FilterOptions options_;
    std::vector<int> link_source_;
    FilterOperator operator_;
    double own_bound_ = 0.0;
    std::vector<FilterGroup> groups_;
};

} // namespace physics
