// Exposure and tone mapping by the shading library's functions.
#include "renderer/look.h"

#include "graph/settings.h"

namespace fieldwright::renderer {
namespace {

std::string function_of(graph::ToneMap tone_map)
{
    return "tone_map_" + std::string(graph::tone_map_names[static_cast<std::size_t>(tone_map)]);
}

}  // namespace

Look look_of(const graph::PictureSettings& settings) { return {settings.tone_map, settings.exposure}; }

LookFunction::LookFunction(const Look& look)
    : look_(look),
      expose_("expose", field::kernels()),
      tone_map_(function_of(look.tone_map), field::kernels()),
      stops_(1)
{
    stops_.fill(0, look.exposure);
}

void LookFunction::operator()(Rows& shown, int count, const Rows& colour) const
{
    Rows exposed(3);
    expose_(exposed, count, colour, stops_);
    tone_map_(shown, count, exposed);
}

}  // namespace fieldwright::renderer
