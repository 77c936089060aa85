// Stereo: two eyes from one camera.

// The ray of the same pixel from an eye beside the camera; eye: -1 left, 0 centre, 1 right. Off-axis: both eyes keep the
// camera's direction and meet at the depth `convergence` along forward, so there is no vertical parallax. With toe_in 1
// each eye turns to the point there instead, as cameras on a tripod do; that bends the picture's plane (keystone).
Ray stereo_ray(Ray ray, float eye, float interaxial, float convergence, float toe_in)
{
    float forward_share = max(dot(ray.direction, ray.forward), 1.0e-3f);
    vec3 shift = (0.5f * interaxial * eye) * ray.right;
    vec3 target = ray.direction * (convergence / forward_share);
    float turn = atan(0.5f * interaxial * eye / convergence);
    float ahead = dot(ray.direction, ray.forward);
    float aside = dot(ray.direction, ray.right);
    vec3 turned_forward = cos(turn) * ray.forward - sin(turn) * ray.right;
    vec3 turned_right = cos(turn) * ray.right + sin(turn) * ray.forward;
    vec3 above = ray.direction - ahead * ray.forward - aside * ray.right;
    Ray result;
    result.origin = ray.origin + shift;
    result.direction = toe_in > 0.5f ? above + ahead * turned_forward + aside * turned_right : normalize(target - shift);
    result.forward = ray.forward;
    result.right = ray.right;
    return result;
}
