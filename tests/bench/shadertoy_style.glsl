// Shadertoy style: how such a scene is written by hand: map() called from the march, the normal, the shadow and the
// occlusion, each a loop that starts at ZERO so that no compiler unrolls it. The benchmark writes the SCENE, and above
// it whether map() gives the id of the nearest shape too, as a vec2, or the distance alone.

uniform vec2 resolution;
uniform int frame;

out vec4 colour_out;

#define ZERO min(frame, 0)

// Marching.
const int STEPS = 256;
const float MIN_STEP = 0.001;
const float TOLERANCE = 0.0001;
const float NEAR = 0.01;
const float FAR = 100.0;

// Shading.
const vec3 ALBEDO = vec3(0.62);
const vec3 SPECULAR = vec3(0.04);
const float SHININESS = 32.0;
const float OCCLUSION_RADIUS = 0.5;

float sdSphere(vec3 p, float r)
{
    return length(p) - r;
}

float sdRoundBox(vec3 p, vec3 b, float r)
{
    vec3 q = abs(p) - b + r;
    return length(max(q, 0.0)) + min(max(q.x, max(q.y, q.z)), 0.0) - r;
}

float sdCappedCylinder(vec3 p, float r, float h)
{
    vec2 d = abs(vec2(length(p.xz), p.y)) - vec2(r, h);
    return min(max(d.x, d.y), 0.0) + length(max(d, 0.0));
}

float sminDistance(float a, float b, float k)
{
    float h = max(k - abs(a - b), 0.0) / k;
    return min(a, b) - h * h * k * 0.25;
}

#if WITH_IDS

#define Found vec2
#define DISTANCE(found) (found).x
#define ID(found) (found).y
#define SHAPE(distance, id) vec2(distance, id)

vec2 opUnion(vec2 a, vec2 b)
{
    return b.x < a.x ? b : a;
}

vec2 opSmoothUnion(vec2 a, vec2 b, float k)
{
    return vec2(sminDistance(a.x, b.x, k), b.x < a.x ? b.y : a.y);
}

vec2 opSubtraction(vec2 a, vec2 b)
{
    return vec2(max(a.x, -b.x), a.y);
}

#else

#define Found float
#define DISTANCE(found) (found)
#define ID(found) 0.0
#define SHAPE(distance, id) distance
#define opUnion(a, b) min(a, b)
#define opSmoothUnion(a, b, k) sminDistance(a, b, k)
#define opSubtraction(a, b) max(a, -b)

#endif

// SCENE

// x: distance along the ray, or -1 when it leaves. y: id of what it meets.
vec2 castRay(vec3 ro, vec3 rd, float tmin, float tmax)
{
    float t = tmin;
    for (int i = ZERO; i < STEPS; i++) {
        Found found = map(ro + rd * t);
        float h = DISTANCE(found);
        if (h < TOLERANCE) return vec2(t + clamp(h, -MIN_STEP, 0.0), ID(found));
        t += max(h, MIN_STEP);
        if (t >= tmax) break;
    }
    return vec2(-1.0, 0.0);
}

// Four taps on a tetrahedron; not of unit length.
vec3 calcGradient(vec3 pos, float t)
{
    float e = 0.0002 * max(1.0, t);
    vec3 n = vec3(0.0);
    for (int i = ZERO; i < 4; i++) {
        vec3 corner = 2.0 * vec3(((i + 3) >> 1) & 1, (i >> 1) & 1, i & 1) - 1.0;
        n += corner * DISTANCE(map(pos + e * corner));
    }
    return n / (4.0 * e);
}

float calcShadow(vec3 pos, vec3 nor)
{
    if (dot(nor, SUN) <= 0.0) return 0.0;
    float offset = 4.0 * TOLERANCE + 2.0 * MIN_STEP;
    return castRay(pos + offset * nor, SUN, 0.0, FAR).x < 0.0 ? 1.0 : 0.0;
}

float calcOcclusion(vec3 pos, vec3 nor, float slope)
{
    float open = 1.0;
    for (int i = ZERO; i < 5; i++) {
        float h = OCCLUSION_RADIUS * float(i + 1) / 5.0;
        float d = DISTANCE(map(pos + h * nor));
        open -= 0.2 * (1.0 - clamp(d / (h * clamp(slope, 0.1, 1.0)), 0.0, 1.0));
    }
    return open;
}

vec3 sky(vec3 rd)
{
    float above = smoothstep(0.0, 0.7, rd.y);
    float below = smoothstep(0.0, 0.5, -rd.y);
    return mix(mix(HORIZON, ZENITH, above), GROUND, below);
}

// Colour, and the id in w.
vec4 render(vec3 ro, vec3 rd)
{
    vec2 res = castRay(ro, rd, NEAR, FAR);
    float t = res.x;
    if (t < 0.0) return vec4(sky(rd), 0.0);
    vec3 pos = ro + t * rd;
    vec3 gradient = calcGradient(pos, t);
    vec3 nor = normalize(gradient);
    float occlusion = calcOcclusion(pos, nor, length(gradient));
    float shadow = calcShadow(pos, nor);
    float diffuse = max(dot(nor, SUN), 0.0);
    float highlight = pow(clamp(dot(reflect(-SUN, nor), -rd), 0.0001, 1.0), SHININESS);
    vec3 col = 0.5 * occlusion * ALBEDO * sky(nor) + shadow * SUN_COLOUR * (ALBEDO * diffuse + SPECULAR * highlight);
    return vec4(col, res.y);
}

void main()
{
    vec2 p = (2.0 * gl_FragCoord.xy - resolution) / resolution.y;
    vec3 ww = normalize(TARGET - EYE);
    vec3 uu = normalize(cross(ww, vec3(0.0, 1.0, 0.0)));
    vec3 vv = cross(uu, ww);
    vec3 rd = normalize(ww + SLOPE * (p.x * uu + p.y * vv));
    colour_out = render(EYE, rd);
}
