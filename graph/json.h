// JSON read strictly and within limits into a flat tree whose values know where they stand in the text.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace fieldwright::graph {

inline constexpr std::size_t json_text_limit = 16u << 20;    // bytes
inline constexpr std::size_t json_string_limit = 64u << 10;  // bytes, unescaped
inline constexpr std::size_t json_value_limit = 1'000'000;
inline constexpr std::size_t json_depth_limit = 32;

enum class JsonKind : std::uint8_t { null, boolean, number, string, array, object };

// One value of a JsonTree. The views point into the text or the tree.
struct JsonValue {
    JsonKind kind = JsonKind::null;
    bool truth = false;                // of a boolean
    std::uint32_t begin = 0, end = 0;  // its bytes in the text
    std::uint32_t key_begin = 0;       // of a member: where its key begins; else `begin`
    std::int32_t parent = -1, first = -1, next = -1;
    std::uint32_t count = 0;  // of an array or object: its values
    std::string_view key;     // of a member, unescaped
    std::string_view string;  // of a string, unescaped
};

// Throws Failure{3, "NAME:line:column: path: what, what to do"} for everything it refuses: bad syntax and UTF-8, values
// beyond the limits, duplicate keys, numbers that are not finite, data after the end.
class JsonTree {
public:
    // `text` must outlive the tree; `name` is the file's, for messages. A leading byte order mark is skipped.
    JsonTree(std::string_view text, std::string_view name);

    const JsonValue& root() const { return values_.front(); }
    const JsonValue* first_child(const JsonValue& value) const { return at(value.first); }
    const JsonValue* next_sibling(const JsonValue& value) const { return at(value.next); }
    const JsonValue* member(const JsonValue& object, std::string_view key) const;  // null when absent
    std::string_view source(const JsonValue& value) const { return text_.substr(value.begin, value.end - value.begin); }
    std::string path(const JsonValue& value) const;  // $.graphs.root.nodes.3.position[1]

    // The value as what it must be, or a failure that says so.
    bool boolean(const JsonValue& value) const;
    float number(const JsonValue& value) const;          // finite
    std::int64_t integer(const JsonValue& value) const;  // at most 2^53 in size
    std::string_view string(const JsonValue& value) const;
    const JsonValue& object(const JsonValue& value) const;
    const JsonValue& array(const JsonValue& value) const;

    [[noreturn]] void fail(const JsonValue& value, const std::string& sentence) const;
    [[noreturn]] void fail_at_key(const JsonValue& value, const std::string& sentence) const;

private:
    friend class JsonBuilder;
    const JsonValue* at(std::int32_t index) const
    {
        return index < 0 ? nullptr : &values_[static_cast<std::size_t>(index)];
    }
    [[noreturn]] void fail_at(std::size_t offset, const std::string& sentence) const;

    std::string_view text_;
    std::string name_;
    std::vector<JsonValue> values_;
    std::deque<std::string> unescaped_;  // strings whose value is not a slice of the text
};

void append_json_string(std::string& out, std::string_view text);
// Shortest text that reads back as the same float; with `point`, whole numbers end in `.0`.
void append_json_number(std::string& out, float number, bool point = true);

bool is_utf8(std::string_view text);
// For messages: `text` in backquotes, on one line and not longer than a name.
std::string in_quotes(std::string_view text);

}  // namespace fieldwright::graph
