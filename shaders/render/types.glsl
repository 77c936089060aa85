// Types: the structures that node files and the shading library pass around.

struct Box {
    vec3 centre;
    vec3 half_size;
};

// specular: what is mirrored straight on. The highlight is Phong's, of that shininess, or that of microfacets of that
// roughness, or between them: microfacet is 0, 1, or in a blend between.
struct Material {
    vec3 albedo;
    vec3 specular;
    float shininess;
    vec3 emission;
    float roughness;
    float microfacet;
};

// direction points from the surface to the light; range is the way to it.
struct Light {
    vec3 direction;
    float range;
    vec3 radiance;
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

// With Phong's highlight.
Material make_material(vec3 albedo, vec3 specular, float shininess, vec3 emission)
{
    Material material;
    material.albedo = albedo;
    material.specular = specular;
    material.shininess = shininess;
    material.emission = emission;
    material.roughness = 1.0f;
    material.microfacet = 0.0f;
    return material;
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
