// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#pragma once
// Quantities with units, as users write them: "2 mm", "33.3 kPa/m". SI inside.
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace io {

/// The number and the unit of "33.3 kPa/m"; `number` is empty when the text does not begin with a number.
struct QuantityText {
    std::string number;
    std::string unit;
};
[[nodiscard]] QuantityText split_quantity(std::string_view text);

/// A whole text as a finite number, or nothing.
[[nodiscard]] std::optional<double> parse_number(std::string_view text);

/// The shortest decimal text that reads back as the same number.
[[nodiscard]] std::string number_text(double value);

/// What came of reading a quantity: a value in the unit asked for, or an error with advice.
struct QuantityResult {
    double value = 0.0;
    std::string error, hint;
};

/// The unit database (udunits2). Not for use by several threads at once.
class Units {
public:
    /// @throws core::FileError if the database of units cannot be read.
    Units();
    ~Units();
    Units(const Units&) = delete;
    Units& operator=(const Units&) = delete;

    /// Reads `text` as a quantity and converts it to `unit` ("1" for pure numbers). A number whose unit is missing,
    /// unknown or of another dimension is an error that says which unit is needed. Powers of ten are exact: "4.5 ms"
    /// is the double nearest to 0.0045 s.
    [[nodiscard]] QuantityResult read(std::string_view text, const std::string& unit) const;

private:
    struct System;
    std::unique_ptr<System> system_;
};

} // namespace io
