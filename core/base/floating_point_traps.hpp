// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Stops the program where the first not-a-number is born, in builds with ISAGO_TRAP_FPE (preset audit).

namespace core {

/// From now on an invalid operation, a division by zero or an overflow raises SIGFPE in this thread and in those it
/// starts. Does nothing in builds without ISAGO_TRAP_FPE.
void trap_floating_point_errors();

} // namespace core
