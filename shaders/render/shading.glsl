// Shading: what a light, the sky and a material give at a surface, in linear Rec.709.

// Phong. A sun of radiance 1 at normal incidence shows the albedo. visibility: 0 in shadow, 1 lit; view: to the eye.
vec3 shade_light(Material material, vec3 normal, vec3 view, Light light, float visibility)
{
    float incidence = dot(normal, light.direction);
    vec3 mirrored = 2.0f * incidence * normal - light.direction;
    float alignment = clamp(dot(mirrored, view), 1.0e-4f, 1.0f);
    float highlight = incidence > 0.0f ? pow(alignment, max(material.shininess, 1.0e-3f)) : 0.0f;
    vec3 reflected = material.albedo * max(incidence, 0.0f) + material.specular * highlight;
    return visibility * light.radiance * reflected;
}

// Light of the sky around the normal, as far as it is open, and the surface's own. Half the radiance straight along the
// normal stands for the hemisphere, whose rim is the ground and other things.
vec3 shade_ambient(Material material, vec3 sky_radiance, float openness)
{
    return 0.5f * openness * material.albedo * sky_radiance + material.emission;
}
