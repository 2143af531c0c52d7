/* functions.h - the part of sh-oracle.c that is read once per precision: T, F(name), PARSE, DIGITS. */

/* ---- one function each: numbers of the query in, components one after the other out ---- */
static int F(run_eval)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_eval)(o->bands, q, out);
}

static int F(run_grad)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_eval_grad)(o->bands, q, out, out + o->bands * o->bands);
}

static int F(run_angles)(const options *o, const T *q, size_t count, T *out)
{
    const int n2 = o->bands * o->bands;
    (void)count;
    return F(sh_eval_angles)(o->bands, q[0], q[1], out, out + n2, out + 2 * n2);
}

static int F(run_hessian)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_eval_hessian)(o->bands, q, NULL, NULL, out);
}

static int F(run_cap)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_zonal_cap)(o->bands, q[0], out, out + o->bands);
}

static int F(run_sphere)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_sphere)(o->bands, q, q + 3, q[6], out, out + o->bands * o->bands);
}

/* point, number of vertices, vertices */
static int F(run_polygon)(const options *o, const T *q, size_t count, T *out)
{
    const T vertices = q[3];
    if (!(vertices >= 0 && vertices <= (T)count) || 4 + 3 * (size_t)vertices != count || (T)(size_t)vertices != vertices)
        return SH_ERROR_COUNT;
    return F(sh_polygon)(o->bands, o->sides, q, (size_t)vertices, q + 4, out, out + o->bands * o->bands);
}

static int F(run_triangle_as_sphere)(const options *o, const T *q, size_t count, T *out)
{
    (void)count;
    return F(sh_triangle_as_sphere)(o->bands, o->sides, q, q + 3, q + 6, q + 9, out, out + o->bands * o->bands, NULL);
}

static int F(run_cosine_product)(const options *o, const T *q, size_t count, T *out)
{
    const int status = F(sh_cosine_product)(o->bands, q, q + 3, out);
    (void)count;
    return status < 0 ? status : F(sh_diffuse_from_product)(out, out + o->bands * o->bands);
}

static int F(run_triple_product)(const options *o, const T *q, size_t count, T *out)
{
    const int status = F(sh_triple_product)(o->bands, q, q + o->bands * o->bands, out);
    (void)count;
    return status < 0 ? status : F(sh_diffuse_from_product)(out, out + o->bands * o->bands);
}

static int F(run_rotate)(const options *o, const T *q, size_t count, T *out)
{
    F(sh_rotation) r;
    const int status = F(sh_rotation_matrix)(q, &r);
    (void)count;
    return status < 0 ? status : F(sh_rotate)(o->bands, &r, 1, q + 9, out);
}

static int F(run_cubemap)(const options *o, const T *q, size_t count, T *out)
{
    const size_t texels = count / 9;
    T *planes = (T *)grow(NULL, (count + 1) * sizeof(T)), *dirs = planes, *normals = planes + 3 * texels;
    T *solid_angles = planes + 6 * texels, *radiance = planes + 7 * texels, *depth = planes + 8 * texels;
    size_t i;
    int status;

    for (i = 0; i < texels; i++) {
        memcpy(dirs + 3 * i, q + 9 * i, 3 * sizeof(T));
        solid_angles[i] = q[9 * i + 3];
        radiance[i] = q[9 * i + 4];
        depth[i] = q[9 * i + 5];
        memcpy(normals + 3 * i, q + 9 * i + 6, 3 * sizeof(T));
    }
    status = F(sh_light_field)(o->bands, texels, dirs, solid_angles, radiance, depth, normals, out,
                               out + o->bands * o->bands);
    free(planes);
    return status;
}

/* ---- text in ---- */
/* Appends the numbers of a line. What is no decimal number is an error of its own on stderr. */
static int F(parse)(const options *o, const char *text, long line, numbers *q)
{
    const function *f = o->function;
    const size_t wanted = (size_t)(f->scalars + f->vectors * o->bands * o->bands), before = q->count;
    size_t found;

    for (;;) {
        const size_t length = strcspn(text, ",");
        char *end;
        const T value = PARSE(text, &end);
        if (end == text || end + strspn(end, " \t") != text + length || memchr(text, 'x', length) || memchr(text, 'X', length)) {
            fprintf(stderr, "sh-oracle: line %ld: \"%.*s\" is not a decimal number\n", line, (int)length, text);
            return SH_ERROR_NOT_FINITE;
        }
        if (q->count + 1 > q->room) q->data = grow(q->data, (q->room = 2 * q->room + 64) * sizeof(T));
        ((T *)q->data)[q->count++] = value;
        if (!text[length]) break;
        text += length + 1;
    }
    found = q->count - before;
    if (f->shape == LONGER ? found >= wanted : found == wanted) return SH_OK;
    fprintf(stderr, "sh-oracle: line %ld: %lu numbers, wanted %s%lu: %s\n", line, (unsigned long)found,
            f->shape == LONGER ? "at least " : "", (unsigned long)wanted, f->query);
    return SH_ERROR_COUNT;
}

/* ---- text out ---- */
/* Between the library's sign and --convention's, either way. */
static void F(convert)(const options *o, T *coeffs)
{
    int l, m;
    if (o->convention == 0) return;
    for (l = 1; l < o->bands; l++)
        for (m = -l; m <= l; m++)
            if (m & 1) coeffs[l * (l + 1) + m] = -coeffs[l * (l + 1) + m];
}

/* One component: "name:size ..." is what it is called and how long it is. Returns the value after it. */
static T *F(print)(const options *o, const char *component, T *value)
{
    const char *size = strchr(component, ':') + 1;
    const int count = *size == 'N' ? o->bands * o->bands : *size == 'n' ? o->bands : 1;
    int i;
    if (*size == 'N') F(convert)(o, value);
    printf("%.*s", (int)(size - 1 - component), component);
    for (i = 0; i < count; i++) printf("," DIGITS, (double)value[i]);
    printf("\n");
    return value + count;
}

/* Answers one query, or passes on the error of reading it. Returns 1 for a bad one. */
static int F(answer)(const options *o, const numbers *q, int status, long line)
{
    static T out[10 * SH_MAX_BANDS * SH_MAX_BANDS];
    const function *f = o->function;
    const char *component;
    T *value = out;
    int i;

    if (status == SH_OK) {
        for (i = 0; i < f->vectors; i++) F(convert)(o, (T *)q->data + f->scalars + i * o->bands * o->bands);
        status = f->F(run)(o, (const T *)q->data, q->count, out);
        if (status != SH_OK) complain(line, status);
    }
    if (status < 0) { printf("error,%s\n", sh_status_string(status)); return 1; }
    for (component = f->components; component; component = strchr(component, ' '), component += component != NULL)
        value = F(print)(o, component, value);
    return 0;
}
