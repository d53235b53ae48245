// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What levels send between ranks: ghosts, values at the ends of links, and the blocks of the first level that every rank
// holds as a whole.
#include "core/comm/communicator.hpp"
#include "physics/fluid/aggregate_levels.hpp"
#include <cstring>
#include <span>
#include <vector>

namespace physics {

/// Blocks of all ranks and all their links, as if this rank owned them. Collective.
/// @param coarse_link  Into mine.links in, into the links of the result out.
[[nodiscard]] BlockTopology replicated(const BlockTopology& mine, const core::Communicator& communicator,
                                       std::vector<CoarseLink>& coarse_link);

/// Buffers for one set of messages at a time; they grow once and stay.
class LevelMessages {
public:
    /// Sends boundary values and receives ghosts in place.
    template <class Real>
    void start_ghosts(const LevelMesh& mesh, std::span<Real> values, const core::Communicator& communicator, core::Pending& pending)
    {
        prepare(mesh.exchanges.size());
        for (std::size_t n = 0; n < mesh.exchanges.size(); ++n) {
            const auto& e = mesh.exchanges[n];
            communicator.receive(std::as_writable_bytes(values.subspan(std::size_t(e.receive), std::size_t(e.ghosts))), e.rank, tag,
                                 pending);
            auto& buffer = send_[n];
            buffer.resize(e.send.size() * sizeof(Real));
            auto* out = buffer.data(); // bytes: not aligned as a Real may have to be
            for (const auto cell : e.send) {
                std::memcpy(out, &values[std::size_t(cell)], sizeof(Real));
                out += sizeof(Real);
            }
            communicator.send(buffer, e.rank, tag, pending);
        }
    }

    /// Resistances at the ends of links between ranks.
    void start_resistances(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending);
    void complete_resistances(MultigridLevel& level) const;
    /// Residuals that cross links between ranks.
    void start_parts(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending);
    void complete_parts(MultigridLevel& level) const;

    /// What start_blocks() sends of the blocks of each rank to all others.
    enum class Content { coefficients, right };
    void start_blocks(MultigridLevel& level, Content content, const core::Communicator& communicator, core::Pending& pending);
    void complete_blocks(MultigridLevel& level, Content content, const core::Communicator& communicator) const;

    /// What aggregates send: numbers of all blocks, their maximum to be taken; parents of ghosts; and contents of AggregateLevels.
    void start_counts(AggregateLevels& levels, const core::Communicator& communicator, core::Pending& pending);
    void start_aggregates(AggregateLevels& levels, AggregateLevels::Content content, const core::Communicator& communicator,
                          core::Pending& pending);
    void complete_aggregates(AggregateLevels& levels, AggregateLevels::Content content, const core::Communicator& communicator) const;

    /// Which lines the blocks of each rank solve, to all others.
    void start_choices(MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending);
    void complete_choices(MultigridLevel& level) const;
    /// Numbers of the lines of blocks, to ranks that have parts of the same chains.
    enum class OfLines { ports, ends };
    void start_lines(MultigridLevel& level, OfLines content, const core::Communicator& communicator, core::Pending& pending);
    void complete_lines(MultigridLevel& level, OfLines content) const;

private:
    static constexpr int tag = 7;
    void prepare(std::size_t messages);
    template <class Value>
    void start_links(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending, Value value);

    /// Sends what for_content(rank, body(pointer, number of words)) passes for this rank to all others, and receives theirs.
    template <class ForContent>
    void start_to_all(ForContent for_content, const core::Communicator& communicator, core::Pending& pending);
    template <class ForContent>
    void complete_from_all(ForContent for_content, const core::Communicator& communicator) const;

    std::vector<std::vector<std::byte>> send_;
    std::vector<std::vector<float>> receive_; ///< words of 32 bits, whatever they mean
    std::vector<double> choices_;             ///< four numbers for each block of all ranks
};

} // namespace physics
