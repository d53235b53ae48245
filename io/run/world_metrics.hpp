// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The numbers that tell how a run goes: rows of metrics.csv with the columns that the scene has a meaning for.
#include "io/run/metrics.hpp"
#include "io/run/momentum_ledger.hpp"
#include "io/run/one_way_books.hpp"
#include <functional>

namespace io {

/// Columns that are computed together.
struct MetricGroup {
    std::vector<std::string> names;
    std::function<std::vector<double>()> values; ///< collective; the same on every rank, for any number of ranks
};

/// What the state of a world alone tells: all but the step and the books of momentum.
[[nodiscard]] std::vector<MetricGroup> state_metrics(World& world);
/// One after the other. Collective.
[[nodiscard]] std::vector<double> values_of(const std::vector<MetricGroup>& groups);

class WorldMetrics {
public:
    /// @param restart_time  Goes on with the table of an earlier run [s].
    /// @pre world.compile()
    /// Collective. @throws core::FileError on all ranks if the file cannot be written.
    WorldMetrics(World& world, const std::filesystem::path& file, std::optional<double> restart_time = {});

    /// To be called after every step: the books of momentum go from step to step. Collective.
    void after_step();
    /// Adds a row for the present state. Collective.
    void write();
    /// Hands the rows to the system; to be called with every checkpoint.
    void flush();

    [[nodiscard]] std::vector<std::string> names() const;
    /// The present row, in the order of names(). Collective.
    [[nodiscard]] std::vector<double> row() const;
    /// The books of momentum; none without coupling.
    [[nodiscard]] const MomentumLedger* ledger() const { return ledger_ ? &*ledger_ : nullptr; }

private:
    core::Communicator ranks_;
    std::optional<MomentumLedger> ledger_;
    std::optional<OneWayBooks> one_way_;
    std::vector<MetricGroup> groups_;
    std::optional<MetricsWriter> writer_; ///< on rank 0
};

} // namespace io
