// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/yaml.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <map>
#include <sstream>
#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

namespace io {

namespace {

constexpr int most_nodes = 100'000; // aliases of aliases grow without bound; no scene comes near this

/// yaml-cpp counts from 0 and in bytes; we count from 1 and in characters.
[[nodiscard]] Mark mark_of(const Source& source, const YAML::Mark& mark)
{
    if (mark.is_null()) return {&source, 1, 1};
    std::size_t begin = 0;
    for (int line = 0; line < mark.line && begin < source.text.size(); ++line)
        begin = std::min(source.text.find('\n', begin), source.text.size() - 1) + 1;
    int column = 1;
    const std::size_t end = std::min(begin + static_cast<std::size_t>(mark.column), source.text.size());
    for (std::size_t n = begin; n < end; ++n)
        if ((static_cast<unsigned char>(source.text[n]) & 0xC0) != 0x80) ++column;
    return {&source, mark.line + 1, column};
}

[[nodiscard]] int count(const Node& node)
{
    int n = 1;
    for (const auto& item : node.items) n += count(item);
    for (const auto& member : node.members) n += count(member.value);
    return n;
}

/// Builds the tree from the events of the parser; the open lists and maps are a stack.
class TreeBuilder final : public YAML::EventHandler {
public:
    TreeBuilder(const Source& source, Problems& problems) : source_(source), problems_(problems) {}

    void OnDocumentStart(const YAML::Mark&) override {}
    void OnDocumentEnd() override {}
    void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { finish(make(Node::Kind::null, mark), anchor); }
    void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t anchor, const std::string& value) override
    {
        Node node = make(Node::Kind::scalar, mark);
        node.text = value;
        node.quoted = tag == "!";
        finish(std::move(node), anchor);
    }
    void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, YAML::EmitterStyle::value) override
    {
        open_.push_back({make(Node::Kind::list, mark), anchor, {}, {}, false});
    }
    void OnSequenceEnd() override { close(); }
    void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor, YAML::EmitterStyle::value) override
    {
        open_.push_back({make(Node::Kind::map, mark), anchor, {}, {}, false});
    }
    void OnMapEnd() override { close(); }
    void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override
    {
        const auto found = anchors_.find(anchor);
        if (found == anchors_.end()) {
            problems_.add(mark_of(source_, mark), "this alias refers to itself");
            return finish(make(Node::Kind::null, mark), 0);
        }
        nodes_ += count(found->second);
        if (nodes_ > most_nodes) throw YAML::ParserException(mark, "aliases expand to too many values");
        finish(found->second, 0);
    }

    [[nodiscard]] Node take() { return std::move(root_); }

private:
    struct Open {
        Node node;
        YAML::anchor_t anchor;
        std::string key;
        Mark key_mark;
        bool has_key;
    };

    [[nodiscard]] Node make(Node::Kind kind, const YAML::Mark& mark) const
    {
        Node node;
        node.kind = kind;
        node.mark = mark_of(source_, mark);
        return node;
    }

    void close()
    {
        Open done = std::move(open_.back());
        open_.pop_back();
        finish(std::move(done.node), done.anchor);
    }

    void finish(Node node, YAML::anchor_t anchor)
    {
        ++nodes_;
        if (anchor != 0) anchors_[anchor] = node;
        if (open_.empty()) {
            root_ = std::move(node);
        } else if (Open& parent = open_.back(); parent.node.kind == Node::Kind::list) {
            parent.node.items.push_back(std::move(node));
        } else if (!parent.has_key) {
            take_key(parent, node);
        } else {
            parent.has_key = false;
            add_member(parent, std::move(node));
        }
    }

    void take_key(Open& parent, const Node& node)
    {
        if (node.kind != Node::Kind::scalar) problems_.add(node.mark, "a key must be a word");
        parent.key = node.text;
        parent.key_mark = node.mark;
        parent.has_key = true;
    }

    void add_member(Open& parent, Node value)
    {
        if (parent.key == "<<") return merge(parent.node, value);
        auto same = [&](const Member& m) { return m.key == parent.key; };
        auto& members = parent.node.members;
        const auto first = std::find_if(members.begin(), members.end(), same);
        if (first == members.end()) return members.push_back({parent.key, parent.key_mark, std::move(value)});
        if (!first->merged)
            return problems_.add(parent.key_mark, fmt::format("'{}' is given twice", parent.key),
                                 fmt::format("the first one is on line {}", first->mark.line));
        *first = {parent.key, parent.key_mark, std::move(value)};
    }

    void merge(Node& map, const Node& value)
    {
        if (value.kind == Node::Kind::list) {
            for (const auto& item : value.items) merge(map, item);
            return;
        }
        if (value.kind != Node::Kind::map) return problems_.add(value.mark, "'<<' merges a map, and this is not one");
        for (const auto& member : value.members)
            if (map.find(member.key) == nullptr) map.members.push_back({member.key, member.mark, member.value, true});
    }

    const Source& source_;
    Problems& problems_;
    std::vector<Open> open_;
    std::map<YAML::anchor_t, Node> anchors_;
    Node root_;
    int nodes_ = 0;
};

} // namespace

Node* Node::find(const std::string& key)
{
    const auto found = std::find_if(members.begin(), members.end(), [&](const Member& m) { return m.key == key; });
    return found == members.end() ? nullptr : &found->value;
}

std::string name_of(Node::Kind kind)
{
    switch (kind) {
    case Node::Kind::null: return "nothing";
    case Node::Kind::scalar: return "a single value";
    case Node::Kind::list: return "a list";
    case Node::Kind::map: return "a group of keys";
    }
    return "";
}

std::optional<Node> parse_yaml(const Source& source, Problems& problems, std::size_t from)
{
    TreeBuilder builder(source, problems);
    std::istringstream stream(std::string(from, ' ') + source.text.substr(from));
    try {
        YAML::Parser parser(stream);
        parser.HandleNextDocument(builder);
        if (parser) {
            TreeBuilder second(source, problems);
            if (parser.HandleNextDocument(second))
                problems.add(second.take().mark, "a second document begins here; a scene is one document");
        }
    } catch (const YAML::Exception& error) {
        problems.add(mark_of(source, error.mark), "YAML: " + error.msg);
        return {};
    }
    return builder.take();
}

} // namespace io
