/* programs.c - one program per shader files and definitions, compiled when first used. */
#include "gl.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

typedef struct { char key[200]; GLuint id; } program;
static program programs[512];
static int     program_count;

static GLuint compile(GLenum type, const char *defines, const char *const *const *files)
{
    static const char *line[4096];
    const GLuint id = glCreateShader(type);
    GLsizei lines = 0;
    GLint good;
    int f, i;

    line[lines++] = "#version 450 core\n";
    line[lines++] = defines;
    for (f = 0; files[f]; f++) {
        line[lines++] = f == 0 ? "#line 1 0\n" : f == 1 ? "#line 1 1\n" : "#line 1 2\n";
        for (i = 0; files[f][i]; i++) line[lines++] = files[f][i];
    }
    glShaderSource(id, lines, line, NULL);
    glCompileShader(id);
    glGetShaderiv(id, GL_COMPILE_STATUS, &good);
    if (!good) {
        static char log[4096];
        glGetShaderInfoLog(id, sizeof log, NULL, log);
        die("a shader does not compile; its definitions are\n%sand the compiler says\n%s", defines, log);
    }
    return id;
}

GLuint program_use(const char *const *const *first, const char *const *const *second, const char *format, ...)
{
    program *p;
    GLuint a, b = 0;
    GLint good;
    char key[sizeof p->key];
    va_list args;
    int i, n;

    n = snprintf(key, sizeof key, "/* %p %p */\n", (const void *)first[0], second ? (const void *)second[0] : NULL);
    va_start(args, format);
    vsnprintf(key + n, sizeof key - (size_t)n, format, args);
    va_end(args);
    for (i = 0; i < program_count; i++)
        if (!strcmp(programs[i].key, key)) {
            glUseProgram(programs[i].id);
            return programs[i].id;
        }
    if (program_count == (int)(sizeof programs / sizeof *programs)) die("too many shader programs");
    p = &programs[program_count++];
    strcpy(p->key, key);
    p->id = glCreateProgram();
    a = compile(second ? GL_VERTEX_SHADER : GL_COMPUTE_SHADER, key, first);
    glAttachShader(p->id, a);
    if (second) glAttachShader(p->id, b = compile(GL_FRAGMENT_SHADER, key, second));
    glLinkProgram(p->id);
    glDeleteShader(a);
    if (b) glDeleteShader(b);
    glGetProgramiv(p->id, GL_LINK_STATUS, &good);
    if (!good) {
        char log[2048];
        glGetProgramInfoLog(p->id, sizeof log, NULL, log);
        die("shaders do not link; their definitions are\n%sand the linker says\n%s", key, log);
    }
    glUseProgram(p->id);
    return p->id;
}

void programs_close(void)
{
    while (program_count > 0) glDeleteProgram(programs[--program_count].id);
}

static GLint at(GLuint p, const char *name) { return glGetUniformLocation(p, name); }

void set1(GLuint p, const char *name, int v) { glUniform1i(at(p, name), v); }
void set1f(GLuint p, const char *name, float v) { glUniform1f(at(p, name), v); }
void set2(GLuint p, const char *name, float x, float y) { glUniform2f(at(p, name), x, y); }
void set3(GLuint p, const char *name, vec3 v) { glUniform3f(at(p, name), v.x, v.y, v.z); }
void set3i(GLuint p, const char *name, int x, int y, int z) { glUniform3i(at(p, name), x, y, z); }
