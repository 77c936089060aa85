// Wave: Bends a solid into a wave that runs along one axis and swings along another.
// field: bound
// synonyms: wiggle, sine, snake, undulate, ripple, flag
const float WAVE_TWO_PI = 6.28318531f;

// The components along, towards and across.
vec3 wave_sorted(vec3 v, int axes)
{
    vec3 result = axes == 0 ? v : vec3(v.x, v.z, v.y);
    result = axes == 2 ? vec3(v.y, v.x, v.z) : result;
    result = axes == 3 ? vec3(v.y, v.z, v.x) : result;
    result = axes == 4 ? vec3(v.z, v.x, v.y) : result;
    return axes == 5 ? vec3(v.z, v.y, v.x) : result;
}

vec3 wave_restored(vec3 v, int axes)
{
    vec3 result = axes == 0 ? v : vec3(v.x, v.z, v.y);
    result = axes == 2 ? vec3(v.y, v.x, v.z) : result;
    result = axes == 3 ? vec3(v.z, v.x, v.y) : result;
    result = axes == 4 ? vec3(v.y, v.z, v.x) : result;
    return axes == 5 ? vec3(v.z, v.y, v.x) : result;
}

vec3 wave_point(
    vec3 p,
    int axes,          // y_to_x {x_to_y, x_to_z, y_to_x, y_to_z, z_to_x, z_to_y}  Along which axis, swinging to which.
    float amplitude,   // 0.15 [0, 100] [0, 1] m  How far it swings to each side.
    float wavelength,  // 1.0 [0.01, 1000] [0.1, 5] m  Distance from crest to crest.
    float phase)       // 0.0 [-36000, 36000] [-180, 180] deg  Where the wave begins; wire time here to let it run.
{
    vec3 v = wave_sorted(p, axes);
    float turns = v.x / wavelength;
    float swing = amplitude * sin((turns - floor(turns)) * WAVE_TWO_PI - phase);
    return wave_restored(vec3(v.x, v.y - swing, v.z), axes);
}

// Largest singular value of the shear where the wave is steepest.
float wave_stretch(float amplitude, float wavelength)
{
    float slope = amplitude * WAVE_TWO_PI / wavelength;
    return 0.5f * (slope + sqrt(slope * slope + 4.0f));
}

Box wave_bounds(int axes, float amplitude, Box child)
{
    return make_box(child.centre, child.half_size + wave_restored(vec3(0.0f, amplitude, 0.0f), axes));
}
