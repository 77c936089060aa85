// Modulo: What is left of a number after whole steps; it counts up from 0 and starts again.
// synonyms: remainder, wrap, repeat, loop, mod, math
float modulo_value(
    float x,       // 0.0 [-1000000, 1000000] [-10, 10]  The number.
    float period)  // 1.0 [0.000001, 1000000] [0.1, 10]  Length of a step.
{
    return x - period * floor(x / period);
}
