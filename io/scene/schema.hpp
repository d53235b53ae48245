// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A parameter struct is described once, by `void describe(Schema&, Struct&)`: key, place, unit, meaning, range; the value
// of a default-constructed struct is the default. Reading, checking, the resolved scene, the JSON Schema and
// `isago explain` are visitors of these descriptions.
#include "io/scene/value.hpp"
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace io {

enum class Need { required, has_default, optional };

/// One key with one value.
struct Leaf {
    std::string key;
    std::string meaning;
    Need need = Need::has_default;
    Value value;
};

class Schema;

/// A group of keys below a key.
struct Group {
    std::string key; ///< For a group that the user names: what stands for the name, such as <material>.
    std::string meaning;
    Need need = Need::has_default;
    std::string* name = nullptr; ///< The user chooses the key, and it is kept here.
    bool present = true;
    std::function<void()> make;           ///< Makes an optional group present.
    std::function<void(Schema&)> inside;  ///< Describes the struct in its place; only when present.
    std::function<void(Schema&)> example; ///< Describes a default-constructed struct.
};

/// A list of groups below a key.
struct List {
    std::string key;
    std::string meaning;
    std::size_t size = 0;
    std::function<void(std::size_t)> resize;
    std::function<void(Schema&, std::size_t)> item;
    std::function<void(Schema&)> example;
};

/// What a description speaks to.
class Schema {
public:
    virtual ~Schema() = default;

    /// A value with a default; an std::optional without a value has none and may be left out.
    template <class T>
    void value(std::string_view key, T& place, std::string_view unit, std::string_view meaning, Range range = {})
    {
        add(key, meaning, Need::has_default, value_of(place, unit, range));
    }

    /// A value that must be given.
    template <class T>
    void required(std::string_view key, T& place, std::string_view unit, std::string_view meaning, Range range = {})
    {
        add(key, meaning, Need::required, value_of(place, unit, range));
    }

    /// A value whose form the other two do not know, such as a choice of words.
    void value(std::string_view key, std::string_view meaning, Value value) { add(key, meaning, Need::has_default, std::move(value)); }
    void required(std::string_view key, std::string_view meaning, Value value) { add(key, meaning, Need::required, std::move(value)); }

    /// Keys below a key; every one of them has a default.
    template <class T>
    void group(std::string_view key, T& place, std::string_view meaning)
    {
        on_group(group_of(key, place, meaning, Need::has_default));
    }

    template <class T>
    void group(std::string_view key, std::optional<T>& place, std::string_view meaning)
    {
        Group group;
        group.key = key;
        group.meaning = meaning;
        group.need = Need::optional;
        group.present = place.has_value();
        group.make = [&place] { place.emplace(); };
        group.inside = [&place](Schema& s) { describe(s, *place); };
        group.example = example_of<T>();
        on_group(group);
    }

    template <class T>
    void required_group(std::string_view key, T& place, std::string_view meaning)
    {
        on_group(group_of(key, place, meaning, Need::required));
    }

    /// Exactly one group whose key the user chooses; `place.name` keeps it.
    template <class T>
    void named_group(std::string_view stand_in, T& place, std::string_view meaning)
    {
        Group group = group_of(stand_in, place, meaning, Need::required);
        group.name = &place.name;
        on_group(group);
    }

    template <class T>
    void list(std::string_view key, std::vector<T>& place, std::string_view meaning)
    {
        List list;
        list.key = key;
        list.meaning = meaning;
        list.size = place.size();
        list.resize = [&place](std::size_t n) { place.assign(n, T{}); };
        list.item = [&place](Schema& s, std::size_t n) { describe(s, place[n]); };
        list.example = example_of<T>();
        on_list(list);
    }

    /// Exactly one of these keys must be given.
    virtual void exactly_one(const std::vector<std::string>& keys) = 0;

protected:
    virtual void on_value(const Leaf& leaf) = 0;
    virtual void on_group(const Group& group) = 0;
    virtual void on_list(const List& list) = 0;

private:
    void add(std::string_view key, std::string_view meaning, Need need, Value value)
    {
        on_value({std::string(key), std::string(meaning), need, std::move(value)});
    }

    template <class T>
    static std::function<void(Schema&)> example_of()
    {
        return [](Schema& s) {
            T example{};
            describe(s, example);
        };
    }

    template <class T>
    static Group group_of(std::string_view key, T& place, std::string_view meaning, Need need)
    {
        Group group;
        group.key = key;
        group.meaning = meaning;
        group.need = need;
        group.inside = [&place](Schema& s) { describe(s, place); };
        group.example = example_of<T>();
        return group;
    }
};

} // namespace io
