// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fields that live within one step of the fluid; those that no kept stage touches are never allocated.
#include "core/grid/mesh.hpp"
#include "physics/fluid/viscosity_ratio.hpp"

namespace physics {

struct FluidFields {
    explicit FluidFields(const core::Mesh& mesh)
        : pressure_gradient({"pressure gradient", "Pa/m", 1, false}, mesh.own_cells()),
          velocity_gradient({"gradient of velocity", "1/s", 1, false}, mesh.own_cells()),
          viscous({"viscous acceleration", "m/s2", 0, false}, mesh.own_cells()),
          source({"velocity to advect", "m/s", 3, false}, mesh.own_cells()),
          transport({"transport velocity", "m/s", 1, false}, mesh.own_cells()),
          index_velocity({"velocity in index space", "1/s", 1, false}, mesh.own_cells()),
          displacement({"displacement", "cells", 0, false}, mesh.own_cells()),
          middle_flux({"volume flux in the middle of the step", "m3/s", 0, false}, mesh.own_cells()),
          middle({"velocity in the middle of the step", "m/s", 1, false, true}, mesh.own_cells()),
          advected({"advected velocity", "m/s", 0, false}, mesh.own_cells()),
          predicted({"predicted velocity", "m/s", 1, false, true}, mesh.own_cells()),
          viscous_change({"viscous change of velocity", "m/s", 0, false}, mesh.own_cells()),
          face_scratch({"flux of a gradient", "", 0, false}, mesh.own_cells()),
          predicted_flux({"predicted volume flux", "m3/s", 0, false}, mesh.own_cells()),
          remembered_flux({"remembered volume flux", "m3/s", 0, false}, mesh.own_cells()),
          remembered_outflow({"remembered outflow", "m3/s", 0, false}, mesh.own_cells()),
          outflow({"net outflow", "m3/s", 0, false}, mesh.own_cells()),
          throughput({"throughput", "m3/s", 0, false}, mesh.own_cells()),
          removed_outflow({"removed outflow", "m3/s", 0, false}, mesh.own_cells()),
          psi({"pressure impulse", "m2/s", 1, false}, mesh.own_cells()),
          psi_gradient({"gradient of pressure impulse", "m/s", 1, false}, mesh.own_cells()),
          viscosity_ratio(mesh.own_cells())
    {
    }

    core::VectorField pressure_gradient;
    core::TensorField velocity_gradient;
    core::VectorField viscous;   ///< explicit, at the start of the step
    core::VectorField source;    ///< what is interpolated at the departure points
    core::VectorField transport; ///< what carries: velocity as the fluxes through the faces of a cell have it
    core::VectorField index_velocity, displacement;
    core::FaceField middle_flux;      ///< what carries in finite volumes
    core::VectorField middle;         ///< what they carry, in the centres of cells
    core::VectorField advected;       ///< source at the departure points, or after its fluxes
    core::VectorField predicted;      ///< before the projection
    core::VectorField viscous_change; ///< by implicit viscosity: a guess, then what it came to
    core::FaceField face_scratch, predicted_flux;
    core::FaceField remembered_flux;      ///< of flux_memory.hpp
    core::ScalarField remembered_outflow; ///< what the solver left of the net outflow of the last flux
    core::ScalarField outflow;            ///< of the predicted flux
    core::ScalarField throughput;         ///< half the sum of the magnitudes of the fluxes of a cell
    core::ScalarField removed_outflow;    ///< what the projection took away of it
    core::ScalarField psi;                ///< mobility * pressure increment
    core::VectorField psi_gradient;
    ViscosityRatio viscosity_ratio; ///< none without turbulence
};

} // namespace physics
