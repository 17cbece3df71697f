#version 300 es
precision highp float;
precision highp int;
precision mediump sampler3D;
#define HW_PERFORMANCE 1
uniform vec3 iResolution;
uniform float iTime;
uniform float iChannelTime[4];
uniform vec4 iMouse;
uniform vec4 iDate;
uniform float iSampleRate;
uniform vec3 iChannelResolution[4];
uniform int iFrame;
uniform float iTimeDelta;
uniform float iFrameRate;
uniform sampler2D iChannel0;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh0;
uniform sampler2D iChannel1;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh1;
uniform sampler2D iChannel2;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh2;
uniform sampler2D iChannel3;
uniform struct { sampler2D sampler; vec3 size; float time; int loaded; } iCh3;
void mainImage(out vec4 color, in vec2 pixel);
out vec4 shadertoy_out_color;
void st_assert(bool holds) { if (!holds) shadertoy_out_color.x = -1.0; }
void st_assert(bool holds, int which) { st_assert(holds || which > 0); }
void main() {
    shadertoy_out_color = vec4(1.0);
    vec4 color = vec4(1e20);
    mainImage(color, gl_FragCoord.xy);
    shadertoy_out_color = vec4(color.rgb, 1.0);
}
