// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One stage of a step as the graph remembers it: what it touches and what it does, all types forgotten.
#include "core/comm/communicator.hpp"
#include "tasks/access.hpp"
#include "tasks/lane.hpp"
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tasks {

enum class Region { interior, halo };

/// One region of one resource, and what a stage does there (Mode::update_halo is an update of Region::halo).
struct Touch {
    const void* resource = nullptr;
    Region region = Region::interior;
    Mode mode = Mode::read;
    bool divided = false;

    [[nodiscard]] bool reads() const { return mode != Mode::write; }
    [[nodiscard]] bool changes() const { return mode != Mode::read; }
};

/// The blocks of this rank, and how many cells make a task that is worth scheduling. Numerics are per block all the same.
struct Layout {
    std::vector<std::ptrdiff_t> cells; ///< of each block of this rank
    std::ptrdiff_t cells_per_task = 4096;
    [[nodiscard]] int blocks() const { return int(cells.size()); }
};

struct Stage {
    std::string name;
    std::string lane;
    std::vector<Touch> touches;
    std::function<void(LocalBlock)> on_block; ///< of an each_block stage; empty for a whole stage
    std::function<Job(Lane&)> job;            ///< of a whole stage that may wait for messages
    std::function<void(Lane&)> on_rank;       ///< of any other whole stage
    std::optional<std::string> effect;        ///< label of an effect outside the graph; "" = in every step
    std::optional<FieldRef> halo_of;          ///< of a stage that fills a halo
    core::HaloReach halo_reach{};
    std::optional<core::Communicator> communicator; ///< of a whole stage, once compiled

    [[nodiscard]] bool whole() const { return !on_block; }
    [[nodiscard]] bool communicates() const { return bool(job); }
};

/// The touches that an access declares.
template <Resource R, Mode M>
void add_touches(const Access<R, M>& access, std::vector<Touch>& touches)
{
    const bool divided = Divided<R>;
    if constexpr (M == Mode::update_halo) {
        touches.push_back({access.resource, Region::interior, Mode::read, divided});
        touches.push_back({access.resource, Region::halo, Mode::update, divided});
    } else {
        touches.push_back({access.resource, Region::interior, M, divided});
        if (access.halo.width > 0) touches.push_back({access.resource, Region::halo, Mode::read, divided});
    }
}

namespace detail {

template <class Access>
inline constexpr bool fits_blocks = Access::mode == Mode::read || Divided<typename Access::Type>;

template <class Kernel, class Accesses>
inline constexpr bool calls_block = false;
template <class Kernel, class... A>
inline constexpr bool calls_block<Kernel, std::tuple<A...>> =
    (fits_blocks<A> && ...) && std::is_invocable_v<const Kernel&, LocalBlock, decltype(std::declval<const A&>().on(0))...>;

template <class Kernel, class Accesses>
struct WholeResult {
    using Type = int; // neither void nor Job: not a kernel
};
template <class Kernel, class... A>
requires std::is_invocable_v<const Kernel&, Lane&, decltype(std::declval<const A&>().whole())...>
struct WholeResult<Kernel, std::tuple<A...>> {
    using Type = std::invoke_result_t<const Kernel&, Lane&, decltype(std::declval<const A&>().whole())...>;
};

template <class... Groups>
using Accesses = decltype(std::tuple_cat(std::declval<Groups>()...));

} // namespace detail

/// kernel(block, parts...) in the order of the declared accesses; all blocks at once, so only what is divided may change.
template <class Kernel, class... Groups>
concept BlockKernel = detail::calls_block<Kernel, detail::Accesses<Groups...>>;

/// kernel(lane, resources...) in the order of the declared accesses; returns void or Job.
template <class Kernel, class... Groups>
concept WholeKernel = std::is_void_v<typename detail::WholeResult<Kernel, detail::Accesses<Groups...>>::Type> ||
    std::is_same_v<typename detail::WholeResult<Kernel, detail::Accesses<Groups...>>::Type, Job>;

} // namespace tasks
