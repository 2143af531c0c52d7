/* text.vert - letters made of quads, in pixels from the top left corner. */
layout(location = 0) in vec2 position;
uniform vec2 size, at;
uniform float zoom;

void main()
{
    vec2 p = (at + zoom * position) / size * 2.0 - 1.0;
    gl_Position = vec4(p.x, -p.y, 0.0, 1.0);
}
