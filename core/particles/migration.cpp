// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/particles/migration.hpp"
#include "core/particles/exchange.hpp"

namespace core {

void pack_particle(const ParticleSet& particles, const ContactHistory& history, int i, std::vector<std::byte>& bytes)
{
    const auto k = std::size_t(i);
    write_bytes(bytes, particles.id[k]);
    write_bytes(bytes, particles.species[k]);
    ParticleSet::for_each_column(particles, [&](const Column& column) { write_bytes(bytes, column[k]); });
    const int begin = history.start[k], end = history.start[k + 1];
    write_bytes(bytes, end - begin);
    for (int c = begin; c < end; ++c) {
        write_bytes(bytes, history.other[std::size_t(c)]);
        for (int a = 0; a < history.width; ++a) write_bytes(bytes, history.spring[std::size_t(history.width * c + a)]);
    }
}

void unpack_particles(std::span<const std::byte> bytes, ParticleSet& particles, ContactHistory& history)
{
    ByteReader reader(bytes);
    while (!reader.empty()) {
        const auto k = std::size_t(particles.owned);
        particles.resize_owned(particles.owned + 1);
        particles.id[k] = reader.read<std::int64_t>();
        particles.species[k] = reader.read<std::int32_t>();
        ParticleSet::for_each_column(particles, [&](Column& column) { column[k] = reader.read<double>(); });
        const int contacts = reader.read<int>();
        for (int c = 0; c < contacts; ++c) {
            const auto other = reader.read<std::int64_t>();
            Spring value{};
            for (int a = 0; a < history.width; ++a) value[std::size_t(a)] = reader.read<double>();
            history.add(other, value);
        }
        history.end_row();
    }
}

} // namespace core
