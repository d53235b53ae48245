// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/value.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>

namespace io {

namespace {

using Shape = Value::Shape;

/// The text of a scalar; a problem, and nothing, for anything else.
[[nodiscard]] std::optional<std::string> scalar(const Node& node, const std::string& form, const Reading& reading)
{
    if (node.kind == Node::Kind::scalar) return node.text;
    reading.problems.add(node.mark, fmt::format("a value is needed here, not {}", name_of(node.kind)), "write " + form);
    return {};
}

void read_quantity(const Node& node, const Value& value, double& place, const Reading& reading)
{
    const auto text = scalar(node, form_of(value), reading);
    if (!text) return;
    const auto [number, error, hint] = reading.units.read(*text, value.unit);
    if (!error.empty()) return reading.problems.add(node.mark, error, hint);
    if (!value.range.contains(number))
        return reading.problems.add(node.mark, fmt::format("'{}' is out of range", *text), "write " + form_of(value));
    place = number;
}

void read_integer(const Node& node, const Value& value, int& place, const Reading& reading)
{
    const auto text = scalar(node, form_of(value), reading);
    if (!text) return;
    int number = 0;
    const char* begin = text->data() + (text->starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text->data() + text->size(), number);
    if (error != std::errc() || end != text->data() + text->size())
        return reading.problems.add(node.mark, fmt::format("'{}' is not a whole number", *text), "write " + form_of(value));
    if (!value.range.contains(number))
        return reading.problems.add(node.mark, fmt::format("'{}' is out of range", *text), "write " + form_of(value));
    place = number;
}

[[nodiscard]] bool read_three(const Node& node, const Value& value, const Reading& reading)
{
    if (node.kind == Node::Kind::list && node.items.size() == 3) return true;
    const std::string found = node.kind == Node::Kind::list ? fmt::format("a list of {}", node.items.size()) : name_of(node.kind);
    reading.problems.add(node.mark, "three values [x, y, z] are needed here, not " + found, "write " + form_of(value));
    return false;
}

[[nodiscard]] std::string quantity_text(double number, const std::string& unit)
{
    return unit == "1" ? number_text(number) : number_text(number) + " " + unit;
}

[[nodiscard]] Value make(Shape shape, std::string_view unit, Range range, int length = 0)
{
    Value value;
    value.shape = shape;
    value.unit = unit;
    value.range = range;
    value.length = length;
    return value;
}

constexpr std::array<std::string_view, 6> axis_words{"+x", "-x", "+y", "-y", "+z", "-z"};

void read_direction(const Node& node, const Value& value, core::Vec3& place, const Reading& reading)
{
    if (node.kind == Node::Kind::scalar) {
        const Node with_sign = [&] {
            Node copy = node;
            if (copy.text.size() == 1) copy.text.insert(0, 1, '+');
            return copy;
        }();
        const int n = read_choice(with_sign, axis_words, reading);
        if (n >= 0) place = core::Vec3::Unit(n / 2) * (n % 2 == 0 ? 1.0 : -1.0);
        return;
    }
    if (!read_three(node, value, reading)) return;
    core::Vec3 vector = core::Vec3::Zero();
    const Value number = make(Shape::number, "1", any_number);
    for (int axis = 0; axis < 3; ++axis) read_quantity(node.items[static_cast<std::size_t>(axis)], number, vector[axis], reading);
    if (vector.norm() == 0.0) return reading.problems.add(node.mark, "a direction must not be zero", "write " + form_of(value));
    place = vector.normalized() == vector ? vector : vector.normalized();
}

[[nodiscard]] std::string direction_text(const core::Vec3& direction)
{
    for (int n = 0; n < 6; ++n)
        if (direction == core::Vec3::Unit(n / 2) * (n % 2 == 0 ? 1.0 : -1.0)) return std::string(axis_words[static_cast<std::size_t>(n)]);
    return fmt::format("[{}, {}, {}]", number_text(direction.x()), number_text(direction.y()), number_text(direction.z()));
}

} // namespace

std::string Range::text() const
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (low > -infinity && high < infinity) return fmt::format("{}{} to {}", low_open ? "above " : "", number_text(low), number_text(high));
    if (low > -infinity) return fmt::format("{} {}", low_open ? ">" : ">=", number_text(low));
    if (high < infinity) return "<= " + number_text(high);
    return "";
}

std::string form_of(const Value& value)
{
    const std::string range = value.range.text().empty() ? "" : " (" + value.range.text() + ")";
    std::string words;
    for (const auto& word : value.words) words += (words.empty() ? "" : ", ") + word;
    std::string form;
    switch (value.shape) {
    case Shape::text: form = "a text"; break;
    case Shape::integer: form = "a whole number" + range; break;
    case Shape::number: form = "a number" + range; break;
    case Shape::quantity: form = "a quantity in " + value.unit + range; break;
    case Shape::choice: form = "one of " + words; break;
    case Shape::width: form = "a quantity in m, or in particle diameters ('2 d')" + range; break;
    case Shape::interval: form = "'every 18 ms', 'every 60 s wall', 'every 10 steps' or 'never'"; break;
    case Shape::points:
        form = fmt::format("a list of points, such as [[0 {0}, 0], [2 {0}, 1], [4 {0}, 0.5]], the first numbers of which rise", value.unit);
        break;
    case Shape::direction: form = "+x, -x, +y, -y, +z, -z or three numbers [x, y, z]"; break;
    }
    if (value.length == 2) return "two names [a, b]";
    if (value.length == 3) return "three values [x, y, z], each " + form;
    if (value.length < 0) return "a list, each item " + form;
    return form;
}

Value value_of(double& place, std::string_view unit, Range range)
{
    Value value = make(unit == "1" ? Shape::number : Shape::quantity, unit, range);
    value.read = [&place, value](const Node& n, const Reading& r) { read_quantity(n, value, place, r); };
    value.write = [&place, u = value.unit] { return quantity_text(place, u); };
    return value;
}

Value value_of(int& place, std::string_view unit, Range range)
{
    Value value = make(Shape::integer, unit, range);
    value.read = [&place, value](const Node& n, const Reading& r) { read_integer(n, value, place, r); };
    value.write = [&place] { return std::to_string(place); };
    return value;
}

Value value_of(std::string& place, std::string_view unit, Range range)
{
    Value value = make(Shape::text, unit, range);
    value.read = [&place, value](const Node& n, const Reading& r) {
        if (const auto text = scalar(n, form_of(value), r)) place = *text;
    };
    value.write = [&place] { return place.empty() ? std::string() : yaml_text(place); };
    return value;
}

Value value_of(std::array<std::string, 2>& place, std::string_view unit, Range range)
{
    Value value = make(Shape::text, unit, range, 2);
    value.read = [&place, value](const Node& node, const Reading& reading) {
        if (node.kind != Node::Kind::list || node.items.size() != 2)
            return reading.problems.add(node.mark, "two names [a, b] are needed here", "write " + form_of(value));
        for (std::size_t n = 0; n < 2; ++n)
            if (const auto text = scalar(node.items[n], form_of(value), reading)) place[n] = *text;
    };
    value.write = [&place] { return fmt::format("[{}, {}]", yaml_text(place[0]), yaml_text(place[1])); };
    return value;
}

Value value_of(core::Vec3& place, std::string_view unit, Range range)
{
    Value value = make(unit == "1" ? Shape::number : Shape::quantity, unit, range, 3);
    value.read = [&place, value](const Node& node, const Reading& reading) {
        if (!read_three(node, value, reading)) return;
        Value one = make(value.shape, value.unit, value.range);
        for (int axis = 0; axis < 3; ++axis) read_quantity(node.items[static_cast<std::size_t>(axis)], one, place[axis], reading);
    };
    value.write = [&place, u = value.unit] {
        return fmt::format("[{}, {}, {}]", quantity_text(place.x(), u), quantity_text(place.y(), u), quantity_text(place.z(), u));
    };
    return value;
}

Value value_of(std::array<int, 3>& place, std::string_view unit, Range range)
{
    Value value = make(Shape::integer, unit, range, 3);
    value.read = [&place, value](const Node& node, const Reading& reading) {
        if (!read_three(node, value, reading)) return;
        Value one = make(value.shape, value.unit, value.range);
        for (std::size_t axis = 0; axis < 3; ++axis) read_integer(node.items[axis], one, place[axis], reading);
    };
    value.write = [&place] { return fmt::format("[{}, {}, {}]", place[0], place[1], place[2]); };
    return value;
}

Value direction_of(core::Vec3& place)
{
    Value value = make(Shape::direction, "", any_number);
    value.read = [&place, value](const Node& n, const Reading& r) { read_direction(n, value, place, r); };
    value.write = [&place] { return direction_text(place); };
    return value;
}

int read_choice(const Node& node, std::span<const std::string_view> words, const Reading& reading)
{
    const std::vector<std::string> all(words.begin(), words.end());
    Value value = make(Shape::choice, "", any_number);
    value.words = all;
    const auto text = scalar(node, form_of(value), reading);
    if (!text) return -1;
    const auto found = std::find(all.begin(), all.end(), *text);
    if (found != all.end()) return static_cast<int>(found - all.begin());
    reading.problems.add(node.mark, fmt::format("'{}' is not one of the choices", *text), suggestion(*text, all));
    return -1;
}

std::string yaml_text(const std::string& text)
{
    const bool plain = std::all_of(text.begin(), text.end(),
                                   [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-'; });
    if (plain && !text.empty() && text.front() != '-' && text != "null" && text != "Null" && text != "NULL") return text;
    std::string quoted = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') quoted += '\\';
        quoted += c == '\n' ? "\\n" : std::string(1, c);
    }
    return quoted + "\"";
}

} // namespace io
