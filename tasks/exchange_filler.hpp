// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Fills halos through the exchange plans of core, one plan for each number of halo layers and reach.
#include "core/comm/halo.hpp"
#include "tasks/stage_graph.hpp"
#include <map>
#include <tuple>

namespace tasks {

class ExchangeFiller final : public HaloFiller {
public:
    /// The mesh must outlive the filler.
    ExchangeFiller(const core::Mesh& mesh, core::Communicator ranks) : mesh_(mesh), ranks_(std::move(ranks)) {}
    void prepare(FieldRef field, core::HaloReach reach) override;
    [[nodiscard]] Job fill(Lane& lane, FieldRef field, core::HaloReach reach) override;

private:
    /// Halo layers of the field, what is filled behind them, and reach.
    using Key = std::tuple<int, core::HaloExchange::Behind, core::HaloReach>;
    [[nodiscard]] Key key_of(FieldRef field, core::HaloReach reach) const;

    const core::Mesh& mesh_;
    core::Communicator ranks_;
    std::map<Key, core::HaloExchange> exchanges_;
};

} // namespace tasks
