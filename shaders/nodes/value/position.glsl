// Position: The point in space where the field is asked, in metres.
// synonyms: point, coordinates, xyz, location
vec3 position_value(vec3 p)
{
    return p;
}
