// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fields that pass through the coupling filter side by side: coefficients and neighbours of a cell are looked up once for
// all of them, and each is a lane of one vector register.
#include "core/base/team.hpp"
#include "physics/coupling/filter_polynomial.hpp"
#include "physics/fluid/multigrid_messages.hpp"
#include <array>
#include <functional>

namespace physics {

/// The Laplacian over its largest diagonal entry, as the passes read it.
struct FilterOperator {
    explicit FilterOperator(LevelMesh m) : mesh(std::move(m)), cells(mesh.layout.size()), half(mesh.halves.size(), 0.0) {}

    struct alignas(32) Cell {
        std::array<double, 3> low_face{}; ///< transmissibility; zero on the boundary of a block [m]
        double weight = 0.0;              ///< 1 / (volume * largest diagonal entry) [1/m]
    };
    LevelMesh mesh;
    std::vector<Cell> cells;
    std::vector<double> half; ///< of each half link: its transmissibility times the weight of its cell [-]
    FilterPolynomial polynomial;
};

/// Field n of a batch as its part in block b.
using FieldsIn = std::function<core::View<const double>(core::LocalBlock b, int n)>;
using FieldsOut = std::function<core::View<double>(core::LocalBlock b, int n)>;

class FilterGroup {
public:
    static constexpr int width = 8; ///< fields; fewer would not be faster

    /// @param filter  Must outlive the group.
    explicit FilterGroup(const FilterOperator& filter);

    /// Takes in fields [first, first + count), 0 < count <= width; the other lanes are copies of the last.
    void put(const core::Team& team, int first, int count, const FieldsIn& fields);
    /// Gives them back.
    void take(const core::Team& team, int first, int count, const FieldsOut& fields) const;
    /// Starts the exchange of the ghosts that pass `number` needs.
    void start_ghosts(int number, const core::Communicator& communicator, core::Pending& pending);
    /// One of degree() passes, 1, 2, ...
    void pass(const core::Team& team, int number);

private:
    /// The same cell of all fields.
    struct alignas(8 * width) Lanes {
        double field[width];
    };
    template <class Finish, class Correct>
    void sweep(const core::Team& team, int number, Finish finish, Correct correct) const;
    void explicit_step(const core::Team& team, int number);
    void first_term(const core::Team& team);
    void next_term(const core::Team& team, int number);
    [[nodiscard]] const std::vector<Lanes>& before(int number) const { return value_[std::size_t(number + 1) % 2]; }
    [[nodiscard]] std::vector<Lanes>& after(int number) { return value_[std::size_t(number) % 2]; }

    const FilterOperator* filter_;
    std::array<std::vector<Lanes>, 2> value_; ///< after the last two passes
    std::vector<Lanes> sum_;                  ///< of Chebyshev terms
    LevelMessages messages_;
};

} // namespace physics
