// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_writer.hpp"

#include "io/scene/scene_description.hpp"
#include <nlohmann/json.hpp>

namespace io {

namespace {

using Json = nlohmann::ordered_json;
using Shape = Value::Shape;

[[nodiscard]] Json number(const char* type, const Range& range)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Json json{{"type", type}};
    if (range.low > -infinity) json[range.low_open ? "exclusiveMinimum" : "minimum"] = range.low;
    if (range.high < infinity) json["maximum"] = range.high;
    return json;
}

[[nodiscard]] Json pattern(const std::string& expression) { return {{"type", "string"}, {"pattern", expression}}; }

const std::string decimal = R"([-+]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][-+]?[0-9]+)?)";

[[nodiscard]] Json one_value(const Value& value)
{
    switch (value.shape) {
    case Shape::text: return {{"type", Json::array({"string", "number", "boolean"})}};
    case Shape::integer: return number("integer", value.range);
    case Shape::number: return {{"anyOf", {number("number", value.range), pattern("^" + decimal + " *%?$")}}};
    case Shape::quantity:
    case Shape::width: return pattern("^" + decimal + " *[^0-9 ].*$");
    case Shape::choice: return {{"enum", value.words}};
    case Shape::interval: return pattern("^(never|every " + decimal + " *[^0-9 ].*)$");
    case Shape::points: {
        const Json item{{"type", Json::array({"string", "number"})}};
        const Json point{{"type", "array"}, {"items", item}, {"minItems", 2}, {"maxItems", 2}};
        return {{"type", "array"}, {"items", point}, {"minItems", 2}};
    }
    case Shape::direction: {
        const Json vector{{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 3}, {"maxItems", 3}};
        return {{"anyOf", {pattern("^[-+]?[xyz]$"), vector}}};
    }
    }
    return {};
}

[[nodiscard]] Json schema_of(const Leaf& leaf)
{
    Json json = one_value(leaf.value);
    if (leaf.value.length != 0) json = {{"type", "array"}, {"items", json}};
    if (leaf.value.length > 0) json["minItems"] = json["maxItems"] = leaf.value.length;
    json["description"] = leaf.meaning + ": " + form_of(leaf.value);
    const std::string written = leaf.need == Need::required ? "" : leaf.value.write();
    if (!written.empty()) json["description"] = json["description"].get<std::string>() + "; default " + written;
    return json;
}

/// Gathers the properties of one group.
class JsonBuilder final : public Schema {
public:
    void exactly_one(const std::vector<std::string>& keys) override
    {
        Json choice = Json::array();
        for (const auto& key : keys) choice.push_back({{"required", Json::array({key})}});
        choices_.push_back({{"oneOf", choice}});
    }

    [[nodiscard]] Json finish(const std::string& meaning) const
    {
        Json json{{"type", "object"}, {"description", meaning}, {"properties", properties_}};
        json["additionalProperties"] = named_;
        if (!required_.empty()) json["required"] = required_;
        if (!choices_.empty()) json["allOf"] = choices_;
        if (named_.is_object()) json["minProperties"] = 1;
        return json;
    }

private:
    void on_value(const Leaf& leaf) override
    {
        properties_[leaf.key] = schema_of(leaf);
        if (leaf.need == Need::required) required_.push_back(leaf.key);
    }

    void on_group(const Group& group) override
    {
        JsonBuilder inner;
        group.example(inner);
        const Json json = inner.finish(group.meaning);
        if (group.name != nullptr) {
            named_ = json;
            return;
        }
        properties_[group.key] = json;
        if (group.need == Need::required) required_.push_back(group.key);
    }

    void on_list(const List& list) override
    {
        JsonBuilder inner;
        list.example(inner);
        properties_[list.key] = {{"type", "array"}, {"description", list.meaning}, {"minItems", 1}, {"items", inner.finish(list.meaning)}};
    }

    Json properties_ = Json::object();
    Json required_ = Json::array(), choices_ = Json::array();
    Json named_ = false;
};

} // namespace

std::string json_schema()
{
    JsonBuilder builder;
    Scene scene;
    describe(builder, scene);
    Json json{{"$schema", "http://json-schema.org/draft-07/schema#"}, {"title", "Isago scene"}};
    json.update(builder.finish("A scene of Isago"));
    return json.dump(2) + "\n";
}

} // namespace io
