// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Room for lists that are made anew again and again and differ little in length.
#include <vector>

namespace core {

/// Makes `values` n long; what they were is lost. Where they must grow, a sixteenth is left free: std::vector would double their room.
template <class T>
void renew(std::vector<T>& values, std::size_t n)
{
    if (n > values.capacity()) {
        values = {};
        values.reserve(n + n / 16);
    }
    values.resize(n);
}

} // namespace core
