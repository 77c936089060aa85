// Types: the structures that node files and the shading library pass around.

struct Box {
    vec3 centre;
    vec3 half_size;
};

// specular: what is mirrored straight on. The highlight is Phong's, of that shininess, or that of microfacets of that
// roughness, or between them: microfacet is 0, 1, or in a blend between. reflection: what is mirrored straight on of the
// scene itself. transmission: the share of the rest that goes through; on the way it loses absorption (per metre).
#if TINTED_SHADOWS
// shadow: 0 as of what is opaque, 1 of what does not come through, 2 none; between, of both.
#endif
struct Material {
    vec3 albedo;
    vec3 specular;
    float shininess;
    vec3 emission;
#if MICROFACETS
    float roughness;
    float microfacet;
#endif
#if REFLECTION
    vec3 reflection;
    float transmission;
    float refraction_index;
    vec3 absorption;
#endif
#if TINTED_SHADOWS
    float shadow;
#endif
};

// direction points from the surface to the light; range is the way to it. sharpness: k of a soft shadow, whose edge is
// 1/k as wide as it is far from what casts it.
struct Light {
    vec3 direction;
    float range;
    vec3 radiance;
    float sharpness;
};

// direction, forward and right are unit vectors; depth is measured along forward.
struct Ray {
    vec3 origin;
    vec3 direction;
    vec3 forward;
    vec3 right;
};

// Kinds of sockets of the output node.
struct Camera {
    Ray ray;
};

struct Sky {
    vec3 radiance;
};

struct Surface {
    Material material;
    float material_id;
    float node_id;
};

const float UNBOUNDED = 1.0e6f;

// With Phong's highlight, opaque, and no mirror.
Material make_material(vec3 albedo, vec3 specular, float shininess, vec3 emission)
{
    Material material;
    material.albedo = albedo;
    material.specular = specular;
    material.shininess = shininess;
    material.emission = emission;
#if MICROFACETS
    material.roughness = 1.0f;
    material.microfacet = 0.0f;
#endif
#if REFLECTION
    material.reflection = vec3(0.0f);
    material.transmission = 0.0f;
    material.refraction_index = 1.0f;
    material.absorption = vec3(0.0f);
#endif
#if TINTED_SHADOWS
    material.shadow = 1.0f;
#endif
    return material;
}

// Mirrors what is around it, by this much seen straight on.
Material with_reflection(Material material, vec3 reflection)
{
    Material result = material;
#if REFLECTION
    result.reflection = reflection;
#endif
    return result;
}

// The highlight becomes that of microfacets; the smoother they are, the more the surface is a mirror.
Material with_microfacets(Material material, float roughness)
{
    Material result = material;
#if MICROFACETS
    result.roughness = roughness;
    result.microfacet = 1.0f;
#endif
    return with_reflection(result, (1.0f - roughness) * (1.0f - roughness) * material.specular);
}

// Lets a share of the light through, refracted by the index; mirrors as Fresnel says of that index.
Material with_transmission(Material material, float transmission, float refraction_index, vec3 absorption)
{
    Material result = material;
#if REFLECTION
    result.transmission = transmission;
    result.refraction_index = refraction_index;
    result.absorption = absorption;
#endif
    float ratio = (refraction_index - 1.0f) / (refraction_index + 1.0f);
    return with_reflection(result, vec3(ratio * ratio));
}

#if TRANSMISSION
// The shadow of what lets light through: 0 as if it did not, 1 of what does not come through, 2 none.
Material with_shadow(Material material, int shadow)
{
    Material result = material;
#if TINTED_SHADOWS
    result.shadow = float(shadow);
#endif
    return result;
}

#endif
// How a lamp fades over a way: 0 with its square, and the intensity is that at one metre; 1 likewise, and the intensity is
// the power that all of the sphere around gets; 2 not at all.
float lamp_falloff(int falloff, float way)
{
    float square = 1.0f / (way * way);
    float powered = falloff == 1 ? 0.0795774715f * square : square;
    return falloff == 2 ? 1.0f : powered;
}

// Light of a small lamp, which is `way` from the surface.
Light lamp_light(vec3 way, vec3 colour, float intensity, int falloff, float sharpness)
{
    Light light;
    light.range = max(length(way), 1.0e-3f);
    light.direction = way / light.range;
    light.radiance = colour * (intensity * lamp_falloff(falloff, light.range));
    light.sharpness = sharpness;
    return light;
}

Box make_box(vec3 centre, vec3 half_size)
{
    Box box;
    box.centre = centre;
    box.half_size = min(half_size, vec3(UNBOUNDED));
    return box;
}

Box everywhere()
{
    return make_box(vec3(0.0f), vec3(UNBOUNDED));
}

// The smallest box around two boxes.
Box join_boxes(Box a, Box b)
{
    vec3 low = min(a.centre - a.half_size, b.centre - b.half_size);
    vec3 high = max(a.centre + a.half_size, b.centre + b.half_size);
    return make_box(0.5f * (low + high), 0.5f * (high - low));
}

// The overlap of two boxes; a point where they do not meet.
Box overlap_boxes(Box a, Box b)
{
    vec3 low = max(a.centre - a.half_size, b.centre - b.half_size);
    vec3 high = max(min(a.centre + a.half_size, b.centre + b.half_size), low);
    return make_box(0.5f * (low + high), 0.5f * (high - low));
}

Box grow_box(Box box, float margin)
{
    return make_box(box.centre, max(box.half_size + vec3(margin), vec3(0.0f)));
}

// Distance from the origin to the farthest corner of a box.
float box_reach(Box box)
{
    return length(abs(box.centre) + box.half_size);
}
