// SPDX-FileCopyrightText: 2026 The Isago authors
// SPDX-License-Identifier: Apache-2.0
#include "io/scene/schema_reader.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <iterator>

namespace io {

namespace {

const Node nothing{};

[[nodiscard]] std::string quoted_list(const std::vector<std::string>& keys)
{
    std::string all;
    for (const auto& key : keys) all += (all.empty() ? "'" : " or '") + key + "'";
    return all;
}

} // namespace

Mark Locations::at(std::string path) const
{
    while (!path.empty()) {
        if (const auto found = marks_.find(path); found != marks_.end()) return found->second;
        const auto dot = path.rfind('.');
        path = dot == std::string::npos ? "" : path.substr(0, dot);
    }
    const auto whole = marks_.find("");
    return whole == marks_.end() ? Mark{} : whole->second;
}

bool Locations::good(const std::string& path) const
{
    return std::none_of(spoiled_.begin(), spoiled_.end(),
                        [&](const std::string& bad) { return bad == path || path.starts_with(bad + ".") || bad.starts_with(path + "."); });
}

SchemaReader::SchemaReader(const Node& map, std::string path, Mark here, const Reading& reading, Locations& locations)
    : map_(map.kind == Node::Kind::map ? map : nothing), path_(std::move(path)), here_(here), reading_(reading), locations_(locations)
{
    if (map.kind == Node::Kind::map || map.kind == Node::Kind::null) return;
    reading_.problems.add(map.mark, fmt::format("a group of keys is needed here, not {}", name_of(map.kind)));
}

const Member* SchemaReader::take(const std::string& key)
{
    known_.push_back(key);
    for (const Member& member : map_.members)
        if (member.key == key) {
            used_.insert(key);
            return &member;
        }
    return nullptr;
}

std::vector<const Member*> SchemaReader::unused() const
{
    std::vector<const Member*> all;
    for (const Member& member : map_.members)
        if (!used_.contains(member.key)) all.push_back(&member);
    return all;
}

const Member* SchemaReader::take_named(const Group& group)
{
    auto candidates = unused();
    std::erase_if(candidates, [&](const Member* m) { return !nearest(m->key, known_).empty(); });
    if (candidates.empty()) return nullptr;
    for (const Member* member : candidates) used_.insert(member->key);
    for (std::size_t n = 1; n < candidates.size(); ++n) {
        reading_.problems.add(candidates[n]->mark, fmt::format("'{}' would be a second {}; one is possible", candidates[n]->key, group.key),
                              "beside it stand: " + quoted_list(known_));
        locations_.spoil(path_ + candidates[n]->key);
    }
    return candidates.front();
}

void SchemaReader::miss(const std::string& key, const std::string& meaning)
{
    missing_.emplace_back(key, meaning);
    locations_.spoil(path_ + key);
}

void SchemaReader::on_value(const Leaf& leaf)
{
    const Member* member = take(leaf.key);
    if (member == nullptr) {
        if (leaf.need == Need::required) miss(leaf.key, leaf.meaning + ": " + form_of(leaf.value));
        return;
    }
    locations_.place(path_ + leaf.key, member->value.kind == Node::Kind::null ? member->mark : member->value.mark);
    const std::size_t before = reading_.problems.size();
    if (member->value.kind == Node::Kind::null)
        reading_.problems.add(member->mark, fmt::format("'{}' has no value", leaf.key), "write " + form_of(leaf.value));
    else leaf.value.read(member->value, reading_);
    if (reading_.problems.size() != before) locations_.spoil(path_ + leaf.key);
}

void SchemaReader::read_group(const Node& node, const std::string& path, Mark key, const std::function<void(Schema&)>& inside)
{
    locations_.place(path, key);
    if (node.kind != Node::Kind::map && node.kind != Node::Kind::null) locations_.spoil(path);
    SchemaReader reader(node, path + ".", key, reading_, locations_);
    inside(reader);
    if (node.kind == Node::Kind::map || node.kind == Node::Kind::null) reader.finish();
}

void SchemaReader::on_group(const Group& group)
{
    const Member* member = group.name == nullptr ? take(group.key) : take_named(group);
    if (member == nullptr) {
        if (group.need == Need::required) miss(group.key, group.meaning);
        return;
    }
    if (group.name != nullptr) *group.name = member->key;
    if (group.make) group.make();
    // A group that the user names keeps the path of its stand-in, so that checks can find it.
    read_group(member->value, path_ + group.key, member->mark, group.inside);
}

void SchemaReader::on_list(const List& list)
{
    const Member* member = take(list.key);
    if (member == nullptr) return;
    const std::string path = path_ + list.key;
    locations_.place(path, member->mark);
    if (member->value.kind != Node::Kind::list || member->value.items.empty()) {
        locations_.spoil(path);
        return reading_.problems.add(member->mark, fmt::format("'{}' must be a list of groups of keys", list.key),
                                     "write each item on a line that begins with '-'");
    }
    const auto& items = member->value.items;
    list.resize(items.size());
    for (std::size_t n = 0; n < items.size(); ++n)
        read_group(items[n], fmt::format("{}.{}", path, n), items[n].mark, [&](Schema& schema) { list.item(schema, n); });
}

void SchemaReader::exactly_one(const std::vector<std::string>& keys)
{
    std::vector<const Member*> given;
    for (const Member& member : map_.members)
        if (std::find(keys.begin(), keys.end(), member.key) != keys.end()) given.push_back(&member);
    if (given.empty()) return miss(keys.front(), "one of " + quoted_list(keys));
    for (std::size_t n = 1; n < given.size(); ++n) {
        reading_.problems.add(given[n]->mark, fmt::format("'{}' excludes '{}'", given.front()->key, given[n]->key), "keep one of the two");
        locations_.spoil(path_ + given[n]->key);
    }
}

void SchemaReader::finish()
{
    std::vector<std::string> misspelled;
    for (const Member* member : unused()) {
        std::vector<std::string> free;
        std::copy_if(known_.begin(), known_.end(), std::back_inserter(free), [&](const std::string& key) { return !used_.contains(key); });
        const std::string meant = nearest(member->key, known_);
        reading_.problems.add(member->mark, fmt::format("unknown key '{}'", member->key),
                              suggestion(member->key, meant.empty() ? free : known_));
        misspelled.push_back(meant);
    }
    for (const auto& [key, meaning] : missing_)
        if (std::find(misspelled.begin(), misspelled.end(), key) == misspelled.end())
            reading_.problems.add(here_, fmt::format("'{}' is missing", key), meaning);
}

} // namespace io
