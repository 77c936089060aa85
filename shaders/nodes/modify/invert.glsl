// Invert: Swaps inside and outside: what was solid is empty, and everything else is solid.
// field: exact
// synonyms: complement, negate, not, inside out, flip, reverse
// combiner: hard
float invert_distance(float d)
{
    return -d;
}

Box invert_bounds()
{
    return everywhere();
}
