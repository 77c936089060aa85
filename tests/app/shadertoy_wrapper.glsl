#version 300 es
// What a Shadertoy image shader finds around itself, for checking exports offline.
precision highp float;
precision highp int;

uniform vec3 iResolution;
uniform float iTime;
uniform float iTimeDelta;
uniform float iFrameRate;
uniform int iFrame;
uniform float iChannelTime[4];
uniform vec3 iChannelResolution[4];
uniform vec4 iMouse;
uniform vec4 iDate;
uniform float iSampleRate;
uniform sampler2D iChannel0;
uniform sampler2D iChannel1;
uniform sampler2D iChannel2;
uniform sampler2D iChannel3;

void mainImage(out vec4 colour, in vec2 position);

out vec4 pixel;

void main()
{
    vec4 colour = vec4(1e20);
    mainImage(colour, gl_FragCoord.xy);
    pixel = vec4(colour.rgb, 1.0);
}
