// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// What a stage can read or write: fields with a part in each block, and whole objects of which a rank has one.
#include "core/field/field.hpp"
#include "core/grid/halo_map.hpp"
#include <concepts>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>

namespace tasks {

using core::LocalBlock;

/// Has a name. Its address tells it from others, so it stays where it is while a graph knows it.
template <class R>
concept Resource = requires(const R& r)
{
    {
        r.name()
        } -> std::convertible_to<std::string_view>;
};

/// A resource with a part in each block. A const resource hands out read-only parts: this makes declarations bind.
template <class R>
concept Divided = Resource<R> && requires(R& r, const R& c, LocalBlock b)
{
    r.on(b);
    c.on(b);
};

/// A resource around an object: kernels get the object.
template <class R>
concept Holder = Resource<R> && requires(R& r, const R& c)
{
    r.get();
    c.get();
};

/// One object on each rank, such as the time step or a set of particles.
template <class T>
class Value {
public:
    explicit Value(std::string name, T value = T{}) : name_(std::move(name)), value_(std::move(value)) {}
    [[nodiscard]] std::string_view name() const { return name_; }
    [[nodiscard]] T& get() { return value_; }
    [[nodiscard]] const T& get() const { return value_; }

private:
    std::string name_;
    T value_;
};

/// A name for an object that lives elsewhere; it must outlive every graph that knows it.
template <class T>
class Part {
public:
    Part(std::string name, T& object) : name_(std::move(name)), object_(&object) {}
    [[nodiscard]] std::string_view name() const { return name_; }
    [[nodiscard]] T& get() { return *object_; }
    [[nodiscard]] const T& get() const { return *object_; }

private:
    std::string name_;
    T* object_;
};

/// One object for each block of this rank, such as partial sums or the grains of a block.
template <class T>
class PerBlock {
public:
    PerBlock(std::string name, std::size_t blocks, T value = T{}) : name_(std::move(name)), parts_(blocks, Slot{value}) {}
    [[nodiscard]] std::string_view name() const { return name_; }
    [[nodiscard]] std::size_t size() const { return parts_.size(); }
    [[nodiscard]] T& on(LocalBlock b) { return parts_[std::size_t(b)].value; }
    [[nodiscard]] const T& on(LocalBlock b) const { return parts_[std::size_t(b)].value; }

private:
    struct Slot { // a struct, so that PerBlock<bool> has addressable parts
        T value;
    };
    std::string name_;
    std::vector<Slot> parts_;
};

/// A field whose halo can be filled.
using FieldRef = std::variant<core::ScalarField*, core::VectorField*, core::TensorField*>;

template <class R>
inline constexpr bool has_halo =
    std::is_same_v<R, core::ScalarField> || std::is_same_v<R, core::VectorField> || std::is_same_v<R, core::TensorField>;

/// What the graph remembers of a resource, its type forgotten.
struct ResourceRecord {
    const void* id = nullptr;
    std::string name;
    bool divided = false;
    std::function<void()> allocate;     ///< empty where the resource owns its memory from the start
    std::function<std::size_t()> bytes; ///< empty where unknown
};

template <Resource R>
[[nodiscard]] ResourceRecord record_of(R& resource)
{
    ResourceRecord record{&resource, std::string(resource.name()), Divided<R>, {}, {}};
    if constexpr (requires { resource.allocate(); }) record.allocate = [&resource] { resource.allocate(); };
    if constexpr (requires { resource.bytes(); }) record.bytes = [&resource] { return std::size_t(resource.bytes()); };
    return record;
}

} // namespace tasks
