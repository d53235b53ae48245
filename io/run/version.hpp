// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Which program this is: its version, the commit it was built from, the libraries it runs with.
#include <string>
#include <utility>
#include <vector>

namespace io {

/// The commit, with "+" if the sources had changes; "unknown" outside a git checkout.
[[nodiscard]] std::string git_commit();

/// (name, version) of the compiler and of every library, as built.
[[nodiscard]] std::vector<std::pair<std::string, std::string>> library_versions();

/// What `isago --version` prints.
[[nodiscard]] std::string version_text();

} // namespace io
