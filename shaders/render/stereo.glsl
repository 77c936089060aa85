// Stereo: two eyes from one camera, and two pictures in one anaglyph.

// Off-axis: the ray of the same pixel from an eye beside the camera. eye: -1 left, 0 centre, 1 right. Both eyes meet at
// the depth `convergence` along forward, so there is no vertical parallax.
Ray stereo_ray(Ray ray, float eye, float interaxial, float convergence)
{
    float forward_share = max(dot(ray.direction, ray.forward), 1.0e-3f);
    vec3 shift = (0.5f * interaxial * eye) * ray.right;
    vec3 target = ray.direction * (convergence / forward_share);
    Ray result;
    result.origin = ray.origin + shift;
    result.direction = normalize(target - shift);
    result.forward = ray.forward;
    result.right = ray.right;
    return result;
}

// Red from the left eye, green and blue from the right.
vec3 naive_anaglyph(vec3 left, vec3 right)
{
    return vec3(left.r, right.g, right.b);
}

// Least-squares red/cyan anaglyph in linear light (E. Dubois, "A projection method to generate anaglyph stereo
// images", 2001).
vec3 dubois_anaglyph(vec3 left, vec3 right)
{
    float r = dot(vec3(0.456100f, 0.500484f, 0.176381f), left) +
              dot(vec3(-0.0434706f, -0.0879388f, -0.00155529f), right);
    float g = dot(vec3(-0.0400822f, -0.0378246f, -0.0157589f), left) +
              dot(vec3(0.378476f, 0.733640f, -0.0184503f), right);
    float b = dot(vec3(-0.0152161f, -0.0205971f, -0.00546856f), left) +
              dot(vec3(-0.0721527f, -0.112961f, 1.226400f), right);
    return clamp(vec3(r, g, b), vec3(0.0f), vec3(1.0f));
}
