// The sRGB encoding of the shading library as a table, and back: the same bytes without a power per channel.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace fieldwright::renderer {

class SrgbTable {
public:
    static const SrgbTable& shared();  // made on first use, never changed

    // floor(255 srgb_encode(x) + 0.5)
    unsigned char byte(float x) const
    {
        float inside = x > smallest ? (x < 1.0f ? x : 1.0f) : smallest;
        unsigned char low = starts_[(std::bit_cast<std::uint32_t>(inside) - first_bits) >> dropped_bits];
        return static_cast<unsigned char>(low + (inside >= thresholds_[low] ? 1 : 0));
    }
    float linear(unsigned char byte) const { return linear_[byte]; }  // srgb_decode(byte / 255)

private:
    SrgbTable();

    // 128 buckets to each power of two hold at most one threshold each. All below `smallest` is 0.
    static constexpr float smallest = 0x1p-13f;
    static constexpr std::uint32_t first_bits = std::bit_cast<std::uint32_t>(smallest);
    static constexpr int dropped_bits = 16;
    static constexpr std::size_t buckets = 13 * 128 + 1;

    std::array<float, 256> thresholds_;  // by byte: the least x that is encoded as the next one
    std::array<unsigned char, buckets> starts_;
    std::array<float, 256> linear_;
};

}  // namespace fieldwright::renderer
