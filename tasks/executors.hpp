// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// How each executor is made; only executor.cpp and the executors include this.
#include "tasks/executor.hpp"

namespace tasks {

[[nodiscard]] std::unique_ptr<Executor> make_serial_executor(const Plan& plan, Trace* trace);
[[nodiscard]] std::unique_ptr<Executor> make_shuffle_executor(const Plan& plan, Trace* trace, std::uint64_t seed);
[[nodiscard]] std::unique_ptr<Executor> make_openmp_executor(const Plan& plan, Trace* trace, int threads);
[[nodiscard]] std::unique_ptr<Executor> make_tbb_executor(const Plan& plan, Trace* trace, int threads);

} // namespace tasks
