// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/files/stl.hpp"
#include "core/base/error.hpp"
#include "io/scene/scene_reader.hpp"
#include "io/scene/units.hpp"
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

namespace io {
namespace {

using core::ConfigError, core::require, core::text, core::Vec3;
using Corners = std::array<Vec3, 3>;

constexpr std::size_t header = 84, record = 50; // bytes before the first triangle and of each

static_assert(std::endian::native == std::endian::little, "STL files are little-endian");

template <class T>
T value_at(const std::string& bytes, std::size_t place)
{
    T value;
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
}

std::vector<Corners> read_binary(const std::string& bytes, const std::string& name)
{
    std::vector<Corners> triangles(value_at<std::uint32_t>(bytes, header - 4));
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t c = 0; c < 3; ++c)
            for (std::size_t a = 0; a < 3; ++a) {
                const std::size_t place = header + t * record + 12 * (c + 1) + 4 * a;
                const float x = value_at<float>(bytes, place);
                require<ConfigError>(std::isfinite(x),
                                     text(name, ": byte ", place, ": triangle ", t + 1, " has a corner that is no number"));
                triangles[t][c][int(a)] = double(x);
            }
    return triangles;
}

/// Words of a text, with the line that each stands in.
class Words {
public:
    Words(const std::string& content, const std::string& name) : content_(content), name_(name) {}

    /// The next word; empty at the end.
    std::string_view next()
    {
        while (place_ < content_.size() && is_blank(content_[place_]))
            if (content_[place_++] == '\n') ++line_;
        const std::size_t begin = place_;
        while (place_ < content_.size() && !is_blank(content_[place_])) ++place_;
        return std::string_view(content_).substr(begin, place_ - begin);
    }
    void skip_line() { place_ = std::min(content_.find('\n', place_), content_.size()); }
    void expect(std::string_view word)
    {
        const std::string_view found = next();
        require<ConfigError>(found == word, text(name_, ":", line_, ": '", word, "' is needed here, and this is '", found, "'"));
    }
    [[nodiscard]] double number()
    {
        const std::string word(next());
        const auto value = parse_number(word);
        require<ConfigError>(value && std::isfinite(*value),
                             text(name_, ":", line_, ": a number is needed here, and this is '", word, "'"));
        return *value;
    }
    [[nodiscard]] int line() const { return line_; }

private:
    static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }
    const std::string& content_;
    const std::string& name_;
    std::size_t place_ = 0;
    int line_ = 1;
};

Corners read_facet(Words& words)
{
    words.expect("normal");
    for (int a = 0; a < 3; ++a) (void)words.next();
    words.expect("outer");
    words.expect("loop");
    Corners corners;
    for (Vec3& corner : corners) {
        words.expect("vertex");
        for (int a = 0; a < 3; ++a) corner[a] = words.number();
    }
    words.expect("endloop");
    words.expect("endfacet");
    return corners;
}

std::vector<Corners> read_text(const std::string& content, const std::string& name)
{
    std::vector<Corners> triangles;
    Words words(content, name);
    for (std::string_view solid = words.next(); !solid.empty(); solid = words.next()) {
        require<ConfigError>(solid == "solid", text(name, ":", words.line(), ": 'solid' is needed here, and this is '", solid, "'"));
        words.skip_line();
        std::string_view word = words.next();
        for (; word == "facet"; word = words.next()) triangles.push_back(read_facet(words));
        require<ConfigError>(word == "endsolid",
                             text(name, ":", words.line(), ": 'facet' or 'endsolid' is needed here, and this is '", word, "'"));
        words.skip_line();
    }
    return triangles;
}

} // namespace

std::vector<Corners> read_stl(const std::filesystem::path& file)
{
    const std::string content = text_of(file), name = file.string();
    std::vector<Corners> triangles;
    // Some binary files begin with "solid", too: their length tells.
    const std::size_t wanted = content.size() < header ? 0 : header + record * value_at<std::uint32_t>(content, header - 4);
    if (content.size() == wanted) triangles = read_binary(content, name);
    else {
        require<ConfigError>(content.starts_with("solid"),
                             text(name, ": byte 0: this is no STL file in text, and as a binary one it would have ", wanted, " bytes, not ",
                                  content.size()));
        triangles = read_text(content, name);
    }
    require<ConfigError>(!triangles.empty(), text(name, ": there are no triangles in this file"));
    return triangles;
}

void write_stl(const std::filesystem::path& file, const std::vector<Corners>& triangles)
{
    std::ofstream out(file, std::ios::binary);
    const auto write = [&](const auto& value) { out.write(reinterpret_cast<const char*>(&value), sizeof value); };
    out << std::string(header - 4, ' ');
    write(std::uint32_t(triangles.size()));
    for (const Corners& corners : triangles) {
        const Vec3 normal = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
        for (const Vec3& v : {normal, corners[0], corners[1], corners[2]})
            for (int a = 0; a < 3; ++a) write(float(v[a]));
        write(std::uint16_t(0));
    }
    require<core::FileError>(bool(out.flush()), text(file.string(), ": cannot be written"));
}

} // namespace io
