// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/halo.hpp"
#include "core/comm/turned_values.hpp"
#include "core/grid/sub_face_values.hpp"
#include <algorithm>
#include <cassert>
#include <cstring>
#include <map>

namespace core {
namespace {

constexpr int tag_fill = 1, tag_transpose = 2;

/// What one rank asks of another: the value of `cell` of `block`, for halo element `element` of `target`.
struct Request {
    BlockId block;
    Index3 cell;
    BlockId target;
    std::int64_t element;
    double weight;
};

std::ptrdiff_t offset_of(Extents cells, int halo, Index3 c)
{
    const std::ptrdiff_t sj = cells.ni + 2 * halo, sk = sj * (cells.nj + 2 * halo);
    return c.i + sj * c.j + sk * c.k;
}

template <class T>
std::vector<std::byte> to_bytes(const std::vector<T>& items)
{
    std::vector<std::byte> bytes(items.size() * sizeof(T));
    if (!items.empty()) std::memcpy(bytes.data(), items.data(), bytes.size());
    return bytes;
}

template <class T>
std::vector<T> from_bytes(const std::vector<std::byte>& bytes)
{
    std::vector<T> items(bytes.size() / sizeof(T));
    if (!items.empty()) std::memcpy(items.data(), bytes.data(), bytes.size());
    return items;
}

/// A halo value on its way home, with what fixes its place in the sum.
struct HomeBound {
    CellPlace home;
    BlockId target;
    std::int64_t element;
    int rank;
    std::ptrdiff_t slot;
    CellPlace place;
    double weight;
};

} // namespace

HaloExchange::HaloExchange(const Mesh& mesh, const Communicator& communicator, int field_halo, int width, HaloShape shape, Behind behind)
    : communicator_(communicator.duplicate())
{
    request(mesh, communicator, field_halo, width, shape, behind);
    find_copies();
}

int HaloExchange::turn_number(const Motion& motion)
{
    if (!motion.turns) return -1;
    const Mat3 turn = motion.turn.transpose();
    const auto place = std::find(turns_.begin(), turns_.end(), turn) - turns_.begin();
    if (place == std::ssize(turns_)) turns_.push_back(turn);
    return int(place);
}

void HaloExchange::find_copies()
{
    std::map<std::pair<LocalBlock, LocalBlock>, Copies> copies;
    for (const Row& row : rows_) {
        const std::span<const Source> sources(sources_.data() + row.first, std::size_t(row.last - row.first));
        if (std::any_of(sources.begin(), sources.end(), [](const Source& s) { return s.turn >= 0; })) {
            turned_.push_back(row);
            continue;
        }
        if (std::any_of(sources.begin(), sources.end(), [](const Source& s) { return s.rank >= 0; })) {
            arrivals_.push_back(row);
            continue;
        }
        if (sources.size() > 1) {
            const int first = int(blend_sources_.size());
            for (const Source& s : sources) blend_sources_.push_back({s.place.block, int(s.place.offset), s.weight});
            blends_.push_back({row.target, first, int(blend_sources_.size())});
            continue;
        }
        const Source& source = sources.front();
        Copies& between =
            copies.try_emplace({row.target.block, source.place.block}, Copies{row.target.block, source.place.block, {}}).first->second;
        between.values.add(row.target.offset, source.place.offset);
    }
    for (auto& [blocks, between] : copies) copies_.push_back(std::move(between));
}

void HaloExchange::request(const Mesh& mesh, const Communicator& communicator, int field_halo, int width, HaloShape shape, Behind behind)
{
    std::vector<std::vector<Request>> requests(std::size_t(communicator.size()));
    std::vector<HomeBound> bound;
    for (LocalBlock b = 0; b < mesh.own_count(); ++b) {
        const Extents n = mesh.own_cells()[std::size_t(b)];
        const auto add = [&](const CellPlace& target, std::int64_t element, const std::vector<HaloSource>& row) {
            Row r{target, int(sources_.size()), 0};
            for (const HaloSource& s : row) {
                const int rank = mesh.owner(s.block), turn = turn_number(s.motion);
                if (rank == communicator.rank()) {
                    const CellPlace place{mesh.local(s.block), offset_of(mesh.cells(s.block), field_halo, s.cell)};
                    sources_.push_back({-1, turn, 0, place, s.weight});
                    bound.push_back({place, mesh.global(b), element, -1, 0, target, s.weight});
                } else {
                    auto& list = requests[std::size_t(rank)];
                    sources_.push_back({rank, turn, std::ptrdiff_t(list.size()), {}, s.weight});
                    list.push_back({s.block, s.cell, mesh.global(b), element, s.weight});
                }
            }
            r.last = int(sources_.size());
            rows_.push_back(r);
        };
        for (const HaloRow& row : halo_rows(mesh.topology(), mesh.global(b), width, shape))
            add({b, offset_of(n, field_halo, row.cell)}, offset_of(n, width, row.cell), row.sources);
        const SubFaceValues values = sub_face_values(mesh.topology(), mesh.global(b));
        const auto add_behind = [&](int number, const std::vector<HaloSource>& sources) {
            add({b, end_of_halo(n, field_halo) + number}, end_of_halo(n, width) + number, sources);
        };
        for (std::size_t c = 0; c < values.cells.size(); ++c) add_behind(int(c), {values.cells[c]});
        if (behind == Behind::all)
            for (const BlockSubFace& face : values.faces) add_behind(face.at_centre, centre_sources(mesh.topology(), *face.face));
    }
    std::vector<std::vector<std::byte>> asked;
    for (const auto& list : requests) {
        asked.push_back(to_bytes(list));
        wanted_there_.push_back(std::ptrdiff_t(list.size()));
    }
    for (const auto& bytes : communicator.exchange_all(asked)) {
        const int rank = int(wanted_from_here_.size());
        auto& wanted = wanted_from_here_.emplace_back();
        for (const Request& q : from_bytes<Request>(bytes)) {
            const CellPlace place{mesh.local(q.block), offset_of(mesh.cells(q.block), field_halo, q.cell)};
            bound.push_back({place, q.target, q.element, rank, std::ptrdiff_t(wanted.size()), {}, q.weight});
            wanted.push_back(place);
        }
    }
    std::sort(bound.begin(), bound.end(), [](const HomeBound& a, const HomeBound& b) {
        return std::tuple(a.home.block, a.home.offset, a.target, a.element, a.weight) <
               std::tuple(b.home.block, b.home.offset, b.target, b.element, b.weight);
    });
    for (const HomeBound& h : bound) {
        const bool another = homes_.empty() || homes_.back().target.block != h.home.block || homes_.back().target.offset != h.home.offset;
        if (another) homes_.push_back({h.home, int(contributions_.size()), 0});
        contributions_.push_back({h.rank, h.slot, h.place, h.weight});
        homes_.back().last = int(contributions_.size());
    }
}

void HaloExchange::post(Flight& flight, const Communicator& space, bool transpose, std::size_t arrays) const
{
    const std::size_t ranks = wanted_there_.size();
    flight.received.resize(ranks);
    for (std::size_t r = 0; r < ranks; ++r) {
        const std::size_t in = (transpose ? wanted_from_here_[r].size() : std::size_t(wanted_there_[r])) * arrays;
        flight.received[r].resize(in);
        const int tag = transpose ? tag_transpose : tag_fill;
        if (in > 0) space.receive(std::as_writable_bytes(std::span(flight.received[r])), int(r), tag, flight.pending);
        if (!flight.sent[r].empty()) space.send(std::as_bytes(std::span(flight.sent[r])), int(r), tag, flight.pending);
    }
}

void HaloExchange::start_arrays(const Arrays& arrays, Flight& flight, const Communicator& space) const
{
    flight.sent.resize(wanted_from_here_.size());
    for (std::size_t r = 0; r < wanted_from_here_.size(); ++r) {
        auto& buffer = flight.sent[r];
        buffer.clear();
        for (const CellPlace& p : wanted_from_here_[r])
            for (std::size_t a = 0; a < arrays.count; ++a) buffer.push_back(arrays.of(p.block)[a][p.offset]);
    }
    post(flight, space, false, arrays.count);
}

void HaloExchange::finish_arrays(const Arrays& arrays, const Flight& flight) const
{
    const std::size_t count = arrays.count;
    for (const Copies& block : copies_)
        for (std::size_t a = 0; a < count; ++a) block.values.copy(arrays.of(block.source)[a], arrays.of(block.target)[a]);
    for (const Row& row : blends_) {
        double* const* target = arrays.of(row.target.block);
        const auto term = [&](int n, std::size_t a) {
            const BlendSource& s = blend_sources_[std::size_t(n)];
            return s.weight * arrays.of(s.block)[a][s.offset];
        };
        for (std::size_t a = 0; a < count; ++a) {
            double sum = term(row.first, a); // as it is, should it be -0
            for (int n = row.first + 1; n < row.last; ++n) sum += term(n, a);
            target[a][row.target.offset] = sum;
        }
    }
    for (const Row& row : arrivals_) blend(arrays, flight, row);
    finish_turned(arrays, flight);
}

double HaloExchange::value(const Arrays& arrays, const Flight& flight, const Source& source, std::size_t array)
{
    return source.rank < 0 ? arrays.of(source.place.block)[array][source.place.offset]
                           : flight.received[std::size_t(source.rank)][std::size_t(source.slot) * arrays.count + array];
}

void HaloExchange::blend(const Arrays& arrays, const Flight& flight, const Row& row) const
{
    const std::span<const Source> sources(sources_.data() + row.first, std::size_t(row.last - row.first));
    double* const* target = arrays.of(row.target.block);
    for (std::size_t a = 0; a < arrays.count; ++a) {
        double sum = sources[0].weight * value(arrays, flight, sources[0], a);
        for (const Source& s : sources.subspan(1)) sum += s.weight * value(arrays, flight, s, a);
        target[a][row.target.offset] = sum;
    }
}

void HaloExchange::finish_turned(const Arrays& arrays, const Flight& flight) const
{
    const bool is_tensor = arrays.components == Components::tensor;
    for (const Row& row : turned_) {
        if (arrays.components == Components::scalars) {
            blend(arrays, flight, row);
            continue;
        }
        CellValues sum{};
        for (int n = row.first; n < row.last; ++n) {
            const Source& s = sources_[std::size_t(n)];
            CellValues q{};
            for (std::size_t a = 0; a < arrays.count; ++a) q[a] = value(arrays, flight, s, a);
            if (s.turn >= 0) q = is_tensor ? turned_tensor(turns_[std::size_t(s.turn)], q) : turned_vector(turns_[std::size_t(s.turn)], q);
            for (std::size_t a = 0; a < arrays.count; ++a) sum[a] += s.weight * q[a];
        }
        for (std::size_t a = 0; a < arrays.count; ++a) arrays.of(row.target.block)[a][row.target.offset] = sum[a];
    }
}

void HaloExchange::start_transpose_arrays(const Arrays& arrays, Flight& flight, const Communicator& space) const
{
    assert(turns_.empty());
    flight.sent.resize(wanted_there_.size());
    const std::size_t count = arrays.count;
    for (std::size_t r = 0; r < wanted_there_.size(); ++r) flight.sent[r].assign(std::size_t(wanted_there_[r]) * count, 0.0);
    for (const Row& row : rows_)
        for (int n = row.first; n < row.last; ++n) {
            const Source& s = sources_[std::size_t(n)];
            if (s.rank < 0) continue;
            for (std::size_t a = 0; a < count; ++a)
                flight.sent[std::size_t(s.rank)][std::size_t(s.slot) * count + a] = arrays.of(row.target.block)[a][row.target.offset];
        }
    post(flight, space, true, arrays.count);
}

void HaloExchange::finish_transpose_arrays(const Arrays& arrays, const Flight& flight) const
{
    const std::size_t count = arrays.count;
    for (const Home& home : homes_) {
        double* const* target = arrays.of(home.target.block);
        for (int n = home.first; n < home.last; ++n) {
            const Contribution& c = contributions_[std::size_t(n)];
            const auto add = [&](auto value) {
                for (std::size_t a = 0; a < count; ++a) target[a][home.target.offset] += c.weight * value(a);
            };
            if (c.rank < 0) add([from = arrays.of(c.place.block), at = c.place.offset](std::size_t a) { return from[a][at]; });
            else
                add([values = flight.received[std::size_t(c.rank)].data() + std::size_t(c.slot) * count](std::size_t a) {
                    return values[a];
                });
        }
    }
    for (const Row& row : rows_)
        for (std::size_t a = 0; a < count; ++a) arrays.of(row.target.block)[a][row.target.offset] = 0;
}

} // namespace core
