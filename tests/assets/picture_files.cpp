// Through OpenImageIO, in a temporary folder; the bomb by hand.
#include "tests/assets/picture_files.h"

#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>
#include <unistd.h>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <vector>

namespace fieldwright::tests {
namespace {

std::string big_endian(std::uint32_t value)
{
    std::string text;
    for (int shift = 24; shift >= 0; shift -= 8) text += static_cast<char>(value >> shift & 255);
    return text;
}

std::uint32_t crc(const std::string& bytes)
{
    std::uint32_t sum = 0xffffffffu;
    for (unsigned char byte : bytes) {
        sum ^= byte;
        for (int i = 0; i < 8; ++i) sum = sum >> 1 ^ (sum & 1 ? 0xedb88320u : 0);
    }
    return ~sum;
}

std::string chunk(const std::string& name, const std::string& data)
{
    return big_endian(static_cast<std::uint32_t>(data.size())) + name + data + big_endian(crc(name + data));
}

}  // namespace

std::string encoded_picture(const std::string& format, int width, int height, int channels, const Painter& painter)
{
    auto path = std::filesystem::temp_directory_path() / ("fieldwright-picture-" + std::to_string(::getpid()));
    auto output = OIIO::ImageOutput::create(format);
    bool is_float = format == "hdr" || format == "openexr";
    OIIO::ImageSpec spec(width, height, channels, is_float ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:UnassociatedAlpha", 1);
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            float rgba[4] = {0, 0, 0, 1};
            painter(x, y, rgba);
            pixels.insert(pixels.end(), rgba, rgba + channels);
        }
    bool written = output && output->open(path.string(), spec) &&
                   output->write_image(OIIO::TypeDesc::FLOAT, pixels.data()) && output->close();
    EXPECT_TRUE(written) << format << ": " << (output ? output->geterror() : OIIO::geterror());
    std::ifstream file(path, std::ios::binary);
    std::string bytes{std::istreambuf_iterator<char>(file), {}};
    std::filesystem::remove(path);
    return bytes;
}

std::string png_bomb(unsigned width, unsigned height)
{
    const std::string empty_deflate("\x78\x9c\x03\x00\x00\x00\x00\x01", 8);
    return "\x89PNG\r\n\x1a\n" +
           chunk("IHDR", big_endian(width) + big_endian(height) + std::string("\x01\x00\x00\x00\x00", 5)) +
           chunk("IDAT", empty_deflate) + chunk("IEND", "");
}

}  // namespace fieldwright::tests
