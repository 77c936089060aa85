// Cell: Which copy of the nearest repeat this is, as whole numbers along x, y and z.
// synonyms: copy, instance, index, id, tile
vec3 cell_value(vec3 cell)
{
    return cell;
}
