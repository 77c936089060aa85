// Expression: A number computed by a formula that you type: x, y and z are the point, time is in seconds, a to d your own.
// synonyms: formula, equation, function, code, script, math, calculate, term
// number a: 1.0 [-1000000, 1000000] [-10, 10]  First number of the formula.
// number b: 1.0 [-1000000, 1000000] [-10, 10]  Second number of the formula.
// number c: 1.0 [-1000000, 1000000] [-10, 10]  Third number of the formula.
// number d: 1.0 [-1000000, 1000000] [-10, 10]  Fourth number of the formula.
float expression_value(
    float formula)  // formula "a * sin(4 * x) * sin(4 * y + time) + b"  What is computed, such as sqrt(x^2 + z^2) / a.
{
    return formula;
}
