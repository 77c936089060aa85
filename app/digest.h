// SHA-256 (FIPS 180-4), to tell texts apart that somebody may have made to look alike.
#pragma once

#include <string>
#include <string_view>

namespace fieldwright::app {

std::string sha256(std::string_view bytes);  // 64 letters of 0-9 and a-f

}  // namespace fieldwright::app
