// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Named quantities on the blocks of this rank. Memory exists only between allocate() and release(): a field that no
// stage of a run touches costs nothing.
#include "core/field/array3.hpp"
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace core {

/// Index of a block among those of this rank.
using LocalBlock = int;

/// What a field is: its name in reports and files, its unit, and the halo that its readers may need.
struct FieldInfo {
    std::string name;
    std::string unit;
    int halo = 1;
    bool persistent = false;   ///< carried from step to step, hence written to checkpoints
    bool at_sub_faces = false; ///< filled halos include what is interpolated to the centres of sub-faces (sub_face_values.hpp)
};

/// Components of a vector quantity, each an array of its own.
template <class T>
struct VectorView {
    View<T> x, y, z;
    [[nodiscard]] View<T> component(int c) const { return c == 0 ? x : c == 1 ? y : z; }
    operator VectorView<const T>() const requires(!std::is_const_v<T>) { return {x, y, z}; }
};

/// Gradients of the components of a vector quantity: [c].component(m) is the derivative of component c along axis m.
template <class T>
using TensorView = std::array<VectorView<T>, 3>;

/// What the arrays of a field are, for those who see them from axes that are turned.
enum class Components {
    scalars, ///< each by itself
    vector,  ///< the components of a vector
    tensor   ///< those of a TensorView, one after the other
};

/// Number of the axis of FaceView along which sub-faces lie.
inline constexpr int along_sub_faces = 3;

/// Values on the faces of a block: i(i, j, k) lies on the low-i face of cell (i, j, k); i is (ni + 1, nj, nk) and so on. Behind them, as
/// if along a fourth axis, one for each of BlockGeometry::sub_faces: fluxes are from a to b there, and those of joined faces their sums.
template <class T>
struct FaceView {
    static constexpr int axes = along_sub_faces + 1;
    View<T> i, j, k;
    View<T> sub_faces{}; ///< (their number, 1, 1)
    [[nodiscard]] View<T> along(int axis) const { return axis == 0 ? i : axis == 1 ? j : axis == 2 ? k : sub_faces; }
    operator FaceView<const T>() const requires(!std::is_const_v<T>) { return {i, j, k, sub_faces}; }
};

/// Common part of the fields: `Arrays` arrays of doubles in each block.
template <std::size_t Arrays>
class FieldStorage {
public:
    [[nodiscard]] std::string_view name() const { return info_.name; }
    [[nodiscard]] const FieldInfo& info() const { return info_; }
    [[nodiscard]] Components components() const { return components_; }
    [[nodiscard]] bool allocated() const { return !blocks_.empty() || shapes_.empty(); }
    [[nodiscard]] std::size_t bytes() const
    {
        std::size_t total = 0;
        for (const auto& block : blocks_)
            for (const auto& array : block) total += array.data().size() * sizeof(double);
        return total;
    }
    [[nodiscard]] std::size_t blocks() const { return shapes_.size(); }
    /// All values of one array of one block, halo included: for checkpoints, digests and fills.
    [[nodiscard]] std::vector<double>& data(LocalBlock b, std::size_t array) { return blocks_[std::size_t(b)][array].data(); }
    [[nodiscard]] const std::vector<double>& data(LocalBlock b, std::size_t array) const { return blocks_[std::size_t(b)][array].data(); }
    /// Pointer to element (0, 0, 0) of one array of one block.
    [[nodiscard]] double* origin(LocalBlock b, std::size_t array) { return block(b)[array].view().row(0, 0); }
    static constexpr std::size_t arrays = Arrays;

    /// Gives every block zeroed memory; keeps the values if there are some already.
    void allocate()
    {
        if (allocated()) return;
        for (const auto& shape : shapes_) {
            auto& block = blocks_.emplace_back();
            for (std::size_t a = 0; a < Arrays; ++a) block[a] = Array3<double>(shape[a], info_.halo, 0.0);
        }
    }
    void release() { blocks_.clear(); }

protected:
    using Shape = std::array<Extents, Arrays>;
    FieldStorage(FieldInfo info, std::vector<Shape> shapes, Components components = Components::scalars)
        : info_(std::move(info)), shapes_(std::move(shapes)), components_(components)
    {
    }
    [[nodiscard]] auto& block(LocalBlock b) { return blocks_[std::size_t(b)]; }
    [[nodiscard]] const auto& block(LocalBlock b) const { return blocks_[std::size_t(b)]; }

private:
    FieldInfo info_;
    std::vector<Shape> shapes_;
    Components components_;
    std::vector<std::array<Array3<double>, Arrays>> blocks_;
};

/// One number in each cell.
class ScalarField : public FieldStorage<1> {
public:
    /// @param cells  Extents of each block of this rank.
    ScalarField(FieldInfo info, std::span<const Extents> cells);
    [[nodiscard]] View<double> on(LocalBlock b) { return block(b)[0].view(); }
    [[nodiscard]] View<const double> on(LocalBlock b) const { return block(b)[0].view(); }
};

/// A Cartesian vector in each cell, stored as three arrays.
class VectorField : public FieldStorage<3> {
public:
    VectorField(FieldInfo info, std::span<const Extents> cells);
    [[nodiscard]] VectorView<double> on(LocalBlock b)
    {
        auto& a = block(b);
        return {a[0].view(), a[1].view(), a[2].view()};
    }
    [[nodiscard]] VectorView<const double> on(LocalBlock b) const
    {
        const auto& a = block(b);
        return {a[0].view(), a[1].view(), a[2].view()};
    }
};

/// The gradient of a Cartesian vector in each cell, stored as nine arrays.
class TensorField : public FieldStorage<9> {
public:
    TensorField(FieldInfo info, std::span<const Extents> cells);
    [[nodiscard]] TensorView<double> on(LocalBlock b) { return views<double>(block(b)); }
    [[nodiscard]] TensorView<const double> on(LocalBlock b) const { return views<const double>(block(b)); }

private:
    template <class T, class Block>
    static TensorView<T> views(Block& a)
    {
        return {
            {{a[0].view(), a[1].view(), a[2].view()}, {a[3].view(), a[4].view(), a[5].view()}, {a[6].view(), a[7].view(), a[8].view()}}};
    }
};

/// One number on each face and sub-face; no halo.
class FaceField : public FieldStorage<4> {
public:
    FaceField(FieldInfo info, std::span<const Extents> cells);
    [[nodiscard]] FaceView<double> on(LocalBlock b)
    {
        auto& a = block(b);
        return {a[0].view(), a[1].view(), a[2].view(), a[3].view()};
    }
    [[nodiscard]] FaceView<const double> on(LocalBlock b) const
    {
        const auto& a = block(b);
        return {a[0].view(), a[1].view(), a[2].view(), a[3].view()};
    }
};

} // namespace core
