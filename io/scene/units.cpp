// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/units.hpp"

#include "core/base/error.hpp"
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <fmt/format.h>
#include <map>
#include <udunits2.h>

namespace io {

namespace {

struct FreeUnit {
    void operator()(ut_unit* unit) const { ut_free(unit); }
};
using Unit = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeConverter {
    void operator()(cv_converter* converter) const { cv_free(converter); }
};
using Converter = std::unique_ptr<cv_converter, FreeConverter>;

[[nodiscard]] std::string_view trim(std::string_view text)
{
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// Examples in the units a laboratory uses.
[[nodiscard]] std::string example_of(const std::string& unit)
{
    static const std::map<std::string, std::string> examples{{"m", "2 mm"},           {"s", "0.5 s"},        {"m/s", "1.5 m/s"},
                                                             {"kg/m3", "1000 kg/m3"}, {"m2/s", "1e-6 m2/s"}, {"Pa/m", "33.3 kPa/m"},
                                                             {"N/m", "5 kN/m"},       {"m/s2", "9.81 m/s2"}, {"Hz", "5 Hz"},
                                                             {"Pa", "10 MPa"},        {"rad", "30 degrees"}};
    const auto found = examples.find(unit);
    return found == examples.end() ? "" : fmt::format(", for example '{}'", found->second);
}

/// number * 10^power, rounded once: the decimal text with its exponent moved.
[[nodiscard]] double shifted(const std::string& number, int power)
{
    const auto e = number.find_first_of("eE");
    int exponent = 0;
    if (e != std::string::npos) {
        const char* begin = number.data() + e + 1;
        if (*begin == '+') ++begin;
        std::from_chars(begin, number.data() + number.size(), exponent);
    }
    return parse_number(number.substr(0, e) + "e" + std::to_string(exponent + power)).value_or(0.0);
}

[[nodiscard]] double convert(const std::string& number, cv_converter* converter)
{
    const double factor = cv_convert_double(converter, 1.0);
    const double power = std::round(std::log10(factor));
    // 1e-12: far above the round-off of a chain of unit definitions, far below any factor that is not a power of ten
    if (std::abs(factor / std::pow(10.0, power) - 1.0) < 1e-12) return shifted(number, static_cast<int>(power));
    return cv_convert_double(converter, parse_number(number).value_or(0.0));
}

} // namespace

struct Units::System {
    ut_system* system = nullptr;

    [[nodiscard]] Unit parse(const std::string& text) const { return Unit(ut_parse(system, text.c_str(), UT_UTF8)); }
    ~System()
    {
        if (system != nullptr) ut_free_system(system);
    }
};

std::optional<double> parse_number(std::string_view text)
{
    if (!text.empty() && text.front() == '+') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return {};
    return value;
}

std::string number_text(double value)
{
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

QuantityText split_quantity(std::string_view text)
{
    text = trim(text);
    const std::string_view digits = !text.empty() && text.front() == '+' ? text.substr(1) : text;
    double value = 0.0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || !std::isfinite(value)) return {"", std::string(text)};
    const auto length = static_cast<std::size_t>(end - digits.data());
    return {std::string(digits.substr(0, length)), std::string(trim(digits.substr(length)))};
}

Units::Units() : system_(std::make_unique<System>())
{
    ut_set_error_message_handler(ut_ignore);
    system_->system = ut_read_xml(nullptr);
    core::require<core::FileError>(system_->system != nullptr,
                                   "the database of units cannot be read; install udunits2 (libudunits2-data), or set "
                                   "UDUNITS2_XML_PATH to its udunits2.xml");
}

Units::~Units() = default;

QuantityResult Units::read(std::string_view text, const std::string& unit) const
{
    const auto [number, written] = split_quantity(text);
    const bool pure = unit == "1";
    const std::string needed = pure ? "a plain number" : "a number with a unit of " + unit;
    const std::string hint = fmt::format("write {}{}", needed, example_of(unit));
    if (number.empty()) return {0.0, fmt::format("'{}' is not a number", text), hint};
    if (written.empty() && !pure) return {0.0, fmt::format("'{}' has no unit", text), hint};
    if (written.empty()) return {shifted(number, 0), "", ""};

    const bool starts_like_unit = std::isdigit(static_cast<unsigned char>(written.front())) == 0 || written.starts_with("1/");
    const Unit from = starts_like_unit ? system_->parse(written) : nullptr;
    if (from == nullptr) return {0.0, fmt::format("'{}' is not a unit", written), hint};
    const Unit to = system_->parse(unit);
    if (ut_are_convertible(from.get(), to.get()) == 0) return {0.0, fmt::format("'{}' has the wrong dimension", written), hint};
    const Converter converter(ut_get_converter(from.get(), to.get()));
    if (converter == nullptr || cv_convert_double(converter.get(), 0.0) != 0.0)
        return {0.0, fmt::format("'{}' has an offset and cannot be used here", written), hint};
    return {convert(number, converter.get()), "", ""};
}

} // namespace io
