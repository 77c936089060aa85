// Triangle wave: A wave that rises and falls at one speed.
// synonyms: oscillator, zigzag, ping-pong, bounce, lfo
float triangle_wave_value(
    float x,          // 0.0 [-1000000, 1000000] [-10, 10]  Where on the wave; wire time here.
    float frequency,  // 0.5 [0, 1000] [0, 10]  Swings per unit of x, so swings per second for time.
    float amplitude,  // 1.0 [-1000, 1000] [0, 5]  How far the wave swings to each side.
    float offset)     // 0.0 [-1000, 1000] [-5, 5]  Middle of the swing.
{
    float turns = x * frequency;
    float share = turns - floor(turns);
    return offset + amplitude * (1.0f - 4.0f * abs(fract(share + 0.25f) - 0.5f));
}
