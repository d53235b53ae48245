// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Measures what the criteria of a stress case are about, and nothing else.
#include "io/run/momentum_ledger.hpp"
#include "io/study/stress_case.hpp"
#include <functional>
#include <map>

namespace io {

class StressProbes {
public:
    /// @pre world.compile(); the world must outlive the probes. Collective.
    /// @throws core::ConfigError for a criterion that the scene gives no meaning to.
    StressProbes(World& world, const StressCriteria& criteria);
    /// Collective.
    void after_step();
    /// Takes what counts at the end. Collective.
    void finish();
    /// Largest over the run, or at its end.
    [[nodiscard]] double value(Measure m) const { return values_[std::size_t(m)]; }

private:
    struct Probe {
        Measure measure;
        std::function<double()> value;
    };
    void add_during(Measure m, std::function<double()> value);
    void add_final(Measure m, std::function<double()> value);
    void add_fluid();
    void add_particles();
    void add_coupling();

    World& world_;
    const StressCriteria& criteria_;
    std::optional<MomentumLedger> ledger_;
    std::vector<Probe> during_, final_;
    std::map<std::int64_t, core::Vec3> first_places_; ///< of the particles after the first step; only for creep [m]
    std::array<double, measures.size()> values_{};
};

} // namespace io
