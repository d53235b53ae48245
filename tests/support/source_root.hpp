// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Where this checkout lies: tests read the scenes in its configs.
#include <filesystem>

namespace test {

[[nodiscard]] std::filesystem::path source_root();

} // namespace test
