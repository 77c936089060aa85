// Time: The time of the picture.
// synonyms: clock, animation, seconds, frame
float time_value(
    float time,
    float speed)  // 1.0 [-1000, 1000] [-5, 5]  How many times as fast; negative runs backwards.
{
    return time * speed;
}
