// Main: the fragment shader of the GPU device: one pixel into three buffers.

uniform vec2 resolution;
uniform March march;
uniform int step_budget;  // distances per pixel, all rays together
uniform int ray_count;    // 1 + SHADOW_COUNT
uniform float eye;        // -1 left, 0 centre, 1 right
uniform float interaxial;
uniform float convergence;
uniform bool has_view;    // else the scene's camera
uniform ViewCamera view;

layout(location = 0) out vec4 colour_and_exhausted;
layout(location = 1) out vec4 depth_and_ids;  // depth (-1 on a miss), node id, material id, steps
layout(location = 2) out vec4 normal_out;

void main()
{
    vec2 uv = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    Ray camera_ray = scene_ray(uv);
    if (has_view) camera_ray = view_ray(uv, view);
    Ray ray = stereo_ray(camera_ray, eye, interaxial, convergence);
    Pixel pixel = trace_pixel(ray, march, step_budget, ray_count);
    colour_and_exhausted = vec4(pixel.colour, pixel.exhausted);
    depth_and_ids = vec4(pixel.depth, pixel.node_id, pixel.material_id, float(pixel.steps));
    normal_out = vec4(pixel.normal, 0.0);
}
