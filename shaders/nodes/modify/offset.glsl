// Offset: Moves the surface outwards or inwards.
// field: bound
// synonyms: grow, shrink, inset, outset, inflate, deflate, erode
float offset_distance(
    float d,
    float amount)  // 0.15 [-100, 100] [-1, 1] m  How far the surface moves outwards; negative moves it inwards.
{
    return d - amount;
}

Box offset_bounds(float amount, Box child)
{
    return grow_box(child, amount);
}
