// Shading: what a light, the sky and a material give at a surface, in linear Rec.709.

// Phong's highlight: how bright a lobe around the mirrored direction is.
float phong_highlight(Material material, vec3 normal, vec3 view, vec3 light, float incidence)
{
    vec3 mirrored = 2.0f * incidence * normal - light;
    float alignment = clamp(dot(mirrored, view), 1.0e-4f, 1.0f);
    return incidence > 0.0f ? pow(alignment, max(material.shininess, 1.0e-3f)) : 0.0f;
}

#if MICROFACETS
// Highlight of microfacets: distribution of Trowbridge and Reitz, height-correlated masking by Smith, Fresnel by
// Schlick; times pi, since a sun of radiance 1 shows the albedo. roughness is that of artists, the square root of the
// distribution's.
vec3 microfacet_highlight(Material material, vec3 normal, vec3 view, vec3 light, float incidence)
{
    float lit = clamp(incidence, 0.0f, 1.0f);
    float seen = clamp(dot(normal, view), 1.0e-3f, 1.0f);
    vec3 between = light + view;
    vec3 facet = between / max(length(between), 1.0e-4f);
    float aligned = clamp(dot(normal, facet), 0.0f, 1.0f);
    float grazing = 1.0f - clamp(dot(view, facet), 0.0f, 1.0f);
    float alpha = material.roughness * material.roughness;
    float squared = alpha * alpha;
    float spread = aligned * aligned * (squared - 1.0f) + 1.0f;
    float masked = lit * sqrt(seen * seen * (1.0f - squared) + squared) +
                   seen * sqrt(lit * lit * (1.0f - squared) + squared);
    float strength = 0.5f * lit * squared / max(spread * spread * masked, 1.0e-6f);
    float fourth = grazing * grazing * grazing * grazing;
    return strength * (material.specular + (vec3(1.0f) - material.specular) * (fourth * grazing));
}
#endif

// What a surface mirrors of a light of radiance 1.
vec3 shade_highlight(Material material, vec3 normal, vec3 view, vec3 light, float incidence)
{
    vec3 highlight = material.specular * phong_highlight(material, normal, view, light, incidence);
#if MICROFACETS
    vec3 facets = microfacet_highlight(material, normal, view, light, incidence);
    highlight = mix(highlight, facets, material.microfacet);
#endif
    return highlight;
}

// A sun of radiance 1 at normal incidence shows the albedo. visibility: 0 in shadow, 1 lit; view: to the eye.
vec3 shade_light(Material material, vec3 normal, vec3 view, Light light, float visibility)
{
    float incidence = dot(normal, light.direction);
    vec3 highlight = shade_highlight(material, normal, view, light.direction, incidence);
    return visibility * light.radiance * (material.albedo * max(incidence, 0.0f) + highlight);
}

#if LAYERS
// The first half of shade_light.
vec3 shade_diffuse(Material material, vec3 normal, Light light, float visibility)
{
    return visibility * light.radiance * (material.albedo * max(dot(normal, light.direction), 0.0f));
}

// The second half of shade_light.
vec3 shade_specular(Material material, vec3 normal, vec3 view, Light light, float visibility)
{
    float incidence = dot(normal, light.direction);
    return visibility * light.radiance * shade_highlight(material, normal, view, light.direction, incidence);
}
#endif

#if MICROFACETS
// How much of what a surface of microfacets gives back is mirrored.
float mirrored_share(Material material)
{
    float mirrored = material.specular.x + material.specular.y + material.specular.z;
    float scattered = material.albedo.x + material.albedo.y + material.albedo.z;
    return material.microfacet * (1.0f - material.roughness) * mirrored / max(mirrored + scattered, 1.0e-6f);
}
#endif

// How wide that look is: 1 the hemisphere of a matt surface, 0 the one direction of a mirror.
float ambient_spread(Material material)
{
    float spread = 1.0f;
#if MICROFACETS
    spread -= mirrored_share(material);
#endif
    return spread;
}

// Where the one look at the sky goes that stands for all its light: along the normal, and the more a surface of
// microfacets mirrors, the nearer to the mirrored direction. direction: from the eye.
vec3 ambient_direction(Material material, vec3 normal, vec3 direction)
{
    vec3 look = normal;
#if MICROFACETS
    vec3 between = mix(normal, direction - 2.0f * dot(direction, normal) * normal, mirrored_share(material));
    look = between / max(length(between), 1.0e-4f);
#endif
    return look;
}

// Light of the sky from ambient_direction, as far as it is open. Half that radiance stands for the hemisphere, whose rim
// is the ground and other things.
vec3 shade_ambient(Material material, vec3 sky_radiance, float openness)
{
    vec3 share = 0.5f * material.albedo;
#if MICROFACETS
    share += material.microfacet * (1.0f - 0.5f * material.roughness) * material.specular;
#endif
    return openness * sky_radiance * share;
}
