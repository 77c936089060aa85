// Square wave: A wave that jumps between two numbers.
// synonyms: oscillator, pulse, blink, on off, lfo
float square_wave_value(
    float x,          // 0.0 [-1000000, 1000000] [-10, 10]  Where on the wave; wire time here.
    float frequency,  // 0.5 [0, 1000] [0, 10]  Swings per unit of x, so swings per second for time.
    float amplitude,  // 1.0 [-1000, 1000] [0, 5]  How far the wave swings to each side.
    float offset,     // 0.0 [-1000, 1000] [-5, 5]  Middle of the swing.
    float duty)       // 0.5 [0, 1]  Share of the time at the larger number.
{
    float turns = x * frequency;
    float share = turns - floor(turns);
    return offset + (share < duty ? amplitude : -amplitude);
}
