// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fills halos for the stage graph from the blocks of the mesh, without holding a thread while messages travel.
#include "core/comm/halo.hpp"
#include "tasks/stage_graph.hpp"
#include <map>
#include <memory>

namespace physics {

/// Plans of halo exchange, made once for each width that the steps ask for.
class MeshHaloFiller final : public tasks::HaloFiller {
public:
    MeshHaloFiller(const core::Mesh& mesh, const core::Communicator& communicator) : mesh_(mesh), communicator_(communicator) {}

    /// Makes the plan for fields with `field_halo` layers of which `width` are filled, unless it is there. Collective; call
    /// it for every pair that the graph will ask for before the first step.
    const core::HaloExchange& plan(int field_halo, int width);

    [[nodiscard]] tasks::Job fill(tasks::Lane& lane, tasks::FieldRef field, int width) override;

private:
    const core::Mesh& mesh_;
    const core::Communicator& communicator_;
    std::map<std::pair<int, int>, std::unique_ptr<core::HaloExchange>> plans_;
};

/// Deposits that fell into the first halo layer go home (the transpose of filling it).
[[nodiscard]] tasks::Job send_home(tasks::Lane& lane, const core::HaloExchange& plan, core::ScalarField& field);
[[nodiscard]] tasks::Job send_home(tasks::Lane& lane, const core::HaloExchange& plan, core::VectorField& field);

} // namespace physics
