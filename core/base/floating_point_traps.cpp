// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/base/floating_point_traps.hpp"

#include <cfenv>

void core::trap_floating_point_errors()
{
#ifdef ISAGO_TRAP_FPE
    feenableexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
#endif
}
