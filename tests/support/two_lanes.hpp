// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A small step with two lanes that both talk between ranks: a smoother in a ring of blocks with repeated sums, and sub-steps
// of grains that look at the first grain of the next block. Made to run on any number of ranks with the same bits.
#include "tasks/stage_graph.hpp"
#include <algorithm>
#include <cmath>
#include <memory>

namespace support {

/// Blocks in a ring, each rank owning as many in a row.
struct Ring {
    core::Communicator ranks;
    int blocks = 8;
    [[nodiscard]] int local() const { return blocks / ranks.size(); }
    [[nodiscard]] int first() const { return ranks.rank() * local(); }
    [[nodiscard]] int owner(int block) const { return block / local(); }
    [[nodiscard]] int around(int block) const { return (block + blocks) % blocks; }
};

/// What every block says to the block before it in the ring: first[b] goes to from_next[b - 1].
inline tasks::Job tell_previous(tasks::Lane& lane, const Ring& ring, std::vector<double> first, std::vector<double>& from_next)
{
    core::Pending pending;
    {
        const auto mpi = lane.messages();
        for (int b = 0; b < ring.local(); ++b) {
            const int next = ring.around(ring.first() + b + 1), previous = ring.around(ring.first() + b - 1);
            const std::span in(&from_next[std::size_t(b)], 1), out(&first[std::size_t(b)], 1);
            lane.communicator().receive(std::as_writable_bytes(in), ring.owner(next), next, pending);
            lane.communicator().send(std::as_bytes(out), ring.owner(previous), ring.first() + b, pending);
        }
    }
    co_await lane.arrive(pending);
}

/// One halo layer on the high-i side, one value each: enough to make blocks depend on each other.
class RingFiller final : public tasks::HaloFiller {
public:
    explicit RingFiller(const Ring& ring) : ring_(ring) {}
    tasks::Job fill(tasks::Lane& lane, tasks::FieldRef field, core::HaloReach) override
    {
        auto& u = *std::get<core::ScalarField*>(field);
        std::vector<double> first, from_next(std::size_t(ring_.local()));
        for (int b = 0; b < ring_.local(); ++b) first.push_back(u.on(b)(0, 0, 0));
        co_await tell_previous(lane, ring_, first, from_next);
        for (int b = 0; b < ring_.local(); ++b) u.on(b)(u.on(b).extents().ni, 0, 0) = from_next[std::size_t(b)];
    }

private:
    Ring ring_;
};

class TwoLanes {
    using Grains = std::vector<double>;

public:
    static constexpr int cells = 64, grains = 40, sweeps = 4, sub_steps = 6;

    explicit TwoLanes(const core::Communicator& ranks)
        : ring_{ranks},
          filler_(ring_),
          extents_(std::size_t(ring_.local()), core::Extents{cells, 1, 1}),
          u_({"u", "m/s", 1, true}, extents_),
          smooth_({"smooth", "m/s", 1, false}, extents_),
          grains_("grains", extents_.size(), Grains(grains)),
          force_("force", extents_.size()),
          scale_("scale", 1.0),
          graph_(tasks::Layout{std::vector<std::ptrdiff_t>(extents_.size(), cells), 1}, ranks)
    {
        graph_.fill_halos_with(filler_);
        declare_fluid();
        declare_grains();
        graph_.each_block(
            "push grains back",
            [](int, const Grains& x, double& force) {
                force = 0.0;
                for (const double position : x) force += 1e-3 * std::sin(position);
            },
            tasks::reads(grains_), tasks::writes(force_));
        graph_.sink(u_);
        graph_.sink(grains_);
        u_.allocate();
        reset();
    }

    [[nodiscard]] tasks::StageGraph& graph() { return graph_; }

    void reset()
    {
        scale_.get() = 1.0;
        for (int b = 0; b < ring_.local(); ++b) {
            const int block = ring_.first() + b;
            std::ranges::fill(u_.data(b, 0), 0.0);
            for (int i = 0; i < cells; ++i) u_.on(b)(i, 0, 0) = std::cos(0.1 * (i + cells * block));
            for (int g = 0; g < grains; ++g) grains_.on(b)[std::size_t(g)] = std::sin(0.3 * g + block);
            force_.on(b) = 0.0;
        }
    }

    /// All values of all ranks in the order of the blocks; the same on all ranks. Collective.
    [[nodiscard]] std::vector<double> state() const
    {
        std::vector<double> all(std::size_t(ring_.blocks) * (cells + grains), 0.0);
        auto out = all.begin() + std::ptrdiff_t(ring_.first()) * (cells + grains);
        for (int b = 0; b < ring_.local(); ++b) {
            for (int i = 0; i < cells; ++i) *out++ = u_.on(b)(i, 0, 0);
            out = std::ranges::copy(grains_.on(b), out).out;
        }
        ring_.ranks.sum(std::span(all)); // one rank holds each number, the others zero
        return all;
    }

private:
    void declare_fluid()
    {
        const auto lane = graph_.lane("fluid");
        graph_.each_block(
            "smooth",
            [](int, core::View<const double> u, double force, core::View<double> smooth) {
                for (int i = 0; i < cells; ++i) smooth(i, 0, 0) = 0.6 * u(i, 0, 0) + 0.4 * u(i + 1, 0, 0) + force;
            },
            tasks::reads(tasks::halo(u_, 1), force_), tasks::writes(smooth_));
        graph_.whole(
            "solve",
            [ring = ring_](tasks::Lane& lane, const core::ScalarField& smooth, core::ScalarField& u, double& scale) {
                return solve(lane, ring, smooth, u, scale);
            },
            tasks::reads(smooth_), tasks::writes(u_), tasks::updates(scale_));
    }

    static tasks::Job solve(tasks::Lane& lane, Ring ring, const core::ScalarField& smooth, core::ScalarField& u, double& scale)
    {
        for (int sweep = 0; sweep < sweeps; ++sweep) {
            std::vector<double> slots(std::size_t(ring.blocks), 0.0); // a slot for each block of the ring
            lane.team().run(ring.local(), [&](int b) {
                for (int i = 0; i < cells; ++i) {
                    u.on(b)(i, 0, 0) = scale * smooth.on(b)(i, 0, 0);
                    slots[std::size_t(ring.first() + b)] += u.on(b)(i, 0, 0) * u.on(b)(i, 0, 0);
                }
            });
            co_await lane.sum(slots);
            double total = 0.0;
            for (const double slot : slots) total += slot;
            scale *= std::sqrt((0.5 + cells * ring.blocks) / (0.5 + total + 0.5 * cells * ring.blocks));
        }
    }

    void declare_grains()
    {
        const auto lane = graph_.lane("particles");
        graph_.whole(
            "move grains", [ring = ring_](tasks::Lane& lane, tasks::PerBlock<Grains>& x) { return move_grains(lane, ring, x); },
            tasks::updates(grains_));
    }

    static tasks::Job move_grains(tasks::Lane& lane, Ring ring, tasks::PerBlock<Grains>& x)
    {
        std::vector<double> from_next(x.size());
        for (int k = 0; k < sub_steps; ++k) {
            std::vector<double> first;
            for (int b = 0; b < ring.local(); ++b) first.push_back(x.on(b).front());
            co_await tell_previous(lane, ring, first, from_next);
            lane.team().run(ring.local(), [&](int b) {
                Grains& g = x.on(b);
                for (std::size_t i = 0; i < g.size(); ++i)
                    g[i] += 0.01 * std::sin((i + 1 < g.size() ? g[i + 1] : from_next[std::size_t(b)]) - g[i]);
            });
        }
    }

    Ring ring_;
    RingFiller filler_;
    std::vector<core::Extents> extents_;
    core::ScalarField u_, smooth_;
    tasks::PerBlock<Grains> grains_;
    tasks::PerBlock<double> force_;
    tasks::Value<double> scale_;
    tasks::StageGraph graph_;
};

} // namespace support
