// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/scene_writer.hpp"

#include "io/scene/scene_description.hpp"

namespace io {

namespace {

/// Writes what is present, two blanks deeper for each group.
class Writer final : public Schema {
public:
    explicit Writer(std::string& text, std::string indent = "") : text_(text), indent_(std::move(indent)) {}

    void exactly_one(const std::vector<std::string>&) override {}

private:
    void on_value(const Leaf& leaf) override
    {
        const std::string written = leaf.value.write();
        if (!written.empty()) text_ += indent_ + leaf.key + ": " + written + "\n";
    }

    void on_group(const Group& group) override
    {
        if (!group.present) return;
        text_ += indent_ + (group.name != nullptr ? yaml_text(*group.name) : group.key) + ":\n";
        Writer inner(text_, indent_ + "  ");
        group.inside(inner);
    }

    void on_list(const List& list) override
    {
        if (list.size == 0) return;
        text_ += indent_ + list.key + ":\n";
        for (std::size_t n = 0; n < list.size; ++n) {
            const std::size_t begin = text_.size();
            Writer inner(text_, indent_ + "    ");
            list.item(inner, n);
            text_[begin + indent_.size() + 2] = '-';
        }
    }

    std::string& text_;
    std::string indent_;
};

} // namespace

std::string scene_text(const Scene& scene)
{
    std::string text;
    Writer writer(text);
    Scene copy = scene; // a description binds to places that a reader may write
    describe(writer, copy);
    return text;
}

} // namespace io
