// Everything on one line, and every token on its own.

fn f(a:f32)->f32{if a>3.0{return a*2.0;}else if a>1.0{return a;}var r=0.0;for(var i=0;i<3;i++){r+=a;}return r;}

fn
g
(
a
:
f32
)
->
f32
{
return
a
+
f
(
a
)
;
}

@fragment fn main_fragment(@builtin(position)at:vec4f)->@location(0)vec4f{let x=floor(at.x);return vec4f(f(x),g(x),f(1.5),g(at.y));}
