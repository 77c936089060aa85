// Sine: A smooth wave, to swing things back and forth.
// synonyms: wave, oscillator, swing, sinus, cosine
const float SINE_TWO_PI = 6.28318531f;

float sine_value(
    float x,          // 0.0 [-1000000, 1000000] [-10, 10]  Where on the wave; wire time here.
    float frequency,  // 0.5 [0, 1000] [0, 10]  Swings per unit of x, so swings per second for time.
    float phase,      // 0.0 [-3600, 3600] [-180, 180] deg  Where on the swing to begin.
    float amplitude,  // 1.0 [-1000, 1000] [0, 5]  How far the wave swings to each side.
    float offset)     // 0.0 [-1000, 1000] [-5, 5]  Middle of the swing.
{
    float turns = x * frequency;
    return offset + amplitude * sin((turns - floor(turns)) * SINE_TWO_PI + phase);
}
