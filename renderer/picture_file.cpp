// Encoding through OpenImageIO.
#include "renderer/picture_file.h"

#include "graph/problem.h"
#include "graph/scene_file.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <unistd.h>
#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

namespace fieldwright::renderer {
namespace {

constexpr int jpeg_quality = 95;
constexpr const char* no_date = "1970:01:01 00:00:00";  // or the same picture would be other bytes a second later

using Pixels = std::function<bool(OIIO::ImageOutput&)>;

OIIO::ImageSpec picture_spec(const Picture& picture, const FileNotes& notes, PictureFormat format)
{
    bool with_alpha = !picture.alpha.empty() && format == PictureFormat::png;
    OIIO::ImageSpec spec(picture.width, picture.height, with_alpha ? 4 : 3, OIIO::TypeDesc::UINT8);
    spec.attribute("oiio:ColorSpace", "sRGB");
    spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format == PictureFormat::png && !notes.scene.empty()) spec.attribute("fieldwright:graph", notes.scene);
    if (format == PictureFormat::jpeg) {
        spec.attribute("CompressionQuality", jpeg_quality);
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    return spec;
}

std::vector<unsigned char> interleaved(const Picture& picture, int channels)
{
    if (channels == 3) return picture.rgb;
    std::vector<unsigned char> rgba;
    rgba.reserve(4 * picture.alpha.size());
    for (std::size_t i = 0; i < picture.alpha.size(); ++i) {
        rgba.insert(rgba.end(), &picture.rgb[3 * i], &picture.rgb[3 * i] + 3);
        rgba.push_back(picture.alpha[i]);
    }
    return rgba;
}

// Writers that cannot write to memory write a file of another name.
std::vector<unsigned char> written_aside(const std::filesystem::path& path, const std::string& end,
                                         const std::function<bool(const std::string&)>& write)
{
    std::string aside = path.string() + "." + std::to_string(getpid()) + end;
    bool written = write(aside);
    std::ifstream stream(aside, std::ios::binary);
    std::vector<unsigned char> bytes(std::istreambuf_iterator<char>(stream), {});
    stream.close();
    std::error_code ignored;
    std::filesystem::remove(aside, ignored);
    return written ? bytes : std::vector<unsigned char>();
}

void write_file(const std::filesystem::path& path, const std::string& format, const std::vector<OIIO::ImageSpec>& parts,
                const std::vector<Pixels>& pixels)
{
    std::string end = "." + format;
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory(bytes);
    auto output = OIIO::ImageOutput::create(format);
    auto write = [&](const std::string& name) {
        bool opened = parts.size() > 1 ? output->open(name, static_cast<int>(parts.size()), parts.data())
                                       : output->open(name, parts[0]);
        bool good = opened && pixels[0](*output);
        for (std::size_t i = 1; good && i < parts.size(); ++i)
            good = output->open(name, parts[i], OIIO::ImageOutput::AppendSubimage) && pixels[i](*output);
        return output->close() && good;
    };
    bool encoded = false;
    // OpenImageIO 2.4 forgets the memory of files of several parts.
    if (output && output->supports("ioproxy") && parts.size() == 1) {
        encoded = output->set_ioproxy(&memory) && write("picture" + end);
    } else if (output) {
        bytes = written_aside(path, end, write);
        encoded = true;
    }
    if (!encoded || bytes.empty())
        throw graph::Failure(5, path.string() + ": the picture cannot be encoded (" +
                                    (output ? output->geterror() : OIIO::geterror()) + "); choose a smaller --size");
    graph::save_atomically(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
}

// Channels that belong together, and how to fill them: `values` is the first one's place in a pixel's.
struct Layer {
    std::vector<const char*> channels;
    OIIO::TypeDesc type;
    std::function<void(float* values, std::size_t pixel)> fill;
};

std::vector<Layer> layers_of(const Frame& frame)
{
    auto vector = [](const std::vector<glm::vec3>& from) {
        return [&from](float* values, std::size_t i) { std::copy_n(&from[i].x, 3, values); };
    };
    auto number = [](const auto& from) {
        return [&from](float* values, std::size_t i) { *values = static_cast<float>(from[i]); };
    };
    auto alpha = [&frame](float* values, std::size_t i) { *values = frame.alpha.empty() ? 1.0f : frame.alpha[i]; };
    const OIIO::TypeDesc half = OIIO::TypeDesc::HALF, whole = OIIO::TypeDesc::FLOAT;
    std::vector<Layer> layers = {
        {{"R", "G", "B"}, half, vector(frame.colour)}, {{"A"}, half, alpha},
        {{"Z"}, whole, number(frame.depth)},           {{"N.X", "N.Y", "N.Z"}, half, vector(frame.normal)},
        {{"id.Y"}, whole, number(frame.node_id)},      {{"material.Y"}, whole, number(frame.material_id)},
        {{"steps.Y"}, whole, number(frame.steps)}};
    if (!frame.layers) return layers;
    const Layers& more = *frame.layers;
    auto add = [&](std::vector<const char*> channels, OIIO::TypeDesc type, const auto& fill) {
        layers.push_back({std::move(channels), type, fill});
    };
    add({"P.X", "P.Y", "P.Z"}, whole, vector(more.position));
    add({"albedo.R", "albedo.G", "albedo.B"}, half, vector(more.albedo));
    add({"ambient.R", "ambient.G", "ambient.B"}, half, vector(more.ambient));
    add({"diffuse.R", "diffuse.G", "diffuse.B"}, half, vector(more.diffuse));
    add({"specular.R", "specular.G", "specular.B"}, half, vector(more.specular));
    add({"reflection.R", "reflection.G", "reflection.B"}, half, vector(more.reflection));
    add({"emission.R", "emission.G", "emission.B"}, half, vector(more.emission));
    add({"shadow.Y"}, half, number(more.shadow));
    add({"occlusion.Y"}, half, number(more.occlusion));
    add({"gradient.Y"}, whole, number(more.gradient_length));
    add({"cone.Y"}, whole, number(more.minimum_cone_ratio));
    add({"shadow_steps.Y"}, whole, number(more.shadow_steps));
    return layers;
}

OIIO::ImageSpec exr_spec(const std::vector<Layer>& layers, const FileNotes& notes)
{
    OIIO::ImageSpec spec(notes.part.width, notes.part.height, 0, OIIO::TypeDesc::FLOAT);
    spec.x = notes.part.x, spec.y = notes.part.y;
    spec.full_width = notes.width, spec.full_height = notes.height;
    for (const Layer& layer : layers)
        for (const char* channel : layer.channels) {
            if (std::string_view(channel) == "A") spec.alpha_channel = spec.nchannels;
            if (std::string_view(channel) == "Z") spec.z_channel = spec.nchannels;
            spec.channelnames.emplace_back(channel);
            spec.channelformats.push_back(layer.type);
            ++spec.nchannels;
        }
    spec.attribute("compression", "zip");
    spec.attribute("oiio:ColorSpace", "Linear");
    spec.attribute("DateTime", no_date);
    spec.attribute("Software", "Fieldwright");
    spec.attribute("fieldwright/depth", "metres along the view axis; inf where nothing was hit");
    spec.attribute("fieldwright/samples", notes.samples);
    if (!notes.scene.empty()) spec.attribute("fieldwright/graph", notes.scene);
    const int rate[2] = {static_cast<int>(std::lround(1000 * notes.frames_per_second)), 1000};
    if (rate[0] > 0) spec.attribute("FramesPerSecond", OIIO::TypeRational, rate);
    return spec;
}

bool write_layers(OIIO::ImageOutput& output, const Frame& frame)
{
    const std::vector<Layer> layers = layers_of(frame);
    auto channels = static_cast<std::size_t>(output.spec().nchannels);
    std::vector<float> values(channels * frame.colour.size());
    std::size_t place = 0;
    for (const Layer& layer : layers) {
        for (std::size_t i = 0; i < frame.colour.size(); ++i) layer.fill(&values[i * channels + place], i);
        place += layer.channels.size();
    }
    return output.write_image(OIIO::TypeDesc::FLOAT, values.data());
}

}  // namespace

std::optional<PictureFormat> picture_format(const std::filesystem::path& path)
{
    std::string end = path.extension().string();
    std::transform(end.begin(), end.end(), end.begin(), [](unsigned char c) { return std::tolower(c); });
    if (end == ".png") return PictureFormat::png;
    if (end == ".jpg" || end == ".jpeg") return PictureFormat::jpeg;
    if (end == ".hdr") return PictureFormat::hdr;
    if (end == ".exr") return PictureFormat::exr;
    return std::nullopt;
}

void write_picture(const std::filesystem::path& path, const Picture& picture, const FileNotes& notes)
{
    bool jpeg = picture_format(path) == PictureFormat::jpeg;
    OIIO::ImageSpec spec = picture_spec(picture, notes, jpeg ? PictureFormat::jpeg : PictureFormat::png);
    std::vector<unsigned char> bytes = interleaved(picture, spec.nchannels);
    write_file(path, jpeg ? "jpeg" : "png", {spec},
               {[&](OIIO::ImageOutput& output) { return output.write_image(OIIO::TypeDesc::UINT8, bytes.data()); }});
}

void write_png(const std::filesystem::path& path, const Picture& picture) { write_picture(path, picture, {}); }

void write_hdr(const std::filesystem::path& path, const Frame& frame)
{
    OIIO::ImageSpec spec(frame.width, frame.height, 3, OIIO::TypeDesc::FLOAT);
    write_file(path, "hdr", {spec}, {[&](OIIO::ImageOutput& output) {
                   return output.write_image(OIIO::TypeDesc::FLOAT, frame.colour.data());
               }});
}

void write_exr(const std::filesystem::path& path, std::span<const Frame* const> eyes, const FileNotes& notes)
{
    std::vector<OIIO::ImageSpec> parts;
    std::vector<Pixels> pixels;
    for (const Frame* eye : eyes) {
        OIIO::ImageSpec& part = parts.emplace_back(exr_spec(layers_of(*eye), notes));
        const char* name = parts.size() == 1 ? "left" : "right";
        if (eyes.size() > 1) part.attribute("view", name), part.attribute("oiio:subimagename", name);
        pixels.push_back([eye](OIIO::ImageOutput& output) { return write_layers(output, *eye); });
    }
    write_file(path, "exr", parts, pixels);
}

Picture read_png(const std::filesystem::path& path)
{
    auto refuse = [&](const std::string& reason) -> graph::Failure {
        return {3, path.string() + ": is not a picture that can be read (" + reason + "); name an 8-bit RGB PNG file"};
    };
    auto input = OIIO::ImageInput::create("png");
    OIIO::ImageSpec spec;
    if (!input || !input->open(path.string(), spec)) throw refuse(input ? input->geterror() : OIIO::geterror());
    if (spec.nchannels < 3) throw refuse("it has fewer than three channels");
    Picture picture{spec.width, spec.height, {}};
    picture.rgb.resize(3 * static_cast<std::size_t>(spec.width) * static_cast<std::size_t>(spec.height));
    if (!input->read_image(0, 0, 0, 3, OIIO::TypeDesc::UINT8, picture.rgb.data())) throw refuse(input->geterror());
    return picture;
}

}  // namespace fieldwright::renderer
