// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One value of a scene as the schema sees it: its kind, unit and range, and how its place in a struct is read and written.
#include "core/base/vec3.hpp"
#include "io/scene/problems.hpp"
#include "io/scene/units.hpp"
#include "io/scene/yaml.hpp"
#include <array>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace io {

/// Which numbers are allowed.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false; ///< The low end itself is not allowed.

    [[nodiscard]] bool contains(double x) const { return (low_open ? x > low : x >= low) && x <= high; }
    /// "> 0", "0 to 1", ...; empty when every number is allowed.
    [[nodiscard]] std::string text() const;
};
inline constexpr Range any_number{};
inline constexpr Range positive{0.0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0.0};
[[nodiscard]] constexpr Range between(double low, double high) { return {low, high}; }
[[nodiscard]] constexpr Range at_least(double low) { return {low}; }

/// A length given in metres, or in volume-mean particle diameters ("2 d").
struct Width {
    double value = 0.0;
    bool in_diameters = true;
    bool operator==(const Width&) const = default;
};

/// How often something happens: "every 18 ms", "every 60 s wall", "every 10 steps", or "never".
struct Interval {
    enum class Clock { never, simulated, wall, steps };
    Clock clock = Clock::never;
    double every = 0.0; ///< [s], or steps.
    bool operator==(const Interval&) const = default;
};

/// What a reading needs besides the place: the units, and where to put problems.
struct Reading {
    const Units& units;
    Problems& problems;
};

struct Value {
    enum class Shape { text, integer, number, quantity, choice, width, interval, direction, points };
    Shape shape = Shape::text;
    std::string unit; ///< Of a quantity; "1" for a pure number; empty for the rest.
    Range range;
    std::vector<std::string> words; ///< Of a choice.
    int length = 0;                 ///< 0: a single value; n > 0: a list of n; -1: a list of any length.
    std::function<void(const Node&, const Reading&)> read;
    std::function<std::string()> write; ///< YAML text of the present value; empty when there is none.
};

/// One sentence on what the user writes: "a quantity in m (> 0)", "one of small, medium, large".
[[nodiscard]] std::string form_of(const Value& value);

/// A YAML scalar that reads back as this text.
[[nodiscard]] std::string yaml_text(const std::string& text);

[[nodiscard]] Value value_of(double& place, std::string_view unit, Range range);
[[nodiscard]] Value value_of(int& place, std::string_view unit, Range range);
[[nodiscard]] Value value_of(std::string& place, std::string_view unit, Range range);
[[nodiscard]] Value value_of(Width& place, std::string_view unit, Range range);
[[nodiscard]] Value value_of(Interval& place, std::string_view unit, Range range);
/// Points [quantity, number] in the order of the quantity, which has the unit.
[[nodiscard]] Value value_of(std::vector<std::array<double, 2>>& place, std::string_view unit, Range range);
/// Three quantities [x, y, z].
[[nodiscard]] Value value_of(core::Vec3& place, std::string_view unit, Range range);
/// Two names [a, b].
[[nodiscard]] Value value_of(std::array<std::string, 2>& place, std::string_view unit, Range range);
/// Three counts [x, y, z].
[[nodiscard]] Value value_of(std::array<int, 3>& place, std::string_view unit, Range range);

/// A unit vector: "-y", or three numbers of any length but zero.
[[nodiscard]] Value direction_of(core::Vec3& place);

/// The position of a scalar among `words`, or -1 with a problem that suggests the nearest word.
[[nodiscard]] int read_choice(const Node& node, std::span<const std::string_view> words, const Reading& reading);

/// One word of an enumeration whose words are given in the order of its enumerators.
template <class Enumeration>
[[nodiscard]] Value choice_of(Enumeration& place, std::span<const std::string_view> words)
{
    Value value;
    value.shape = Value::Shape::choice;
    value.words.assign(words.begin(), words.end());
    value.read = [&place, words](const Node& node, const Reading& reading) {
        if (const int n = read_choice(node, words, reading); n >= 0) place = static_cast<Enumeration>(n);
    };
    value.write = [&place, words] { return std::string(words[static_cast<std::size_t>(place)]); };
    return value;
}

/// A word that may be left out.
template <class Enumeration>
[[nodiscard]] Value choice_of(std::optional<Enumeration>& place, std::span<const std::string_view> words)
{
    Enumeration inside{};
    Value value = choice_of(inside, words);
    value.read = [&place, words](const Node& node, const Reading& reading) {
        if (const int n = read_choice(node, words, reading); n >= 0) place = static_cast<Enumeration>(n);
    };
    value.write = [&place, words] { return place ? std::string(words[static_cast<std::size_t>(*place)]) : std::string(); };
    return value;
}

/// A list of words of an enumeration.
template <class Enumeration>
[[nodiscard]] Value choices_of(std::vector<Enumeration>& place, std::span<const std::string_view> words)
{
    Value value;
    value.shape = Value::Shape::choice;
    value.words.assign(words.begin(), words.end());
    value.length = -1;
    value.read = [&place, words](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::list)
            return reading.problems.add(node.mark, "this must be a list, and is " + name_of(node.kind), "write [...]");
        place.clear();
        for (const Node& item : node.items)
            if (const int n = read_choice(item, words, reading); n >= 0) place.push_back(static_cast<Enumeration>(n));
    };
    value.write = [&place, words] {
        std::string all;
        for (auto word : place) all += (all.empty() ? "" : ", ") + std::string(words[static_cast<std::size_t>(word)]);
        return "[" + all + "]";
    };
    return value;
}

/// A value that may be left out; it is written only when it is there.
template <class T>
[[nodiscard]] Value value_of(std::optional<T>& place, std::string_view unit, Range range)
{
    T inside{};
    Value value = value_of(inside, unit, range);
    value.read = [&place, u = std::string(unit), range](const Node& node, const Reading& reading) {
        T read{};
        value_of(read, u, range).read(node, reading);
        place = read;
    };
    value.write = [&place, u = std::string(unit), range] { return place ? value_of(*place, u, range).write() : std::string(); };
    return value;
}

} // namespace io
