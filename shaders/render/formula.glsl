// Formula: the operations that typed formulas are made of. Nothing infinite or undefined comes out of them: results
// beyond 1e12 stay there, a division by 0 gives 0, as do the square root and an uneven power of a negative number.
const float FORMULA_LIMIT = 1.0e12f;
const float FORMULA_TINY = 1.0e-20f;

float formula_limited(float a)
{
    return clamp(a, -FORMULA_LIMIT, FORMULA_LIMIT);
}

float formula_x(vec3 p)
{
    return p.x;
}

float formula_y(vec3 p)
{
    return p.y;
}

float formula_z(vec3 p)
{
    return p.z;
}

// The nearest point of a box around the origin.
vec3 formula_within(vec3 p, vec3 half_size)
{
    return clamp(p, -half_size, half_size);
}

float formula_negate(float a)
{
    return -a;
}

float formula_add(float a, float b)
{
    return a + b;
}

float formula_subtract(float a, float b)
{
    return a - b;
}

float formula_multiply(float a, float b)
{
    return formula_limited(a * b);
}

float formula_divide(float a, float b)
{
    bool none = abs(b) < FORMULA_TINY;
    return none ? 0.0f : formula_limited(a / (none ? 1.0f : b));
}

float formula_power(float a, float b)
{
    float size = abs(a);
    bool none = size < FORMULA_TINY;
    float magnitude = exp2(min(b * log2(none ? 1.0f : size), 39.8631371f));
    magnitude = none ? (b == 0.0f ? 1.0f : 0.0f) : magnitude;
    float whole = floor(b);
    bool odd = whole - 2.0f * floor(0.5f * whole) > 0.5f;
    float mirrored = whole == b ? (odd ? -magnitude : magnitude) : 0.0f;
    return a < 0.0f ? mirrored : magnitude;
}

float formula_less(float a, float b)
{
    return a < b ? 1.0f : 0.0f;
}

float formula_less_equal(float a, float b)
{
    return a <= b ? 1.0f : 0.0f;
}

float formula_equal(float a, float b)
{
    return a == b ? 1.0f : 0.0f;
}

float formula_choose(float condition, float a, float b)
{
    return condition == 0.0f ? b : a;
}

float formula_sin(float a)
{
    return sin(a);
}

float formula_cos(float a)
{
    return cos(a);
}

// A polynomial, as machines differ in theirs (Abramowitz and Stegun 1964, 4.4.49).
float formula_atan2(float y, float x)
{
    float larger = max(abs(x), abs(y));
    float ratio = min(abs(x), abs(y)) / max(larger, FORMULA_TINY);
    float s = ratio * ratio;
    float series = 0.0429096138f + s * (-0.0161657367f + s * 0.0028662257f);
    series = 0.1065626393f + s * (-0.0752896400f + s * series);
    series = 1.0f + s * (-0.3333314528f + s * (0.1999355085f + s * (-0.1420889944f + s * series)));
    float angle = ratio * series;
    angle = abs(y) > abs(x) ? 1.57079633f - angle : angle;
    angle = x < 0.0f ? 3.14159265f - angle : angle;
    return y < 0.0f ? -angle : angle;
}

float formula_sqrt(float a)
{
    return sqrt(max(a, 0.0f));
}

float formula_abs(float a)
{
    return abs(a);
}

float formula_min(float a, float b)
{
    return min(a, b);
}

float formula_max(float a, float b)
{
    return max(a, b);
}

float formula_floor(float a)
{
    return floor(a);
}

float formula_sign(float a)
{
    return sign(a);
}

float formula_exp(float a)
{
    return exp(min(a, 27.6310211f));
}

// Of 0 and of what is negative: that of the smallest number, -46.
float formula_log(float a)
{
    return log(max(a, FORMULA_TINY));
}

float formula_length(float a, float b)
{
    return sqrt(a * a + b * b);
}
