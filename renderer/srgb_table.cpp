// Finds where the encoding of the shading library goes from one byte to the next.
#include "renderer/srgb_table.h"

#include "renderer/rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace fieldwright::renderer {
namespace {

// Bisects the bits of all thresholds at once: positive floats are ordered like their bits.
std::array<float, 256> thresholds()
{
    const RowFunction encode("srgb_encode_channel", field::kernels());
    std::array<std::uint32_t, 255> low{}, high;
    high.fill(std::bit_cast<std::uint32_t>(1.0f));
    Rows x(1), encoded(1);
    for (int step = 0; step < 31; ++step) {
        for (std::size_t i = 0; i < low.size(); ++i) x.lane(0)[i] = std::bit_cast<float>((low[i] + high[i]) / 2);
        encode(encoded, static_cast<int>(low.size()), x);
        for (std::size_t i = 0; i < low.size(); ++i) {
            bool reached = std::floor(255.0f * encoded.lane(0)[i] + 0.5f) >= static_cast<float>(i + 1);
            (reached ? high[i] : low[i]) = (low[i] + high[i]) / 2;
        }
    }
    std::array<float, 256> found;
    for (std::size_t i = 0; i < high.size(); ++i) found[i] = std::bit_cast<float>(high[i]);
    found.back() = std::numeric_limits<float>::infinity();
    return found;
}

std::array<float, 256> decoded_bytes()
{
    Rows bytes(1), decoded(1);
    for (int i = 0; i < 256; ++i) bytes.lane(0)[i] = static_cast<float>(i) / 255.0f;
    RowFunction("srgb_decode_channel", field::kernels())(decoded, 256, bytes);
    std::array<float, 256> found;
    std::copy_n(decoded.lane(0), found.size(), found.begin());
    return found;
}

}  // namespace

SrgbTable::SrgbTable() : thresholds_(thresholds()), linear_(decoded_bytes())
{
    unsigned char byte = 0;
    for (std::size_t i = 0; i < buckets; ++i) {
        auto start = std::bit_cast<float>(first_bits + (static_cast<std::uint32_t>(i) << dropped_bits));
        while (start >= thresholds_[byte]) ++byte;
        starts_[i] = byte;
    }
}

const SrgbTable& SrgbTable::shared()
{
    static const SrgbTable table;
    return table;
}

}  // namespace fieldwright::renderer
