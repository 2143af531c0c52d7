/* context.c - an OpenGL 4.5 core context without a window: EGL on a device, hardware first, or without a
 * surface. */
#include "gl.h"

#include <epoxy/egl.h>
#include <stdio.h>
#include <string.h>

static EGLDisplay display = EGL_NO_DISPLAY;

/* What the passes need beyond the version: each said by name when it is missing. */
int context_enough(void)
{
    GLint threads = 0, shared = 0;

    if (epoxy_gl_version() < 45) {
        fprintf(stderr, "gl: OpenGL 4.5 is needed, this is %s on %s\n", (const char *)glGetString(GL_VERSION),
                (const char *)glGetString(GL_RENDERER));
        return 0;
    }
    glGetIntegerv(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, &threads);
    glGetIntegerv(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, &shared);
    if (threads < 512 || shared < 32768) {
        fprintf(stderr, "gl: work groups of 512 threads with 32768 bytes are needed, this has %d and %d\n", threads, shared);
        return 0;
    }
    return 1;
}

static int start(EGLDisplay d, char *why, size_t room)
{
    static const EGLint version[] = { EGL_CONTEXT_MAJOR_VERSION, 4, EGL_CONTEXT_MINOR_VERSION, 5,
                                      EGL_CONTEXT_OPENGL_PROFILE_MASK, EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT, EGL_NONE };
    EGLContext c;
    EGLint major, minor;

    if (d == EGL_NO_DISPLAY || !eglInitialize(d, &major, &minor)) {
        snprintf(why, room, "eglInitialize fails (EGL error 0x%x)", (unsigned)eglGetError());
        return 0;
    }
    if (!epoxy_has_egl_extension(d, "EGL_KHR_surfaceless_context")) snprintf(why, room, "no EGL_KHR_surfaceless_context");
    else if (!epoxy_has_egl_extension(d, "EGL_KHR_no_config_context") &&
             !epoxy_has_egl_extension(d, "EGL_MESA_configless_context")) snprintf(why, room, "no EGL_KHR_no_config_context");
    else if (!eglBindAPI(EGL_OPENGL_API)) snprintf(why, room, "EGL has OpenGL ES only");
    else if ((c = eglCreateContext(d, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, version)) == EGL_NO_CONTEXT)
        snprintf(why, room, "no OpenGL 4.5 core context (EGL error 0x%x)", (unsigned)eglGetError());
    else if (!eglMakeCurrent(d, EGL_NO_SURFACE, EGL_NO_SURFACE, c))
        snprintf(why, room, "eglMakeCurrent fails (EGL error 0x%x)", (unsigned)eglGetError());
    else {
        display = d;
        return 1;
    }
    eglTerminate(d);
    return 0;
}

/* Hardware first: a device whose extensions do not call it software. */
int context_headless(void)
{
    EGLDeviceEXT device[32];
    EGLint devices = 0, i;
    int software;
    char why[160] = "libEGL offers neither devices nor a surfaceless platform";

    if (!epoxy_has_egl()) {
        fprintf(stderr, "gl: libEGL.so.1 is missing\n");
        return 0;
    }
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_device") &&
        epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_device_enumeration"))
        eglQueryDevicesEXT(32, device, &devices);
    for (software = 0; software < 2; software++)
        for (i = 0; i < devices; i++) {
            const char *e = eglQueryDeviceStringEXT(device[i], EGL_EXTENSIONS);
            if ((e && strstr(e, "EGL_MESA_device_software")) != software) continue;
            if (start(eglGetPlatformDisplayEXT(EGL_PLATFORM_DEVICE_EXT, device[i], NULL), why, sizeof why) && context_enough())
                return 1;
            context_close();
        }
    if (epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless") &&
        start(eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, NULL), why, sizeof why))
        return context_enough();
    fprintf(stderr, "gl: no headless OpenGL: %s (%d EGL devices tried)\n", why, devices);
    return 0;
}

void context_close(void)
{
    if (display == EGL_NO_DISPLAY) return;
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglTerminate(display);
    display = EGL_NO_DISPLAY;
}
