// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Numbers that agree relative to their own size: doctest's Approx adds 1 to it, so that small SI numbers always agree.
#include <doctest/doctest.h>

namespace test {

/// @param value  Not zero. The tolerance is that of doctest, 1.2e-5, unless .epsilon() says another.
[[nodiscard]] inline doctest::Approx relative(double value) { return doctest::Approx(value).scale(0); }

} // namespace test
