// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A three-dimensional array with halo layers, and the light view of it that kernels take.
#include "core/grid/extents.hpp"
#include <cassert>
#include <cstddef>
#include <type_traits>
#include <vector>

namespace core {

/// Offset from element (0, 0, 0) to what lies behind the last element of the halo.
[[nodiscard]] inline std::ptrdiff_t end_of_halo(Extents e, int halo)
{
    const std::ptrdiff_t stride_j = e.ni + 2 * halo, stride_k = stride_j * (e.nj + 2 * halo);
    return stride_k * (e.nk + halo) - halo * (1 + stride_j);
}

/// Non-owning view; i is contiguous, (0, 0, 0) the first interior element, `halo` layers lie around the interior.
template <class T>
class View {
public:
    View() = default;
    View(T* origin, Extents extents, int halo)
        : origin_(origin), extents_(extents), halo_(halo), stride_j_(extents.ni + 2 * halo), stride_k_(stride_j_ * (extents.nj + 2 * halo))
    {
    }

    [[nodiscard]] T& operator()(int i, int j, int k) const
    {
        assert(i >= -halo_ && j >= -halo_ && k >= -halo_);
        assert(i < extents_.ni + halo_ && j < extents_.nj + halo_ && k < extents_.nk + halo_);
        return origin_[i + stride_j_ * j + stride_k_ * k];
    }
    [[nodiscard]] T& operator[](Index3 c) const { return (*this)(c.i, c.j, c.k); }
    /// Element at a flat offset, as given by offset().
    [[nodiscard]] T& at(std::ptrdiff_t offset) const { return origin_[offset]; }
    [[nodiscard]] std::ptrdiff_t offset(int i, int j, int k) const { return i + stride_j_ * j + stride_k_ * k; }
    /// Number n of those behind the halo.
    [[nodiscard]] T& behind_halo(int n) const
    {
        assert(n >= 0 && n < extents_.sub_face_values);
        return origin_[end_of_halo(extents_, halo_) + n];
    }
    /// First interior element of a row along i.
    [[nodiscard]] T* row(int j, int k) const { return origin_ + stride_j_ * j + stride_k_ * k; }
    [[nodiscard]] Extents extents() const { return extents_; }
    [[nodiscard]] int halo() const { return halo_; }
    [[nodiscard]] std::ptrdiff_t stride(int axis) const { return axis == 0 ? 1 : axis == 1 ? stride_j_ : stride_k_; }
    /// Read-only view of the same elements.
    operator View<const T>() const requires(!std::is_const_v<T>) { return {origin_, extents_, halo_}; }

private:
    T* origin_ = nullptr;
    Extents extents_;
    int halo_ = 0;
    std::ptrdiff_t stride_j_ = 0, stride_k_ = 0;
};

/// Owner of the elements of a View.
template <class T>
class Array3 {
public:
    Array3() = default;
    explicit Array3(Extents extents, int halo = 0, T value = T{})
        : extents_(extents),
          halo_(halo),
          data_(std::size_t(Extents{extents.ni + 2 * halo, extents.nj + 2 * halo, extents.nk + 2 * halo}.size() +
                            (halo > 0 ? extents.sub_face_values : 0)),
                value)
    {
    }

    [[nodiscard]] View<T> view() { return {data_.data() + origin(), extents_, halo_}; }
    [[nodiscard]] View<const T> view() const { return {data_.data() + origin(), extents_, halo_}; }
    [[nodiscard]] T& operator()(int i, int j, int k) { return view()(i, j, k); }
    [[nodiscard]] const T& operator()(int i, int j, int k) const { return view()(i, j, k); }
    [[nodiscard]] Extents extents() const { return extents_; }
    [[nodiscard]] int halo() const { return halo_; }
    /// All elements, the halo and what lies behind it included.
    [[nodiscard]] std::vector<T>& data() { return data_; }
    [[nodiscard]] const std::vector<T>& data() const { return data_; }

private:
    [[nodiscard]] std::ptrdiff_t origin() const
    {
        const std::ptrdiff_t stride_j = extents_.ni + 2 * halo_;
        return halo_ * (1 + stride_j * (1 + (extents_.nj + 2 * halo_)));
    }

    Extents extents_;
    int halo_ = 0;
    std::vector<T> data_;
};

} // namespace core
