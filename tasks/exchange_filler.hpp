// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fills halos through the exchange plans of core, one plan for each number of halo layers and width.
#include "core/comm/halo.hpp"
#include "tasks/stage_graph.hpp"
#include <map>
#include <utility>

namespace tasks {

class ExchangeFiller final : public HaloFiller {
public:
    /// The mesh must outlive the filler.
    ExchangeFiller(const core::Mesh& mesh, core::Communicator ranks, core::HaloShape shape)
        : mesh_(mesh), ranks_(std::move(ranks)), shape_(shape)
    {
    }
    void prepare(FieldRef field, int width) override;
    [[nodiscard]] Job fill(Lane& lane, FieldRef field, int width) override;

private:
    const core::Mesh& mesh_;
    core::Communicator ranks_;
    core::HaloShape shape_;
    std::map<std::pair<int, int>, core::HaloExchange> exchanges_; ///< by halo layers of the field and width
};

} // namespace tasks
