// What a worker writes to its standard output, once: a mark, how the job ended, a length, and that many bytes.
#pragma once

#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>

namespace fieldwright::assets {

struct WorkerMessage {
    bool refused = false;  // `bytes` is the reason
    std::string bytes;
};

inline constexpr std::string_view message_mark = "fwwork1";
inline constexpr std::size_t message_header = message_mark.size() + 1 + sizeof(std::uint64_t);

// Exit code of a worker that asked for more memory than it may have.
inline constexpr int out_of_memory_code = 97;

inline std::string header_of(const WorkerMessage& message)
{
    std::uint64_t length = message.bytes.size();
    std::string header(message_mark);
    header += message.refused ? '!' : '.';
    header.append(reinterpret_cast<const char*>(&length), sizeof length);
    return header;
}

// Nothing unless the text is exactly one message.
inline std::optional<WorkerMessage> message_from(std::string&& text)
{
    if (text.size() < message_header || !text.starts_with(message_mark)) return std::nullopt;
    char kind = text[message_mark.size()];
    std::uint64_t length = 0;
    std::memcpy(&length, text.data() + message_mark.size() + 1, sizeof length);
    if ((kind != '!' && kind != '.') || length != text.size() - message_header) return std::nullopt;
    text.erase(0, message_header);
    return WorkerMessage{kind == '!', std::move(text)};
}

}  // namespace fieldwright::assets
