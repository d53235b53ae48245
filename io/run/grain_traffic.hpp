// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Grains that come in and are taken away before a step, and the account of all: those at the start and those that came in, less those taken
// away, are here.
#include "core/comm/communicator.hpp"
#include "io/scene/scene.hpp"
#include "physics/particles/inflow.hpp"
#include "physics/particles/stepper.hpp"

namespace io {

/// What an outlet has taken away so far.
struct TakenAway {
    std::int64_t count = 0;
    double mass = 0.0; ///< [kg]
};

class GrainTraffic {
public:
    /// @param grains  All at the start; their ids are 0, 1, 2, ...
    GrainTraffic(const Scene& scene, const core::Domain& domain, std::int64_t grains);

    /// Have the grains of all ranks the ids that the account says? Collective.
    /// @param before  The grains of this rank when they were last here. @throws core::NumericsError that names ids, on all ranks.
    void check(const core::ParticleSet& grains, const core::ParticleSet& before, const core::Communicator& ranks) const;
    /// Takes away what has come into outlets, then lets in what is due and finds room. @pre no lists. Collective.
    /// @returns whether any came or went, on whatever rank.
    bool pass(double time, const physics::OwnerOf& owner_of, physics::ParticleDynamics& dynamics, const core::Communicator& ranks);

    [[nodiscard]] bool is_open() const { return !inflows_.empty() || !outlets_.empty(); }
    [[nodiscard]] const std::vector<std::string>& inflow_names() const { return inflow_names_; }
    [[nodiscard]] const std::vector<std::string>& outlet_names() const { return outlet_names_; }
    [[nodiscard]] const std::vector<physics::Entered>& entered() const { return state_.entered; }
    [[nodiscard]] const std::vector<TakenAway>& taken_away() const { return state_.taken; }

    /// The account, which the next step reads.
    struct State {
        std::int64_t next_id = 0;
        std::int64_t count = 0; ///< of grains that are here
        std::int64_t marks = 0; ///< sum of the marks of their ids, modulo 2^52
        std::vector<physics::Entered> entered;
        std::vector<TakenAway> taken;
    };
    [[nodiscard]] const State& state() const { return state_; }
    void restore(State state) { state_ = std::move(state); }

    /// Calls visit(name, number) for all numbers of the account; each is a whole one below 2^53, or a double.
    template <class Visit>
    void for_each_number(Visit visit)
    {
        if (!is_open()) return;
        visit("next particle", state_.next_id);
        visit("particles here", state_.count);
        visit("marks of particles", state_.marks);
        for (std::size_t n = 0; n < inflow_names_.size(); ++n) {
            visit("entered " + inflow_names_[n], state_.entered[n].count);
            visit("amount entered " + inflow_names_[n], state_.entered[n].amount);
        }
        for (std::size_t n = 0; n < outlet_names_.size(); ++n) {
            visit("taken away at " + outlet_names_[n], state_.taken[n].count);
            visit("mass taken away at " + outlet_names_[n], state_.taken[n].mass);
        }
    }

private:
    bool take_away(physics::ParticleDynamics& dynamics, const core::Communicator& ranks);
    bool let_in(double time, const physics::OwnerOf& owner_of, physics::ParticleDynamics& dynamics, const core::Communicator& ranks);

    core::Domain domain_;
    std::vector<physics::Wall> walls_;
    std::uint64_t seed_;
    std::vector<std::string> inflow_names_, outlet_names_;
    std::vector<physics::Inflow> inflows_;
    std::vector<physics::Region> outlets_;
    State state_;
};

} // namespace io
