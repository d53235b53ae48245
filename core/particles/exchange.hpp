// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Bytes of any length between all ranks in two rounds of messages that nobody has to wait for in between.
#include "core/comm/communicator.hpp"

#include <cstring>
#include <type_traits>

namespace core {

/// Fill outgoing[rank], post the lengths, and when they are there the data; then read incoming[rank].
class Exchange {
public:
    void start(int ranks);
    void post_lengths(const Communicator& communicator, Pending& pending);
    void post_data(const Communicator& communicator, Pending& pending);

    std::vector<std::vector<std::byte>> outgoing, incoming;

private:
    std::vector<std::int64_t> out_length_, in_length_;
};

/// Appends the bytes of `values`.
template <class T>
void write_bytes(std::vector<std::byte>& bytes, std::span<const T> values)
{
    static_assert(std::is_trivially_copyable_v<T>);
    const auto place = bytes.size();
    bytes.resize(place + values.size_bytes());
    if (!values.empty()) std::memcpy(bytes.data() + place, values.data(), values.size_bytes());
}

template <class T>
void write_bytes(std::vector<std::byte>& bytes, const T& value)
{
    write_bytes(bytes, std::span<const T>(&value, 1));
}

/// Reads values one after the other from the bytes of a message.
class ByteReader {
public:
    explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}
    [[nodiscard]] bool empty() const { return bytes_.empty(); }
    template <class T>
    T read()
    {
        static_assert(std::is_trivially_copyable_v<T>);
        T value;
        std::memcpy(&value, bytes_.data(), sizeof(T));
        bytes_ = bytes_.subspan(sizeof(T));
        return value;
    }

private:
    std::span<const std::byte> bytes_;
};

} // namespace core
