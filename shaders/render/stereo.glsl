// Stereo: two eyes from one camera.

// The ray of the same pixel from an eye beside the camera; eye: -1 left, 0 centre, 1 right. Off-axis: both eyes keep the
// camera's direction and meet at the depth `convergence` along forward, so there is no vertical parallax. With toe_in 1
// each eye turns to the point there instead, as cameras on a tripod do; that bends the picture's plane (keystone).
Ray stereo_ray(Ray ray, float eye, float interaxial, float convergence, float toe_in)
{
    float ahead = dot(ray.direction, ray.forward);
    float aside = dot(ray.direction, ray.right);
    vec3 shift = (0.5f * interaxial * eye) * ray.right;
    vec3 target = ray.direction * (convergence / max(ahead, 1.0e-3f));
    // The turn's tangent is the eye's way aside over the way ahead to where both meet.
    float tangent = 0.5f * interaxial * eye / convergence;
    float cosine = 1.0f / sqrt(1.0f + tangent * tangent);
    float sine = tangent * cosine;
    vec3 turned = ray.direction + (ahead * (cosine - 1.0f) + aside * sine) * ray.forward +
                  (aside * (cosine - 1.0f) - ahead * sine) * ray.right;
    Ray result;
    result.origin = ray.origin + shift;
    result.direction = toe_in > 0.5f ? turned : normalize(target - shift);
    result.forward = ray.forward;
    result.right = ray.right;
    return result;
}
