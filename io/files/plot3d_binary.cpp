// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/plot3d_parts.hpp"
#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <optional>

namespace io {

namespace {

/// One way of writing the same grid.
struct Form {
    bool swapped, records, counted, blanked;
    std::size_t real; ///< bytes of a number

    [[nodiscard]] std::string words() const
    {
        return fmt::format("binary, {} bits, {}-endian{}{}{}", 8 * real, swapped ? "big" : "little", records ? ", records" : "",
                           counted ? "" : ", one block", blanked ? ", blanking" : "");
    }
};

/// Takes numbers from the front of the bytes.
class Bytes {
public:
    Bytes(const std::string& bytes, const Form& form) : bytes_(bytes), form_(form) {}

    [[nodiscard]] bool done() const { return next_ == bytes_.size(); }
    [[nodiscard]] bool has(std::size_t bytes) const { return bytes <= bytes_.size() - next_; }

    template <class T>
    [[nodiscard]] T take()
    {
        std::array<char, sizeof(T)> raw{};
        std::copy_n(bytes_.begin() + std::ptrdiff_t(next_), sizeof(T), raw.begin());
        if (form_.swapped) std::reverse(raw.begin(), raw.end());
        next_ += sizeof(T);
        T value;
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }

    [[nodiscard]] double real() { return form_.real == 4 ? double(take<float>()) : take<double>(); }

    /// Fortran writes the length of each record before and behind it. False if it is another one, or too long.
    [[nodiscard]] bool mark(std::size_t length)
    {
        if (!form_.records) return true;
        return has(4) && std::size_t(take<std::uint32_t>()) == length;
    }

private:
    const std::string& bytes_;
    Form form_;
    std::size_t next_ = 0;
};

/// Number of blocks and their sizes; nothing if they make no sense.
[[nodiscard]] std::optional<std::vector<Plot3dBlock>> header(Bytes& bytes, const Form& form)
{
    std::size_t count = 1;
    if (form.counted) {
        if (!bytes.mark(4) || !bytes.has(4)) return {};
        const auto n = bytes.take<std::int32_t>();
        if (n < 1 || n > 1'000'000 || !bytes.mark(4)) return {};
        count = std::size_t(n);
    }
    if (!bytes.mark(12 * count) || !bytes.has(12 * count)) return {};
    std::vector<Plot3dBlock> blocks(count);
    for (auto& block : blocks)
        for (int* n : {&block.points.ni, &block.points.nj, &block.points.nk}) {
            *n = bytes.take<std::int32_t>();
            if (*n < 1 || *n > 1'000'000) return {};
        }
    if (!bytes.mark(12 * count)) return {};
    return blocks;
}

/// The blocks, if the file fits this form to the last byte.
[[nodiscard]] std::optional<std::vector<Plot3dBlock>> read(const std::string& all, const Form& form)
{
    Bytes bytes(all, form);
    auto blocks = header(bytes, form);
    if (!blocks) return {};
    std::size_t expected = 0;
    for (const auto& block : *blocks) {
        const double points = double(block.points.ni) * block.points.nj * block.points.nk;
        if (points > double(all.size())) return {};
        expected += std::size_t(points) * (3 * form.real + (form.blanked ? 4 : 0)) + (form.records ? 8 : 0);
        if (expected > all.size()) return {};
    }
    if (!bytes.has(expected) || bytes.has(expected + 1)) return {};
    for (auto& block : *blocks) {
        const auto points = std::size_t(block.points.size());
        const std::size_t length = points * (3 * form.real + (form.blanked ? 4 : 0));
        if (!bytes.mark(length)) return {};
        block.numbers.reserve(4 * points);
        for (std::size_t n = 0; n < 3 * points; ++n) block.numbers.push_back(bytes.real());
        for (std::size_t n = 0; form.blanked && n < points; ++n) block.numbers.push_back(bytes.take<std::int32_t>());
        if (!bytes.mark(length)) return {};
    }
    return blocks;
}

} // namespace

std::vector<Plot3dBlock> read_plot3d_binary(const std::string& bytes, const std::string& file, std::string& form)
{
    for (int way = 0; way < 32; ++way) {
        const Form tried{(way & 1) != 0, (way & 2) == 0, (way & 4) == 0, (way & 8) != 0, (way & 16) != 0 ? 4U : 8U};
        if (auto blocks = read(bytes, tried)) {
            form = tried.words();
            return *blocks;
        }
    }
    throw core::ConfigError(
        fmt::format("{}: its {} bytes are not a three-dimensional Plot3D grid in any form: 32 or 64 bits, either order of bytes, "
                    "with or without record marks, number of blocks, blanking; it may be torn",
                    file, bytes.size()));
}

} // namespace io
