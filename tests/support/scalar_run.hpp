// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Scalars in a flow that is given by its vector potential, so that its fluxes are free of divergence to round-off on any grid.
#include "core/grid/hexahedron.hpp"
#include "physics/steps/scalar_carrier.hpp"
#include "physics/steps/scalar_diffusion.hpp"
#include "tests/support/fluid_run.hpp"

namespace test {

/// Flux of curl A through every face, by Stokes: midpoint rule along its edges.
inline void set_flux(const core::Mesh& mesh, const VectorFunction& potential, core::FaceField& flux)
{
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b)
        for (int axis = 0; axis < 3; ++axis) {
            const auto f = flux.on(b).along(axis);
            core::for_each_cell(f.extents(), [&](int i, int j, int k) {
                const auto corners = core::face_corners(mesh.vertices(mesh.global(b)), axis, {i, j, k});
                double sum = 0;
                for (std::size_t n = 0; n < 4; ++n) {
                    const Vec3 &from = corners[n], &to = corners[(n + 1) % 4];
                    sum += potential(0.5 * (from + to)).dot(to - from);
                }
                const Vec3 area = core::face_shape(corners).area, along = mesh.geometry(b).area(axis, i, j, k);
                f(i, j, k) = area.dot(along) > 0 ? sum : -sum;
            });
        }
}

/// Flux of a uniform velocity, through sub-faces too.
inline void set_uniform_flux(const core::Mesh& mesh, const Vec3& velocity, core::FaceField& flux)
{
    for (core::LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const core::BlockGeometry& geometry = mesh.geometry(b);
        for (int axis = 0; axis < 3; ++axis) {
            const auto f = flux.on(b).along(axis);
            core::for_each_cell(f.extents(), [&](int i, int j, int k) { f(i, j, k) = geometry.area(axis, i, j, k).dot(velocity); });
        }
        for (std::size_t n = 0; n < geometry.sub_faces.size(); ++n)
            flux.on(b).sub_faces(int(n), 0, 0) = geometry.sub_faces[n].area.dot(velocity);
    }
}

class ScalarRun {
public:
    ScalarRun(core::MultiBlock grid, const physics::BoundaryConditions& boundaries = {},
              const core::Communicator& ranks = core::Communicator::world())
        : ranks_(ranks),
          mesh_(std::move(grid), ranks_.rank(), ranks_.size()),
          filler_(mesh_, ranks_),
          walls_(physics::make_walls(mesh_, boundaries)),
          set_(mesh_, {{.name = "dye"}}),
          pressure_({mesh_, walls_, filler_}, ranks_, physics::FluidTolerances()),
          carrier_({mesh_, walls_, filler_}),
          diffusion_({mesh_, walls_, filler_}, pressure_),
          flux_({"flux", "m3/s", 0, false}, mesh_.own_cells()),
          diffusivity_({"diffusivity", "m2/s", 0, false}, mesh_.own_cells()),
          source_({"source", "", 0, false}, mesh_.own_cells())
    {
        flux_.allocate();
        diffusivity_.allocate();
        source_.allocate();
        filler_.prepare(&value(), core::beside);
    }

    void start(const ScalarFunction& dye, const VectorFunction& potential)
    {
        for_each_cell([&](core::LocalBlock b, int i, int j, int k) { value().on(b)(i, j, k) = dye(centre(b, i, j, k)); });
        set_flux(mesh_, potential, flux_);
    }
    void start(const ScalarFunction& dye, const Vec3& velocity)
    {
        for_each_cell([&](core::LocalBlock b, int i, int j, int k) { value().on(b)(i, j, k) = dye(centre(b, i, j, k)); });
        set_uniform_flux(mesh_, velocity, flux_);
    }
    void carry(double dt)
    {
        const std::vector<physics::EntryValues> none(std::size_t(mesh_.own_count()));
        const physics::CarriedScalar scalar{&value(), none};
        tasks::run(ranks_, core::SerialTeam(), [&](tasks::Lane& lane) {
            return carrier_.carry(lane, {flux_, set_.share, dt}, std::span(&scalar, 1));
        });
    }
    void diffuse(double dt, double diffusivity)
    {
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b)
            for (std::size_t a = 0; a < diffusivity_.arrays; ++a)
                std::fill(diffusivity_.data(b, a).begin(), diffusivity_.data(b, a).end(), diffusivity);
        for_each_cell([&](core::LocalBlock b, int i, int j, int k) { source_.on(b)(i, j, k) = value().on(b)(i, j, k); });
        tasks::run(ranks_, core::SerialTeam(), [&](tasks::Lane& lane) {
            return diffusion_.solve(lane, {diffusivity_, set_.share, source_, dt}, value());
        });
    }

    /// Volume mean of |dye - expected|^power, its root.
    [[nodiscard]] double error(const ScalarFunction& expected, double power = 2)
    {
        return std::pow(mean([&](core::LocalBlock b, int i, int j, int k) {
                            return std::pow(std::abs(value().on(b)(i, j, k) - expected(centre(b, i, j, k))), power);
                        }),
                        1 / power);
    }
    /// Amount of dye over the volume.
    [[nodiscard]] double amount()
    {
        return mean([&](core::LocalBlock b, int i, int j, int k) { return set_.share.on(b)(i, j, k) * value().on(b)(i, j, k); });
    }
    [[nodiscard]] std::array<double, 2> range()
    {
        std::array<double, 2> ends{1e300, -1e300};
        for_each_cell([&](core::LocalBlock b, int i, int j, int k) {
            const double q = value().on(b)(i, j, k);
            ends = {std::min(ends[0], q), std::max(ends[1], q)};
        });
        return ends;
    }
    [[nodiscard]] core::ScalarField& value() { return set_.values.front(); }
    [[nodiscard]] const core::Mesh& mesh() const { return mesh_; }
    [[nodiscard]] int parts() const { return carrier_.parts(); }
    [[nodiscard]] int products() const { return diffusion_.products(); }

private:
    template <class Body>
    void for_each_cell(Body body) const
    {
        for (core::LocalBlock b = 0; b < mesh_.own_count(); ++b)
            core::for_each_cell(mesh_.geometry(b).cells, [&](int i, int j, int k) { body(b, i, j, k); });
    }
    [[nodiscard]] Vec3 centre(core::LocalBlock b, int i, int j, int k) const { return mesh_.geometry(b).centre(i, j, k); }
    [[nodiscard]] double mean(const OfCell& term) const { return volume_mean(mesh_, ranks_, term); }

    core::Communicator ranks_;
    core::Mesh mesh_;
    tasks::ExchangeFiller filler_;
    std::vector<physics::BlockWalls> walls_;
    physics::ScalarSet set_;
    physics::PressureSystem pressure_;
    physics::ScalarCarrier carrier_;
    physics::ScalarDiffusion diffusion_;
    core::FaceField flux_, diffusivity_;
    core::ScalarField source_;
};

} // namespace test
