// Mandelbulb: A fractal ball of buds on buds: points whose powers, taken in spherical coordinates, stay near.
// The distance is estimated from how fast the powers grow (Hubbard and Douady's potential, in three dimensions).
// field: approximate 0.5
// synonyms: fractal, bulb, mandelbrot, 3d mandelbrot
float mandelbulb_distance(
    vec3 p,
    float radius,    // 0.8 [0.001, 100] [0.05, 5] m  Radius of the ball that the fractal is drawn in; buds reach a little farther.
    float power,     // 8.0 [2, 16] [2, 12]  Power the points are raised to: the number of buds around, and one.
    int iterations,  // 3 [1, 12] [1, 6]  How many powers are taken: more show finer buds.
    float detail)    // 0.006 [0, 10] [0, 0.1] m  Buds finer than this melt together; about the size of a pixel leaves no grain.
{
    vec3 place = p / radius;
    vec3 z = place;
    float r = length(z);
    float slope = 1.0f;
    for (int i = 0; i < 12; i++) {
        bool going = i < iterations && r < 2.0f;
        float safe = max(r, 1.0e-6f);
        float polar = acos(clamp(z.y / safe, -1.0f, 1.0f)) * power;
        float around = atan(z.z, z.x) * power;
        float raised = pow(safe, power - 1.0f);
        vec3 turned = vec3(sin(polar) * cos(around), cos(polar), sin(polar) * sin(around));
        slope = going ? power * raised * slope + 1.0f : slope;
        z = going ? raised * safe * turned + place : z;
        r = going ? length(z) : r;
    }
    // The surface is where the last power is as far as the unit sphere: smooth, so that its normals are.
    // Nothing lies beyond 1.25; far away the estimate would overshoot.
    float ball = length(place) - 1.25f;
    float estimate = 0.5f * log(max(r, 1.0e-6f)) * r / slope;
    return radius * (ball > 0.75f ? ball : max(ball, estimate)) - detail;
}

Box mandelbulb_bounds(float radius, float detail)
{
    return make_box(vec3(0.0f), vec3(1.25f * radius + detail));
}
