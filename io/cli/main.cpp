// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "core/comm/communicator.hpp"

int main(int argc, char** argv)
{
    const core::MpiSession session(argc, argv);
}
