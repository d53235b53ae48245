// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
// Keeps this floor a library until its first source arrives.
