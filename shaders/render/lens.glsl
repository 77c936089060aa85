// Lens: where the samples of a pixel cross it. Each pixel turns them about the middle by an angle of its own, or few samples of a
// wide lens would show as so many edges.

// Whole numbers, so that all machines agree; no product of two reaches 2^24.
const float LENS_TURNS = 2039.0f;

float lens_remainder(float x)
{
    return x - LENS_TURNS * floor((x + 0.5f) / LENS_TURNS);
}

// From 0 to 1, far from that of the neighbours: multiples of 1/p and 1/p^2, p^3 = p + 1 (M. Roberts, "The unreasonable
// effectiveness of quasirandom sequences", 2018), rounded. pixel: whole numbers.
float lens_turn(vec2 pixel)
{
    float x = 1539.0f * lens_remainder(pixel.x), y = 1162.0f * lens_remainder(pixel.y);
    return lens_remainder(lens_remainder(x) + lens_remainder(y)) / LENS_TURNS;
}

// lens: the sample's place in the unit disk; the middle stays.
vec2 turned_lens(vec2 lens, vec2 pixel)
{
    float angle = 6.2831853f * lens_turn(pixel);
    float c = cos(angle), s = sin(angle);
    return vec2(c * lens.x - s * lens.y, s * lens.x + c * lens.y);
}
