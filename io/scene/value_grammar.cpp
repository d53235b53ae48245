// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// The kinds of values that have a small grammar of their own: widths ("2 d"), intervals ("every 60 s wall"), points [2 s, 1].
#include "io/scene/value.hpp"

#include <fmt/format.h>

namespace io {

namespace {

[[nodiscard]] bool is_scalar(const Node& node, const Value& value, const Reading& reading)
{
    if (node.kind == Node::Kind::scalar) return true;
    reading.problems.add(node.mark, fmt::format("a value is needed here, not {}", name_of(node.kind)), "write " + form_of(value));
    return false;
}

void read_width(const Node& node, const Value& value, Width& place, const Reading& reading)
{
    if (!is_scalar(node, value, reading)) return;
    const auto [number, unit] = split_quantity(node.text);
    Width width{0.0, unit == "d"};
    if (width.in_diameters) {
        width.value = reading.units.read(number, "1").value;
    } else {
        const QuantityResult length = reading.units.read(node.text, "m");
        if (!length.error.empty()) return reading.problems.add(node.mark, length.error, "write " + form_of(value));
        width.value = length.value;
    }
    if (!value.range.contains(width.value))
        return reading.problems.add(node.mark, fmt::format("'{}' is out of range", node.text), "write " + form_of(value));
    place = width;
}

/// Takes a word off the end of the text.
[[nodiscard]] bool take_last_word(std::string& text, const std::string& word)
{
    if (!text.ends_with(" " + word)) return false;
    text.resize(text.find_last_not_of(' ', text.size() - word.size() - 1) + 1);
    return true;
}

void read_interval(const Node& node, const Value& value, Interval& place, const Reading& reading)
{
    if (!is_scalar(node, value, reading)) return;
    if (node.text == "never") {
        place = {};
        return;
    }
    const std::string every = "every ";
    if (!node.text.starts_with(every))
        return reading.problems.add(node.mark, fmt::format("'{}' is not an interval", node.text), "write " + form_of(value));
    std::string rest = node.text.substr(every.size());
    Interval interval{Interval::Clock::simulated};
    if (take_last_word(rest, "wall")) interval.clock = Interval::Clock::wall;
    else if (take_last_word(rest, "steps")) interval.clock = Interval::Clock::steps;
    const bool counts = interval.clock == Interval::Clock::steps;
    const QuantityResult length = reading.units.read(rest, counts ? "1" : "s");
    if (!length.error.empty()) return reading.problems.add(node.mark, length.error, "write " + form_of(value));
    interval.every = length.value;
    const bool whole = interval.every == static_cast<double>(static_cast<long long>(interval.every));
    if (interval.every <= 0.0 || (counts && !whole))
        return reading.problems.add(node.mark, fmt::format("'{}' is out of range", node.text),
                                    counts ? "write a whole number of steps > 0" : "write a time > 0 s");
    place = interval;
}

[[nodiscard]] std::string interval_text(const Interval& interval)
{
    const std::string number = number_text(interval.every);
    switch (interval.clock) {
    case Interval::Clock::never: return "never";
    case Interval::Clock::simulated: return "every " + number + " s";
    case Interval::Clock::wall: return "every " + number + " s wall";
    case Interval::Clock::steps: return "every " + number + " steps";
    }
    return "";
}

void read_points(const Node& node, const Value& value, std::vector<std::array<double, 2>>& place, const Reading& reading)
{
    const auto complain = [&](const Node& at, const std::string& message) {
        reading.problems.add(at.mark, message, "write " + form_of(value));
    };
    if (node.kind != Node::Kind::list) return complain(node, "this must be a list, and is " + name_of(node.kind));
    const char* quantity = value.unit == "s" ? "time" : "length";
    place.clear();
    for (const Node& item : node.items) {
        if (item.kind != Node::Kind::list || item.items.size() != 2)
            return complain(item, fmt::format("a point [{}, value] is needed here", quantity));
        std::array<double, 2> point{};
        const std::size_t before = reading.problems.size();
        value_of(point[0], value.unit, any_number).read(item.items[0], reading);
        value_of(point[1], "1", any_number).read(item.items[1], reading);
        if (reading.problems.size() != before) return;
        if (!place.empty() && point[0] <= place.back()[0])
            return complain(item, fmt::format("the {}s of a table must increase, and {} {} follows {} {}", quantity, number_text(point[0]),
                                              value.unit, number_text(place.back()[0]), value.unit));
        place.push_back(point);
    }
    if (place.size() < 2) complain(node, "a table needs at least two points");
}

} // namespace

Value value_of(std::vector<std::array<double, 2>>& place, std::string_view unit, Range range)
{
    Value value;
    value.shape = Value::Shape::points;
    value.unit = unit;
    value.range = range;
    value.read = [&place, value](const Node& n, const Reading& r) { read_points(n, value, place, r); };
    value.write = [&place, u = std::string(unit)] {
        std::string all;
        for (const auto& [time, number] : place)
            all += fmt::format("{}[{} {}, {}]", all.empty() ? "" : ", ", number_text(time), u, number_text(number));
        return all.empty() ? all : "[" + all + "]";
    };
    return value;
}

Value value_of(Width& place, std::string_view unit, Range range)
{
    Value value;
    value.shape = Value::Shape::width;
    value.unit = unit;
    value.range = range;
    value.read = [&place, value](const Node& n, const Reading& r) { read_width(n, value, place, r); };
    value.write = [&place] { return number_text(place.value) + (place.in_diameters ? " d" : " m"); };
    return value;
}

Value value_of(Interval& place, std::string_view unit, Range range)
{
    Value value;
    value.shape = Value::Shape::interval;
    value.unit = unit;
    value.range = range;
    value.read = [&place, value](const Node& n, const Reading& r) { read_interval(n, value, place, r); };
    value.write = [&place] { return interval_text(place); };
    return value;
}

} // namespace io
