// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// A run on one page: what it was, its curves, its pictures.
#include "io/run/run_directory.hpp"

namespace io {

/// A page that needs nothing beside it: scene, versions, the columns of metrics.csv as curves, at most twelve frames,
/// how fluid and particles were coupled.
/// Parts that the run does not have are left out. @throws core::ConfigError if the folder has no run.
[[nodiscard]] std::string report_html(const RunDirectory& run);

} // namespace io
