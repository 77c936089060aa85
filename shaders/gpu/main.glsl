// Main: the fragment shader of the GPU device: one pixel into its buffers.

uniform vec2 resolution;   // of the whole picture
uniform vec2 first_pixel;  // where the part that is drawn begins
uniform vec2 offset;       // of the sample from the pixel's centre
uniform vec2 lens;         // where the sample's ray crosses it
uniform March march;
#if FOG
uniform Fog fog;
#endif
uniform int step_budget;  // distances per pixel, all rays together
uniform int ray_count;    // 1 + SHADOW_COUNT
uniform float eye;        // -1 left, 0 centre, 1 right
uniform float interaxial;
uniform float convergence;
uniform float toe_in;     // 1: the eyes turn, else off-axis
uniform bool has_view;    // else the scene's camera
uniform Viewpoint view;
#if COVERAGE
uniform float sky;         // 1: it shows where eye rays meet nothing, else a backdrop is laid there
uniform float pixel_size;  // of the whole picture, in uv
#endif

// What else is kept of a pixel, as one number: a whole one, and half a share as what is left of it.
float extras(Pixel pixel)
{
    float both = 0.0;
#if COUNTS
    both += float(pixel.evaluations);
#endif
#if COVERAGE
    both += 0.5 * pixel.covered;
#endif
    return both;
}

#if LAYERS
// Eight buffers are all that GL 3.3 promises: the colour is the sum of its layers, the normal stands as two numbers, and
// shadow and occlusion as one.
layout(location = 0) out vec4 depth_and_ids;  // depth (-1 on a miss), node id, material id, steps (-1 - steps: exhausted)
layout(location = 1) out vec4 normal_extras_and_cone_ratio;
layout(location = 2) out vec4 position_and_shares;
layout(location = 3) out vec4 albedo_and_gradient_length;
layout(location = 4) out vec4 ambient_and_shadow_steps;
layout(location = 5) out vec4 diffuse_and_emission_red;
layout(location = 6) out vec4 specular_and_emission_green;
layout(location = 7) out vec4 reflection_and_emission_blue;

// A unit vector on the octahedron, unfolded to a square (Meyer et al., "On floating-point normal vectors", 2010).
vec2 octahedral(vec3 unit)
{
    vec3 on_octahedron = unit / max(abs(unit.x) + abs(unit.y) + abs(unit.z), 1.0e-20);
    vec2 sides = vec2(on_octahedron.x >= 0.0 ? 1.0 : -1.0, on_octahedron.y >= 0.0 ? 1.0 : -1.0);
    return on_octahedron.z >= 0.0 ? on_octahedron.xy : (1.0 - abs(on_octahedron.yx)) * sides;
}

// Two shares from 0 to 1 with 12 bits each, finer than the halves of a file: what a float holds exactly.
float packed_shares(float first, float second)
{
    return 4096.0 * floor(4095.0 * clamp(first, 0.0, 1.0) + 0.5) + floor(4095.0 * clamp(second, 0.0, 1.0) + 0.5);
}

void write(Pixel pixel)
{
    Layers layers = pixel.layers;
    float steps = float(pixel.steps);
    depth_and_ids = vec4(pixel.depth, pixel.node_id, pixel.material_id, pixel.exhausted > 0.5 ? -1.0 - steps : steps);
    normal_extras_and_cone_ratio = vec4(octahedral(pixel.normal), extras(pixel), layers.cone_ratio);
    position_and_shares = vec4(layers.position, packed_shares(layers.shadow, layers.occlusion));
    albedo_and_gradient_length = vec4(layers.albedo, layers.gradient_length);
    ambient_and_shadow_steps = vec4(layers.ambient, float(layers.shadow_steps));
    diffuse_and_emission_red = vec4(layers.diffuse, layers.emission.r);
    specular_and_emission_green = vec4(layers.specular, layers.emission.g);
    reflection_and_emission_blue = vec4(layers.reflection, layers.emission.b);
}
#else
layout(location = 0) out vec4 colour_and_exhausted;
layout(location = 1) out vec4 depth_and_ids;  // depth (-1 on a miss), node id, material id, steps
layout(location = 2) out vec4 normal_and_extras;

void write(Pixel pixel)
{
    colour_and_exhausted = vec4(pixel.colour, pixel.exhausted);
    depth_and_ids = vec4(pixel.depth, pixel.node_id, pixel.material_id, float(pixel.steps));
    normal_and_extras = vec4(pixel.normal, extras(pixel));
}
#endif

Ray eye_ray(vec2 uv)
{
#if LENS
    Ray camera_ray = scene_ray(uv, turned_lens(lens, floor(gl_FragCoord.xy) + first_pixel));
#else
    Ray camera_ray = scene_ray(uv, lens);
#endif
    if (has_view) camera_ray = view_ray(uv, view);
    return stereo_ray(camera_ray, eye, interaxial, convergence, toe_in);
}

void main()
{
    vec2 uv = (2.0 * (gl_FragCoord.xy + first_pixel + offset) - resolution) / resolution.y;
    Ray ray = eye_ray(uv);
#if COVERAGE
    Footprint footprint = make_footprint(ray, eye_ray(uv + vec2(pixel_size, 0.0)), eye_ray(uv + vec2(0.0, pixel_size)));
#endif
    write(trace_pixel(ray,
#if COVERAGE
                      footprint, sky,
#endif
                      scene_march(march),
#if FOG
                      fog,
#endif
                      step_budget, ray_count));
}
