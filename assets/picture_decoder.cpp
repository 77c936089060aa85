// The worker's side of picture files: size first, then pixels band by band, averaged down as they come.
#include "assets/picture_file.h"

#include "assets/picture_wire.h"
#include "graph/problem.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <algorithm>
#include <cmath>

namespace fieldwright::assets {
namespace {

constexpr int band_rows = 64;

[[noreturn]] void refuse(const std::string& reason) { throw graph::Failure(3, reason); }

std::string first_line(const std::string& text)
{
    std::string line = text.substr(0, text.find('\n'));
    for (char& c : line)
        if (static_cast<unsigned char>(c) < 32) c = ' ';
    while (line.ends_with('.')) line.pop_back();
    return line.size() > 160 ? line.substr(0, 160) + "..." : line;
}

[[noreturn]] void refuse_damaged(const OIIO::ImageInput& input)
{
    std::string reason = first_line(input.geterror());
    refuse(reason.empty() ? "is damaged" : "is damaged (" + reason + ")");
}

std::string size_words(const OIIO::ImageSpec& spec)
{
    return std::to_string(spec.width) + " x " + std::to_string(spec.height) + " pixels";
}

void check_size(const OIIO::ImageSpec& spec)
{
    if (spec.width <= 0 || spec.height <= 0 || spec.nchannels <= 0) refuse("is damaged (it has no pixels)");
    if (spec.width > picture_side_limit || spec.height > picture_side_limit)
        refuse("is too large (" + size_words(spec) + "; at most " + std::to_string(picture_side_limit) + " a side)");
    if (std::int64_t(spec.width) * spec.height > picture_area_limit)
        refuse("is too large (" + size_words(spec) + "; at most " + std::to_string(picture_area_limit >> 20) +
               " million)");
    if (spec.depth > 1 || spec.deep) refuse("is a volume, not a picture");
    if (spec.nchannels > 64) refuse("has too many channels");
    bool many_tiles = spec.tile_width > 0 && std::int64_t(spec.tile_height) * spec.width > picture_area_limit;
    if (many_tiles) refuse("is damaged (its tiles are larger than it)");
}

float light_from_shown(float v) { return v <= 0.04045f ? v / 12.92f : std::pow((v + 0.055f) / 1.055f, 2.4f); }
float shown_from_light(float v)
{
    v = std::clamp(v, 0.0f, 1.0f);
    return v <= 0.0031308f ? 12.92f * v : 1.055f * std::pow(v, 1 / 2.4f) - 0.055f;
}

// Reads a picture from the top in bands of whole rows, as RGBA on the wanted scale.
class BandReader {
public:
    BandReader(const std::string& bytes, PixelScale scale) : memory_(bytes.data(), bytes.size())
    {
        std::string_view format = picture_format(bytes);
        if (format.empty()) refuse("is not a PNG, JPEG, HDR, EXR or TIFF file");
        OIIO::attribute("threads", 1);
        OIIO::attribute("exr_threads", -1);
        input_ = OIIO::ImageInput::create(std::string(format));
        if (!input_) refuse("cannot be read: OpenImageIO here has no reader for " + std::string(format));
        open("picture." + std::string(format));
        check_size(spec_);
        bool file_is_shown = format == "png" || format == "jpeg" || (format == "tiff" && spec_.format.basesize() < 4);
        converts_ = file_is_shown != (scale == PixelScale::shown);
        to_light_ = scale == PixelScale::light;
        channels_ = std::min(spec_.nchannels, 4);
        alpha_ = spec_.alpha_channel >= 0 && spec_.alpha_channel < channels_ ? spec_.alpha_channel : -1;
    }

    int width() const { return spec_.width; }
    int height() const { return spec_.height; }

    // The rows from `first` on, as many as are in one band; 4 numbers a pixel.
    int read(int first, std::vector<float>& rgba)
    {
        int step = spec_.tile_height > 0 ? spec_.tile_height : band_rows;
        int last = std::min(first + step, spec_.height), y = spec_.y + first;
        auto pixels = static_cast<std::size_t>(spec_.width) * static_cast<std::size_t>(last - first);
        raw_.assign(pixels * static_cast<std::size_t>(channels_), 0.0f);
        bool good = spec_.tile_width > 0
                        ? input_->read_tiles(0, 0, spec_.x, spec_.x + spec_.width, y, spec_.y + last, spec_.z,
                                             spec_.z + 1, 0, channels_, OIIO::TypeDesc::FLOAT, raw_.data())
                        : input_->read_scanlines(0, 0, y, spec_.y + last, spec_.z, 0, channels_, OIIO::TypeDesc::FLOAT,
                                                 raw_.data());
        if (!good) refuse_damaged(*input_);
        rgba.resize(4 * pixels);
        for (std::size_t i = 0; i < pixels; ++i) pixel(&raw_[i * static_cast<std::size_t>(channels_)], &rgba[4 * i]);
        return last - first;
    }

private:
    // Colours as they are in the file: multiplied by alpha, edges of transparent drawings would darken.
    void open(const std::string& name)
    {
        OIIO::ImageSpec wishes;
        wishes.attribute("oiio:UnassociatedAlpha", 1);
        if (input_->supports("ioproxy")) {
            if (!input_->set_ioproxy(&memory_) || !input_->open(name, spec_, wishes)) refuse_damaged(*input_);
            return;
        }
        refuse("cannot be read: the reader of OpenImageIO here takes no files from memory");
    }

    float scaled(float value) const
    {
        if (!std::isfinite(value)) value = 0;
        if (!converts_) return value;
        return to_light_ ? light_from_shown(value) : shown_from_light(value);
    }

    void pixel(const float* from, float* to) const
    {
        int colours = alpha_ >= 0 ? alpha_ : channels_;
        for (int c = 0; c < 3; ++c) to[c] = scaled(from[colours >= 3 ? c : 0]);
        float alpha = alpha_ >= 0 ? from[alpha_] : 1.0f;
        to[3] = std::isfinite(alpha) ? std::clamp(alpha, 0.0f, 1.0f) : 0.0f;
    }

    OIIO::Filesystem::IOMemReader memory_;
    std::unique_ptr<OIIO::ImageInput> input_;
    OIIO::ImageSpec spec_;
    std::vector<float> raw_;
    int channels_ = 0, alpha_ = -1;
    bool converts_ = false, to_light_ = false;
};

// Averages over areas as pixels come, from the top: colours weighted by their alpha.
class Reducer {
public:
    Reducer(int from_width, int from_height, int long_side)
    {
        int longest = std::max(from_width, from_height);
        double scale = long_side > 0 && longest > long_side ? static_cast<double>(long_side) / longest : 1.0;
        width_ = std::max(1, static_cast<int>(std::lround(from_width * scale)));
        height_ = std::max(1, static_cast<int>(std::lround(from_height * scale)));
        columns_per_pixel_ = static_cast<double>(width_) / from_width;
        rows_per_pixel_ = static_cast<double>(height_) / from_height;
        sums_.resize(5 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
    }

    void add_row(int y, const float* rgba, int count)
    {
        spread(y * rows_per_pixel_, (y + 1) * rows_per_pixel_, height_, [&](int row, float share) {
            for (int x = 0; x < count; ++x)
                spread(x * columns_per_pixel_, (x + 1) * columns_per_pixel_, width_,
                       [&](int column, float part) { add(column, row, rgba + 4 * x, share * part); });
        });
    }

    Pixels pixels() const
    {
        Pixels result{width_, height_, std::vector<float>(sums_.size() / 5 * 4)};
        for (std::size_t i = 0; i < sums_.size() / 5; ++i) {
            const float* sum = &sums_[5 * i];
            float* to = &result.rgba[4 * i];
            for (int c = 0; c < 3; ++c) to[c] = sum[3] > 0 ? sum[c] / sum[3] : 0;
            to[3] = sum[4] > 0 ? sum[3] / sum[4] : 0;
        }
        return result;
    }

private:
    // The whole cells that [low, high) lies in, and how much of it lies in each.
    template <typename Visit>
    static void spread(double low, double high, int count, const Visit& visit)
    {
        for (int cell = std::min(static_cast<int>(low), count - 1); cell < count && cell < high; ++cell) {
            double share = std::min(high, cell + 1.0) - std::max(low, static_cast<double>(cell));
            if (share > 1e-9) visit(cell, static_cast<float>(share));
        }
    }

    void add(int column, int row, const float* rgba, float weight)
    {
        float* sum = &sums_[5 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
                                 static_cast<std::size_t>(column))];
        for (int c = 0; c < 3; ++c) sum[c] += weight * rgba[3] * rgba[c];
        sum[3] += weight * rgba[3];
        sum[4] += weight;
    }

    int width_ = 0, height_ = 0;
    double columns_per_pixel_ = 1, rows_per_pixel_ = 1;
    std::vector<float> sums_;  // colour times alpha, alpha, weight
};

}  // namespace

std::string decode_picture(const std::string& input)
{
    auto [question, bytes] = question_from(input);
    BandReader reader(bytes, question.scale);
    int longest = std::max(reader.width(), reader.height());
    if (question.long_side <= 0 && longest > pixels_side_limit)
        refuse("is too large (at most " + std::to_string(pixels_side_limit) + " pixels a side)");
    Reducer reducer(reader.width(), reader.height(), question.long_side);
    std::vector<float> band;
    for (int y = 0; y < reader.height();) {
        int rows = reader.read(y, band);
        for (int i = 0; i < rows; ++i)
            reducer.add_row(y + i, &band[4 * static_cast<std::size_t>(i) * static_cast<std::size_t>(reader.width())],
                            reader.width());
        y += rows;
    }
    return text_from(reducer.pixels());
}

}  // namespace fieldwright::assets
