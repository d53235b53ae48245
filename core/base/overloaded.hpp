// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// One function object out of several: what std::visit calls with each alternative of a variant.

namespace core {

template <class... Cases>
struct Overloaded : Cases... {
    using Cases::operator()...;
};

} // namespace core
