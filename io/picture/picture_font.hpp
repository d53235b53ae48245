// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// The letters of picture captions.
#include <string_view>

namespace io::detail {

/// Strokes of an ASCII letter, separated by blanks; see picture_font.cpp.
[[nodiscard]] std::string_view strokes_of(char letter);

} // namespace io::detail
