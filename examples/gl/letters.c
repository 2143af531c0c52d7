/* letters.c - text on the picture: the quads of stb_easy_font, white on a dark panel. */
#include "gl.h"
#include "gl_shaders.h"

#include <stb/stb_easy_font.h>

static GLuint corners, layout;

void letters_open(void)
{
    glCreateBuffers(1, &corners);
    glCreateVertexArrays(1, &layout);
    glVertexArrayVertexBuffer(layout, 0, corners, 0, 2 * sizeof(float));
    glVertexArrayAttribFormat(layout, 0, 2, GL_FLOAT, GL_FALSE, 0);
    glVertexArrayAttribBinding(layout, 0, 0);
    glEnableVertexArrayAttrib(layout, 0);
}

void letters_close(void)
{
    glDeleteBuffers(1, &corners);
    glDeleteVertexArrays(1, &layout);
}

static void triangles(const float *corner, int count)
{
    glNamedBufferData(corners, (GLsizeiptr)(2 * (size_t)count * sizeof(float)), corner, GL_STREAM_DRAW);
    glDrawArrays(GL_TRIANGLES, 0, count);
}

void letters_draw(const settings *o, float x, float y, float zoom, const char *text)
{
    static struct { float x, y, z; unsigned char colour[4]; } quad[4096][4];
    static float corner[4096 * 12];
    char *const t = (char *)(size_t)text;                   /* stb takes char *, and only reads it */
    const float r = (float)stb_easy_font_width(t) + 4, b = (float)stb_easy_font_height(t) + 2;
    const float panel[12] = { -4, -4, r, -4, r, b, -4, -4, r, b, -4, b };
    const int quads = stb_easy_font_print(0, 0, t, NULL, quad, sizeof quad);
    GLuint p;
    int i, k;

    for (i = 0; i < quads; i++)
        for (k = 0; k < 6; k++) {
            static const int of[6] = { 0, 1, 2, 0, 2, 3 };
            corner[12 * i + 2 * k] = quad[i][of[k]].x;
            corner[12 * i + 2 * k + 1] = quad[i][of[k]].y;
        }
    passes_onto_picture(o);
    p = program_use(FILES(text_vert), FILES(text_frag), "\n");
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glBindVertexArray(layout);
    set2(p, "size", (float)o->width, (float)o->height);
    set2(p, "at", x, y);
    set1f(p, "zoom", zoom);
    glUniform4f(glGetUniformLocation(p, "ink"), 0.02f, 0.02f, 0.03f, 0.6f);
    triangles(panel, 6);
    glUniform4f(glGetUniformLocation(p, "ink"), 1, 1, 1, 1);
    triangles(corner, 6 * quads);
    glDisable(GL_BLEND);
}
