// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "physics/fluid/multigrid_messages.hpp"

#include <algorithm>
#include <cstring>
#include <tuple>

namespace physics {
namespace {

bool before(const BlockLink& l, const BlockLink& r) { return std::tie(l.a, l.b) < std::tie(r.a, r.b); }
bool same(const BlockLink& l, const BlockLink& r) { return l.a == r.a && l.b == r.b; }

/// The end on this rank of a link between two ranks.
std::size_t own_end(const LevelMesh& mesh, int link) { return mesh.half_of[std::size_t(link)][0] >= 0 ? 0 : 1; }

/// Calls body(pointer, count) for all that the owner of some blocks of a level sends.
template <class Body>
void for_content(MultigridLevel& level, LevelMessages::Content content, int owner, Body body)
{
    const auto& mesh = level.mesh;
    for (core::LocalBlock b = 0; b < mesh.layout.blocks(); ++b) {
        if (level.owner[std::size_t(b)] != owner) continue;
        const auto from = mesh.layout.origin(b);
        const auto count = std::size_t(mesh.layout.cells(b).size());
        if (content == LevelMessages::Content::right) {
            body(level.right.data() + from, count);
            const int first = mesh.block_runs[std::size_t(b)], last = mesh.block_runs[std::size_t(b) + 1];
            for (int r = first; r < last; ++r) {
                const auto& run = mesh.runs[std::size_t(r)];
                body(level.half_part.data() + run.first, std::size_t(run.last - run.first));
            }
            continue;
        }
        for (auto& face : level.matrix.face) body(face.data() + from, count);
        if (!level.matrix.shift.empty()) body(level.matrix.shift.data() + from, count);
    }
    if (content == LevelMessages::Content::right) return;
    for (std::size_t l = 0; l < mesh.links.size(); ++l) // block ids count from 0 where a rank holds all
        if (level.owner[std::size_t(mesh.links[l].a.block)] == owner) body(level.matrix.link.data() + l, std::size_t(1));
}

} // namespace

BlockTopology replicated(const BlockTopology& mine, const core::Communicator& communicator, std::vector<CoarseLink>& coarse_link)
{
    BlockTopology all{mine.cells, std::vector<int>(mine.cells.size(), mine.rank), mine.rank, {}};
    for (const auto& bytes : communicator.gather_all(std::as_bytes(std::span(mine.links)))) {
        const auto count = bytes.size() / sizeof(BlockLink);
        const auto old = all.links.size();
        all.links.resize(old + count);
        if (count > 0) std::memcpy(all.links.data() + old, bytes.data(), bytes.size());
    }
    std::sort(all.links.begin(), all.links.end(), before);
    all.links.erase(std::unique(all.links.begin(), all.links.end(), same), all.links.end());
    for (auto& c : coarse_link)
        if (c.link >= 0)
            c.link = int(std::lower_bound(all.links.begin(), all.links.end(), mine.links[std::size_t(c.link)], before) - all.links.begin());
    return all;
}

void LevelMessages::prepare(std::size_t messages)
{
    if (send_.size() < messages) send_.resize(messages);
    if (receive_.size() < messages) receive_.resize(messages);
}

template <class Value>
void LevelMessages::start_links(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending, Value value)
{
    const auto& exchanges = level.mesh.exchanges;
    prepare(exchanges.size());
    for (std::size_t n = 0; n < exchanges.size(); ++n) {
        const auto& e = exchanges[n];
        receive_[n].resize(e.links.size());
        communicator.receive(std::as_writable_bytes(std::span(receive_[n])), e.rank, tag, pending);
        send_[n].resize(e.links.size() * sizeof(float));
        auto* out = reinterpret_cast<float*>(send_[n].data());
        for (std::size_t l = 0; l < e.links.size(); ++l) out[l] = value(e.links[l], own_end(level.mesh, e.links[l]));
        communicator.send(send_[n], e.rank, tag, pending);
    }
}

void LevelMessages::start_resistances(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending)
{
    start_links(level, communicator, pending, [&](int link, std::size_t end) { return level.end_resistance[std::size_t(link)][end]; });
}

void LevelMessages::complete_resistances(MultigridLevel& level) const
{
    for (std::size_t n = 0; n < level.mesh.exchanges.size(); ++n) {
        const auto& links = level.mesh.exchanges[n].links;
        for (std::size_t l = 0; l < links.size(); ++l)
            level.end_resistance[std::size_t(links[l])][1 - own_end(level.mesh, links[l])] = receive_[n][l];
    }
}

void LevelMessages::start_parts(const MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending)
{
    start_links(level, communicator, pending,
                [&](int link, std::size_t end) { return level.half_part[std::size_t(level.mesh.half_of[std::size_t(link)][end])]; });
}

void LevelMessages::complete_parts(MultigridLevel& level) const
{
    for (std::size_t n = 0; n < level.mesh.exchanges.size(); ++n) {
        const auto& links = level.mesh.exchanges[n].links;
        for (std::size_t l = 0; l < links.size(); ++l) {
            const int half = level.mesh.half_of[std::size_t(links[l])][own_end(level.mesh, links[l])];
            level.half_received[std::size_t(half)] = receive_[n][l];
        }
    }
}

template <class ForContent>
void LevelMessages::start_to_all(ForContent for_content, const core::Communicator& communicator, core::Pending& pending)
{
    constexpr std::size_t word = sizeof(float);
    const auto size = [&](int rank) {
        std::size_t sum = 0;
        for_content(rank, [&](const auto*, std::size_t n) { sum += n; });
        return sum;
    };
    const auto ranks = std::size_t(communicator.size()), me = std::size_t(communicator.rank());
    prepare(ranks);
    auto& mine = send_[me];
    mine.resize(size(int(me)) * word);
    auto* out = mine.data();
    for_content(int(me), [&](const auto* from, std::size_t count) {
        if (count > 0) std::memcpy(out, from, count * word);
        out += count * word;
    });
    for (std::size_t r = 0; r < ranks; ++r) {
        if (r == me) continue;
        receive_[r].resize(size(int(r)));
        if (!receive_[r].empty()) communicator.receive(std::as_writable_bytes(std::span(receive_[r])), int(r), tag, pending);
        if (!mine.empty()) communicator.send(mine, int(r), tag, pending);
    }
}

template <class ForContent>
void LevelMessages::complete_from_all(ForContent for_content, const core::Communicator& communicator) const
{
    for (int r = 0; r < communicator.size(); ++r) {
        if (r == communicator.rank()) continue;
        const float* in = receive_[std::size_t(r)].data();
        for_content(r, [&](auto* to, std::size_t count) {
            if (count > 0) std::memcpy(to, in, count * sizeof(float));
            in += count;
        });
    }
}

void LevelMessages::start_blocks(MultigridLevel& level, Content content, const core::Communicator& communicator, core::Pending& pending)
{
    start_to_all([&](int rank, auto body) { for_content(level, content, rank, body); }, communicator, pending);
}

void LevelMessages::complete_blocks(MultigridLevel& level, Content content, const core::Communicator& communicator) const
{
    complete_from_all([&](int rank, auto body) { for_content(level, content, rank, body); }, communicator);
}

void LevelMessages::start_counts(AggregateLevels& levels, const core::Communicator& communicator, core::Pending& pending)
{
    communicator.start_max(levels.counts(), pending);
}

void LevelMessages::start_aggregates(AggregateLevels& levels, AggregateLevels::Content content, const core::Communicator& communicator,
                                     core::Pending& pending)
{
    start_to_all([&](int rank, auto body) { levels.for_content(content, rank, body); }, communicator, pending);
}

void LevelMessages::complete_aggregates(AggregateLevels& levels, AggregateLevels::Content content,
                                        const core::Communicator& communicator) const
{
    complete_from_all([&](int rank, auto body) { levels.for_content(content, rank, body); }, communicator);
}

void LevelMessages::start_choices(MultigridLevel& level, const core::Communicator& communicator, core::Pending& pending)
{
    choices_.assign(4 * level.choices.size(), -1.0); // less than anything that an owner says
    for (const auto id : level.mesh.layout.ids()) {
        const LineChoice& c = level.choices[std::size_t(id)];
        double* numbers = choices_.data() + 4 * id;
        numbers[0] = static_cast<int>(c.axis);
        numbers[1] = c.anisotropy;
        std::copy(c.hold.begin(), c.hold.end(), numbers + 2);
    }
    communicator.start_max(choices_, pending);
}

void LevelMessages::complete_choices(MultigridLevel& level) const
{
    for (std::size_t b = 0; b < level.choices.size(); ++b)
        level.choices[b] = {static_cast<LineAxis>(int(choices_[4 * b])), choices_[4 * b + 1], {choices_[4 * b + 2], choices_[4 * b + 3]}};
}

namespace {

std::span<float> numbers_of_lines(MultigridLevel& level, LevelMessages::OfLines content, core::BlockId b)
{
    return content == LevelMessages::OfLines::ports ? level.chains.port_values(b) : level.chains.ends(b);
}

} // namespace

void LevelMessages::start_lines(MultigridLevel& level, OfLines content, const core::Communicator& communicator, core::Pending& pending)
{
    const auto partners = level.chains.partners();
    prepare(partners.size());
    for (std::size_t n = 0; n < partners.size(); ++n) {
        std::size_t size = 0;
        for (const auto b : partners[n].theirs) size += numbers_of_lines(level, content, b).size();
        receive_[n].resize(size);
        communicator.receive(std::as_writable_bytes(std::span(receive_[n])), partners[n].rank, tag, pending);
        send_[n].clear();
        for (const auto b : partners[n].mine) {
            const auto bytes = std::as_bytes(numbers_of_lines(level, content, b));
            send_[n].insert(send_[n].end(), bytes.begin(), bytes.end());
        }
        communicator.send(send_[n], partners[n].rank, tag, pending);
    }
}

void LevelMessages::complete_lines(MultigridLevel& level, OfLines content) const
{
    for (std::size_t n = 0; n < level.chains.partners().size(); ++n) {
        const float* in = receive_[n].data();
        for (const auto b : level.chains.partners()[n].theirs) {
            const auto to = numbers_of_lines(level, content, b);
            std::copy_n(in, to.size(), to.begin());
            in += to.size();
        }
    }
}

} // namespace physics
