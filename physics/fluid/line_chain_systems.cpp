// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/line_chains.hpp"

#include <algorithm>

namespace physics {

LineChains::Ports LineChains::ports(core::BlockId b)
{
    const auto all = port_values(b);
    const auto n = std::size_t(lines(b).count);
    return {all.subspan(0, n), all.subspan(n, n), all.subspan(2 * n, n), all.subspan(3 * n, n), all.subspan(4 * n, n)};
}

std::span<float> LineChains::port_values(core::BlockId b)
{
    return std::span(ports_).subspan(std::size_t(port_numbers * begin_[std::size_t(b)]), std::size_t(port_numbers * lines(b).count));
}

std::span<float> LineChains::ends(core::BlockId b)
{
    return std::span(ends_).subspan(std::size_t(2 * begin_[std::size_t(b)]), std::size_t(2 * lines(b).count));
}

template <class Body>
void LineChains::for_chains(const core::Team& team, Body body) const
{
    constexpr int together = 64; // chains of a few cells each: enough work to hand out
    const int count = int(chains_.size()) - 1;
    team.run((count + together - 1) / together, [&](int chunk) {
        for (int c = chunk * together; c < std::min(count, (chunk + 1) * together); ++c)
            body(std::size_t(chains_[std::size_t(c)]), std::size_t(chains_[std::size_t(c) + 1] - chains_[std::size_t(c)]));
    });
}

void LineChains::factorise(const core::Team& team)
{
    if (!active()) return;
    for_chains(team, [&](std::size_t first, std::size_t count) { factorise_chain(std::span(nodes_).subspan(first, count)); });
}

void LineChains::solve(const core::Team& team)
{
    if (!active()) return;
    for_chains(team, [&](std::size_t first, std::size_t count) { solve_chain(std::span(nodes_).subspan(first, count)); });
}

/// Takes the nodes out one after the other, the first one last: what each leaves are conductances between its neighbours.
void LineChains::factorise_chain(std::span<Node> nodes) const
{
    const auto inverse_or_zero = [](float pivot) { return pivot > 0.0F ? 1.0F / pivot : 0.0F; }; // zero pins what holds to nothing
    const auto tie = [&](const Node& n) { return n.tie >= 0 ? ports_[std::size_t(n.tie)] : 0.0F; };
    const auto ground = [&](const Node& n) { return ports_[std::size_t(n.ground)]; };
    float whole = ground(nodes[0]), ground_here = nodes.size() > 1 ? ground(nodes[1]) : 0.0F, first = tie(nodes[0]);
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        Node& n = nodes[j];
        const bool last = j + 1 == nodes.size();
        n.first = last ? first + tie(n) : first;
        n.next = last ? 0.0F : tie(n);
        n.inverse = inverse_or_zero(n.first + n.next + ground_here);
        whole += n.first * (ground_here * n.inverse);
        if (last) break;
        first = n.first * (n.next * n.inverse);
        ground_here = ground(nodes[j + 1]) + n.next * (ground_here * n.inverse);
    }
    nodes[0].inverse = inverse_or_zero(whole);
}

void LineChains::solve_chain(std::span<const Node> nodes)
{
    const auto value = [this](const Node& n) -> float& { return ends_[std::size_t(n.end)]; };
    float current = value(nodes[0]), here = nodes.size() > 1 ? value(nodes[1]) : 0.0F;
    for (std::size_t j = 1; j < nodes.size(); ++j) {
        const Node& n = nodes[j];
        const float scaled = here * n.inverse;
        value(n) = scaled;
        current += n.first * scaled;
        if (j + 1 < nodes.size()) here = value(nodes[j + 1]) + n.next * scaled;
    }
    const float first = value(nodes[0]) = current * nodes[0].inverse;
    float beyond = 0.0F;
    for (std::size_t j = nodes.size() - 1; j > 0; --j) {
        const Node& n = nodes[j];
        beyond = value(n) += n.inverse * (n.first * first + n.next * beyond);
    }
}

std::size_t LineChains::bytes() const
{
    return (ports_.capacity() + ends_.capacity()) * sizeof(float) + nodes_.capacity() * sizeof(Node) + chains_.capacity() * sizeof(int);
}

} // namespace physics
