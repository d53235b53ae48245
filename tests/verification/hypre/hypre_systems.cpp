// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The pressure's systems solved by hypre's BoomerAMG, too. Built with -D ISAGO_HYPRE=ON, which needs Debian's libhypre-dev.
#include "tests/support/conduction_jumps.hpp"
#include "tests/support/conduction_pipe.hpp"
#include "tests/support/joined_boxes.hpp"
#include "tests/support/pressure_on_grid.hpp"
#include "tests/support/stretched_channel.hpp"
#include <Eigen/SparseCore>
#include <HYPRE.h>
#include <HYPRE_krylov.h>
#include <HYPRE_parcsr_ls.h>
#include <doctest/doctest.h>

namespace {

const core::SerialTeam serial;

/// Entries of a matrix by rows: what hypre wants of it.
struct Rows {
    std::vector<int> sizes, columns;
    std::vector<double> values;

    [[nodiscard]] int count() const { return int(sizes.size()); }
};

/// @param entries  Addends of entries.
Rows rows_of(int size, const std::vector<Eigen::Triplet<double>>& entries)
{
    Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(size, size);
    matrix.setFromTriplets(entries.begin(), entries.end());
    Rows rows;
    for (int r = 0; r < size; ++r) {
        const std::size_t before = rows.columns.size();
        for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(matrix, r); entry; ++entry) {
            // A singular matrix is made regular: the solution of a compatible system differs by a constant only.
            const bool pinned = r == 0 && entry.col() == 0;
            rows.columns.push_back(int(entry.col()));
            rows.values.push_back(pinned ? 2 * entry.value() : entry.value());
        }
        rows.sizes.push_back(int(rows.columns.size() - before));
    }
    return rows;
}

struct Solution {
    Eigen::VectorXd x;
    int iterations = 0;
};

/// A vector of hypre.
class Vector {
public:
    explicit Vector(const Eigen::VectorXd& values) : size_(int(values.size()))
    {
        HYPRE_IJVectorCreate(MPI_COMM_SELF, 0, size_ - 1, &vector_);
        HYPRE_IJVectorSetObjectType(vector_, HYPRE_PARCSR);
        HYPRE_IJVectorInitialize(vector_);
        HYPRE_IJVectorSetValues(vector_, size_, places().data(), values.data());
        HYPRE_IJVectorAssemble(vector_);
    }
    ~Vector() { HYPRE_IJVectorDestroy(vector_); }
    Vector(const Vector&) = delete;
    Vector& operator=(const Vector&) = delete;

    [[nodiscard]] HYPRE_ParVector parallel() const
    {
        void* object = nullptr;
        HYPRE_IJVectorGetObject(vector_, &object);
        return static_cast<HYPRE_ParVector>(object);
    }
    [[nodiscard]] Eigen::VectorXd values() const
    {
        Eigen::VectorXd result(size_);
        HYPRE_IJVectorGetValues(vector_, size_, places().data(), result.data());
        return result;
    }

private:
    [[nodiscard]] std::vector<int> places() const
    {
        std::vector<int> result;
        for (int n = 0; n < size_; ++n) result.push_back(n);
        return result;
    }
    int size_;
    HYPRE_IJVector vector_ = nullptr;
};

class Matrix {
public:
    explicit Matrix(const Rows& rows)
    {
        HYPRE_IJMatrixCreate(MPI_COMM_SELF, 0, rows.count() - 1, 0, rows.count() - 1, &matrix_);
        HYPRE_IJMatrixSetObjectType(matrix_, HYPRE_PARCSR);
        HYPRE_IJMatrixInitialize(matrix_);
        std::size_t first = 0;
        for (int r = 0; r < rows.count(); ++r) {
            int size = rows.sizes[std::size_t(r)];
            HYPRE_IJMatrixSetValues(matrix_, 1, &size, &r, rows.columns.data() + first, rows.values.data() + first);
            first += std::size_t(size);
        }
        HYPRE_IJMatrixAssemble(matrix_);
    }
    ~Matrix() { HYPRE_IJMatrixDestroy(matrix_); }
    Matrix(const Matrix&) = delete;
    Matrix& operator=(const Matrix&) = delete;

    [[nodiscard]] HYPRE_ParCSRMatrix parallel() const
    {
        void* object = nullptr;
        HYPRE_IJMatrixGetObject(matrix_, &object);
        return static_cast<HYPRE_ParCSRMatrix>(object);
    }

private:
    HYPRE_IJMatrix matrix_ = nullptr;
};

/// Flexible GMRES with one V-cycle of BoomerAMG, to 1e-11 of the right-hand side: for symmetric systems and others.
Solution by_hypre(const Rows& rows, const Eigen::VectorXd& right)
{
    HYPRE_Init();
    Solution solution;
    {
        const Matrix a(rows);
        const Vector b(right), x(Eigen::VectorXd::Zero(right.size()));
        HYPRE_Solver cycle = nullptr, krylov = nullptr;
        HYPRE_BoomerAMGCreate(&cycle);
        HYPRE_BoomerAMGSetMaxIter(cycle, 1);
        HYPRE_BoomerAMGSetTol(cycle, 0.0);
        HYPRE_ParCSRFlexGMRESCreate(MPI_COMM_SELF, &krylov);
        HYPRE_FlexGMRESSetKDim(krylov, 100);
        HYPRE_FlexGMRESSetMaxIter(krylov, 300);
        HYPRE_FlexGMRESSetTol(krylov, 1e-11);
        HYPRE_FlexGMRESSetPrecond(krylov, HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSolve), HYPRE_PtrToSolverFcn(HYPRE_BoomerAMGSetup), cycle);
        HYPRE_ParCSRFlexGMRESSetup(krylov, a.parallel(), b.parallel(), x.parallel());
        HYPRE_ParCSRFlexGMRESSolve(krylov, a.parallel(), b.parallel(), x.parallel());
        HYPRE_FlexGMRESGetNumIterations(krylov, &solution.iterations);
        HYPRE_ParCSRFlexGMRESDestroy(krylov);
        HYPRE_BoomerAMGDestroy(cycle);
        solution.x = x.values();
    }
    HYPRE_Finalize();
    return solution;
}

/// Largest difference, means removed, over the largest value.
double difference(Eigen::VectorXd a, Eigen::VectorXd b)
{
    a.array() -= a.mean();
    b.array() -= b.mean();
    return (a - b).lpNorm<Eigen::Infinity>() / b.lpNorm<Eigen::Infinity>();
}

void compare_seven_points(const std::string& name, const test::ConductionProblem& p, double bound)
{
    physics::SevenPointSolver solver(p.topology, {});
    solver.set_up(serial, p.coefficients());
    auto right = test::random_right(solver.layout(), 7);
    const Eigen::VectorXd b = test::rows(p, solver.layout(), right);
    std::vector<double> x(right.size(), 0.0);
    const auto report = solver.solve(serial, {.relative = 1e-10, .singular = true}, right, x);
    std::vector<Eigen::Triplet<double>> entries;
    p.for_each_entry(false, [&](Eigen::Index r, Eigen::Index c, double addend) { entries.emplace_back(int(r), int(c), addend); });
    const Solution other = by_hypre(rows_of(int(b.size()), entries), b.array() - b.mean());
    const double off = difference(test::rows(p, solver.layout(), x), other.x);
    MESSAGE(name << ", " << b.size() << " cells: " << report.iterations << " iterations, BoomerAMG " << other.iterations << ", difference "
                 << off);
    CHECK(off < bound);
}

/// The whole operator, column by column.
void compare_full(const std::string& name, core::MultiBlock grid, double bound)
{
    test::PressureOnGrid problem(std::move(grid), 0.5, 1e-12);
    const auto& report = problem.solve(serial);
    const std::vector<double> ours = problem.solution(), sources = problem.sources();
    auto& system = problem.system();
    const auto& layout = system.layout();
    std::vector<std::size_t> place;
    for (int b = 0; b < layout.blocks(); ++b)
        for (std::ptrdiff_t c = 0; c < layout.cells(b).size(); ++c) place.push_back(std::size_t(layout.origin(b) + c));
    std::vector<double> unit(layout.size(), 0.0), column(layout.size(), 0.0);
    std::vector<Eigen::Triplet<double>> entries;
    for (std::size_t c = 0; c < place.size(); ++c) {
        unit[place[c]] = 1.0;
        tasks::run(problem.ranks(), serial, [&](tasks::Lane& lane) { return system.apply(lane, unit, column); });
        unit[place[c]] = 0.0;
        for (std::size_t r = 0; r < place.size(); ++r)
            if (column[place[r]] != 0.0) entries.emplace_back(int(r), int(c), column[place[r]]);
    }
    const auto vector = [](const std::vector<double>& v) { return Eigen::Map<const Eigen::VectorXd>(v.data(), Eigen::Index(v.size())); };
    const Solution other = by_hypre(rows_of(int(place.size()), entries), -vector(sources));
    const double off = difference(vector(ours), other.x);
    MESSAGE(name << ", " << place.size() << " cells: " << report.iterations << " iterations, BoomerAMG " << other.iterations
                 << ", difference " << off);
    CHECK(off < bound);
}

} // namespace

TEST_CASE("seven points and links: boxes, the pipe and jumps have the solutions of BoomerAMG")
{
    // Residuals of 1e-10, which is what round-off leaves of sources that flow through cells 1e3 times as conductive as others; sources at
    // random see little of the condition numbers, some 1e4 without jumps and 1e6 with them.
    const auto edge = test::uniform(16, 1.0);
    compare_seven_points("box in 8 blocks", test::box_problem({{edge, edge, edge}, {2, 2, 2}}), 1e-8);
    compare_seven_points("butterfly pipe", test::pipe_problem(1), 1e-8);
    for (const auto& pattern : test::jump_cases) compare_seven_points(pattern.name, test::jump_problem(pattern, 16, {2, 1, 2}, 1e-3), 1e-8);
}

TEST_CASE("the full operator: bent and non-matching grids have the solutions of BoomerAMG")
{
    compare_full("bent channel", test::stretched_channel({{8, 8, 6}, {1, 2, 1}, 3.0}), 1e-8);
    compare_full("wavy halves, 2 to 3", test::wavy_halves({{4, 6, 6}, {6, 9, 9}}, 0.2, 30.0), 1e-8);
}
