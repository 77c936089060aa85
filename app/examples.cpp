// Naming the examples, reading them, decoding their pictures.
#include "app/examples.h"

#include "graph/scene_file.h"

#include <stb/stb_image.h>

#include <algorithm>
#include <cstdint>
#include <memory>

namespace fieldwright::app {
namespace {

struct Words {
    std::string_view name;
    const char *title, *sentence;
};
constexpr Words words[] = {
    {"first", "First shape", "A ball that melts into its foot, a ring around it, on a floor of tiles."},
    {"smooth_blends", "Smooth blends", "A ball and a block joined ever more softly, and their colours with them."},
    {"repetition", "Repetition", "One tower becomes a town: each copy has its own height and colour."},
    {"booleans", "Booleans", "A cube and a ball united, intersected and subtracted."},
    {"twist_and_bend", "Twist and bend", "Shapes in a space that is itself twisted or bent."},
    {"profiles", "Profiles", "Flat outlines made solid: given a thickness, or turned about an axis."},
    {"pulse", "Pulse", "A wave runs through a field of beads; Shift+Space plays it."},
    {"tractor", "Tractor", "One wheel, made once as a group and used four times with sizes of its own."},
    {"orthographic_room", "Orthographic room", "A furnished room, drawn without perspective."},
};

}  // namespace

std::vector<Example> examples()
{
    std::vector<Example> list;
    for (const Words& entry : words)
        for (const ExampleFile& file : example_files())
            if (file.name == entry.name) list.push_back({file, entry.title, entry.sentence});
    return list;
}

graph::Document example_scene(const ExampleFile& file, const graph::Library& library)
{
    return graph::read_scene(file.text, library, file.name);
}

ImTextureID ExamplePictures::texture(const ExampleFile& file)
{
    int width = 0, height = 0, channels = 0;
    std::unique_ptr<unsigned char, void (*)(void*)> rgb(
        stbi_load_from_memory(file.picture.data(), static_cast<int>(file.picture.size()), &width, &height, &channels,
                              3),
        stbi_image_free);
    if (!rgb) return nullptr;
    const renderer::Texture& texture = textures_.emplace_back();
    glBindTexture(GL_TEXTURE_2D, texture.name());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, width, height, 0, GL_RGB, GL_UNSIGNED_BYTE, rgb.get());
    for (GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    for (GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
    return reinterpret_cast<ImTextureID>(static_cast<std::intptr_t>(texture.name()));
}

}  // namespace fieldwright::app
