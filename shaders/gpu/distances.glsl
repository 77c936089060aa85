// Distances: one signed distance per pixel, at the points of a texture.

uniform samplerBuffer points;
uniform int points_per_row;

layout(location = 0) out vec4 distance_out;

void main()
{
    int index = int(gl_FragCoord.y) * points_per_row + int(gl_FragCoord.x);
    vec4 point = texelFetch(points, index);
    distance_out = vec4(scene_distance(vec3(point.x, point.y, point.z)), 0.0, 0.0, 0.0);
}
