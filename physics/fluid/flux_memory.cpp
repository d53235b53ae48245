// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/flux_memory.hpp"
#include "physics/fluid/cell_loops.hpp"

namespace physics {

void split_flux(const core::BlockGeometry& geometry, const BlockWalls& walls, core::FaceView<const double> flux,
                core::VectorView<const double> velocity, core::FaceView<double> remembered, core::View<double> outflow)
{
    interpolated_flux(geometry, walls, velocity, remembered);
    map_faces(
        remembered, [](double total, double interpolated) { return total - interpolated; }, flux, remembered);
    close_walls(walls, remembered);
    net_outflow(flux, outflow);
}

void add_remembered(double share, core::FaceView<const double> remembered, core::FaceView<double> flux)
{
    if (share > 0)
        map_faces(
            flux, [share](double f, double r) { return f + share * r; }, flux, remembered);
}

void take_off_remembered(double share, core::View<const double> remembered, core::View<double> outflow)
{
    if (share > 0)
        map_cells(
            outflow, [share](double now, double left) { return now - share * left; }, outflow, remembered);
}

} // namespace physics
