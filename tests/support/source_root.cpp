// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "tests/support/source_root.hpp"

// CMake gives ISAGO_SOURCE_ROOT to this file alone.
std::filesystem::path test::source_root() { return ISAGO_SOURCE_ROOT; }
