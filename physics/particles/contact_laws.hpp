// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The contact laws of a scene: the plainest kind that serves all its materials, chosen once.
#include "core/particles/particle_set.hpp"
#include "physics/particles/lubrication.hpp"

#include <variant>

namespace physics {

/// The laws of all pairs of species, or of all materials of walls with all species; one entry serves all. The kind is the same for all
/// entries, so that a loop over contacts is compiled for it: linear springs, Hertz' springs, whatever else a scene mixes, or that with a
/// film before it.
using ContactLaws =
    std::variant<std::vector<LinearContact>, std::vector<HertzContact>, std::vector<GeneralContact>, std::vector<LubricatedContact>>;

/// The laws of `parameters.pairs`, species x species. @throws core::ConfigError for a wrong number of entries or values out of range.
[[nodiscard]] ContactLaws pair_laws(const ParticleParameters& parameters, double step);
/// The laws of `parameters.walls`, wall materials x species.
[[nodiscard]] ContactLaws wall_laws(const ParticleParameters& parameters, double step);

/// True where contacts hold rolling and twist: they need core::rolling_memory, and act with torques of their own.
[[nodiscard]] inline bool resist_turning(const ContactLaws& laws)
{
    return std::visit([]<class Law>(const std::vector<Law>&) { return Law::resists_turning; }, laws);
}
/// For each of `count` pairs of species, or of a wall's material and a species, the number of the first law that is equal to its own:
/// what has one number runs in one loop.
[[nodiscard]] std::vector<int> kinds_of(const ContactLaws& laws, int count);
/// Time step [s].
[[nodiscard]] inline double step_of(const ContactLaws& laws)
{
    return std::visit([](const auto& entries) { return entries.front().step; }, laws);
}

/// Calls run(law_of), where law_of(k) is the law of contact k. @param entry  Of each contact, its place among the laws of many.
template <class Run>
void with_laws(const ContactLaws& laws, const int* entry, Run run)
{
    std::visit(
        [&]<class Law>(const std::vector<Law>& entries) {
            if (entries.size() == 1) run([law = entries.front()](int) -> const Law& { return law; });
            else run([all = entries.data(), entry](int k) -> const Law& { return all[std::size_t(entry[k])]; });
        },
        laws);
}

/// The springs of a run of contacts: pointers for vector code. The last three are null where contacts do not resist turning.
struct SpringColumns {
    double *sx, *sy, *sz, *rx = nullptr, *ry = nullptr, *rz = nullptr;
};

/// @param begin  The contact that is to be number 0.
[[nodiscard]] inline SpringColumns spring_columns(std::vector<core::Column>& c, std::size_t begin = 0)
{
    const auto from = [&](std::size_t a) { return c[a].data() + begin; };
    if (c.size() < 6) return {from(0), from(1), from(2)};
    return {from(0), from(1), from(2), from(3), from(4), from(5)};
}

/// The force of contact k, whose springs move one step on.
template <class Law>
[[gnu::always_inline]] inline auto move_springs(const Law& law, ContactInput& in, const SpringColumns& springs, int k)
{
    in.sx = springs.sx[k];
    in.sy = springs.sy[k];
    in.sz = springs.sz[k];
    if constexpr (Law::resists_turning) {
        in.rx = springs.rx[k];
        in.ry = springs.ry[k];
        in.rz = springs.rz[k];
    }
    const auto out = law(in);
    springs.sx[k] = out.sx;
    springs.sy[k] = out.sy;
    springs.sz[k] = out.sz;
    if constexpr (Law::resists_turning) {
        springs.rx[k] = out.rx;
        springs.ry[k] = out.ry;
        springs.rz[k] = out.rz;
    }
    return out;
}

} // namespace physics
