// Trusted code as a JSON array of digests.
#include "app/trusted_code.h"

#include "app/digest.h"
#include "app/state_file.h"
#include "graph/own_type_edits.h"

#include <algorithm>

namespace fieldwright::app {
namespace {

bool is_digest(const std::string& text)
{
    return text.size() == 64 && text.find_first_not_of("0123456789abcdef") == std::string::npos;
}

}  // namespace

std::string nameless(const graph::OwnType& type) { return graph::renamed(type, "own").text; }

TrustedCode::TrustedCode(std::filesystem::path file) : file_(std::move(file)) { read(); }

void TrustedCode::read()
{
    StateJson json = read_state(file_);
    if (!json.is_array()) return;
    std::vector<std::string> digests;
    for (const StateJson& entry : json)
        if (entry.is_string() && is_digest(entry.get<std::string>())) digests.push_back(entry.get<std::string>());
    // What only this window knows stays known.
    for (std::string& known : digests_)
        if (std::find(digests.begin(), digests.end(), known) == digests.end()) digests.push_back(std::move(known));
    digests_ = std::move(digests);
}

bool TrustedCode::trusts(const graph::OwnType& type) const
{
    return std::find(digests_.begin(), digests_.end(), sha256(nameless(type))) != digests_.end();
}

void TrustedCode::trust(const std::vector<graph::OwnType>& types)
{
    read();
    for (const graph::OwnType& type : types) {
        std::string digest = sha256(nameless(type));
        std::erase(digests_, digest);
        digests_.push_back(std::move(digest));
    }
    if (digests_.size() > limit) digests_.erase(digests_.begin(), digests_.end() - static_cast<std::ptrdiff_t>(limit));
    write_state(file_, StateJson(digests_));
}

}  // namespace fieldwright::app
