// Metaballs: Balls around the points of a list that melt into each other. At most 32 points are drawn.
// field: bound
// synonyms: blobs, blobby, liquid, drops
float metaballs_distance(
    vec3 p,
    List points,       // [(-0.5, -0.2, 0), (0.4, -0.3, 0.2), (0.1, 0.4, -0.1)] [-100, 100] m  Centres of the balls.
    float radius,      // 0.35 [0.001, 100] [0.05, 5] m  Radius of a ball on its own.
    float smoothness)  // 0.15 [0.001, 10] [0.01, 1] m  How far the balls reach out for each other.
{
    float nearest = 1.0e6f;
    for (int i = 0; i < 32; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 centre = list_at(points, i);
        nearest = min(nearest, length(p - vec3(centre.x, centre.y, centre.z)));
    }
    float sum = 0.0f;
    for (int i = 0; i < 32; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 centre = list_at(points, i);
        float farther = length(p - vec3(centre.x, centre.y, centre.z)) - nearest;
        sum = sum + exp(-min(farther / smoothness, 80.0f));
    }
    return nearest - smoothness * log(max(sum, 1.0f)) - radius;
}

Box metaballs_bounds(List points, float radius, float smoothness)
{
    vec3 low = vec3(UNBOUNDED);
    vec3 high = vec3(-UNBOUNDED);
    for (int i = 0; i < 32; i++) {
        if (i >= points.count) {
            break;
        }
        vec4 centre = list_at(points, i);
        low = min(low, vec3(centre.x, centre.y, centre.z));
        high = max(high, vec3(centre.x, centre.y, centre.z));
    }
    high = max(high, low);
    vec3 middle = points.count > 0 ? 0.5f * (low + high) : vec3(0.0f);
    float reach = radius + smoothness * log(float(max(min(points.count, 32), 1)));
    return make_box(middle, 0.5f * (high - low) + vec3(reach));
}
