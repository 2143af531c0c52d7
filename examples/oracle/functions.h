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
    if (!(vertices >= 0 && vertices <= (T)count)) return SH_ERROR_COUNT;
    if (4 + 3 * (size_t)vertices != count || (T)(size_t)vertices != vertices) return SH_ERROR_COUNT;
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

static int F(run_convert)(const options *o, const T *q, size_t count, T *out)
{
    (void)o;
    memcpy(out, q, count * sizeof *q);
    return SH_OK;
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
/* How many numbers a letter of a query's layout stands for: in the text (theirs), and to the library (ours). */
static size_t F(width)(const options *o, char kind, int ours)
{
    return kind == 's' ? 1 : kind == 'v' ? 3 : kind == 'm' ? 9
         : (size_t)(ours ? o->bands * o->bands : sh_convention_size(o->from, o->bands));
}

/* The query in the library's axes and coefficients; returns how many numbers that is. `ours` has room for it. */
static size_t F(from_theirs)(const options *o, const T *theirs, size_t count, T *ours)
{
    const char *layout = o->function->layout;
    const T *const end = theirs + count;
    T *const first = ours;
    int i, k;

    while (theirs < end) {
        if (*layout == '*') layout++;
        if (*layout == 'v') {
            F(sh_convert_direction_from)(o->convention, theirs, ours);
        } else if (*layout == 'm') {                                        /* rows, then columns */
            T column[3];
            for (i = 0; i < 3; i++) F(sh_convert_direction_from)(o->convention, theirs + 3 * i, ours + 3 * i);
            for (i = 0; i < 3; i++) {
                for (k = 0; k < 3; k++) column[k] = ours[3 * k + i];
                F(sh_convert_direction_from)(o->convention, column, column);
                for (k = 0; k < 3; k++) ours[3 * k + i] = column[k];
            }
        } else if (*layout == 'c') {
            F(sh_convert_from)(o->from, o->bands, theirs, ours);
        } else {
            *ours = *theirs;
        }
        theirs += F(width)(o, *layout, 0);
        ours += F(width)(o, *layout, 1);
        if (layout[1]) layout++;
        else if (!strchr(o->function->layout, '*')) layout = o->function->layout;       /* the next line's */
    }
    return (size_t)(ours - first);
}

static T F(answers)[10 * SH_MAX_BANDS * SH_MAX_BANDS];

/* The function's answer to the numbers from `first` on. */
static int F(call)(const options *o, const numbers *q, size_t first, long line)
{
    T *ours = (T *)grow(NULL, (q->count - first + 2 * SH_MAX_BANDS * SH_MAX_BANDS) * sizeof(T));
    const size_t count = F(from_theirs)(o, (const T *)q->data + first, q->count - first, ours);
    const int status = o->function->F(run)(o, ours, count, F(answers));
    free(ours);
    if (status != SH_OK) complain(line, status);
    return status;
}

/* Appends the numbers of a line, which must fit the layout of the function's query; a line that is only a part of
 * the query is tried alone, so that what is wrong with it can be said with its number. */
static int F(parse)(const options *o, const char *text, long line, numbers *q)
{
    const int shown = 40;
    const char *layout;
    const size_t before = q->count;
    size_t found = 0, wanted = 0;

    for (;; found++) {
        const size_t length = strcspn(text, ",");
        char *end;
        const T value = PARSE(text, &end);
        if (end == text || end + strspn(end, " \t") != text + length
            || memchr(text, 'x', length) || memchr(text, 'X', length)) {
            fprintf(stderr, "sh-oracle: line %ld: \"%.*s\" is not a decimal number\n", line,
                    length < (size_t)shown ? (int)length : shown, text);
            return SH_ERROR_NOT_FINITE;
        }
        if (q->count + 1 > q->room) q->data = grow(q->data, (q->room = 2 * q->room + 64) * sizeof(T));
        ((T *)q->data)[q->count++] = value;
        if (!text[length]) break;
        text += length + 1;
    }
    found++;
    for (layout = o->function->layout; *layout && *layout != '*'; layout++) wanted += F(width)(o, *layout, 0);
    if (*layout ? found >= wanted && (found - wanted) % F(width)(o, layout[1], 0) == 0 : found == wanted)
        return o->function->whole ? F(call)(o, q, before, line) : SH_OK;
    fprintf(stderr, "sh-oracle: line %ld: %lu numbers do not make %s\n", line, (unsigned long)found,
            o->function->query);
    return SH_ERROR_COUNT;
}

/* ---- text out ---- */
static void F(print)(const char *name, size_t length, const T *value, int count)
{
    int i;
    printf("%.*s", (int)length, name);
    for (i = 0; i < count; i++) printf("," DIGITS, (double)value[i]);
    printf("\n");
}

static void F(print_coeffs)(const options *o, const char *name, size_t length, const T *value)
{
    T theirs[2 * SH_MAX_BANDS * SH_MAX_BANDS];
    F(sh_convert_to)(o->convention, o->bands, value, theirs);
    F(print)(name, length, theirs, sh_convention_size(o->convention, o->bands));
}

/* Which of our axes each of theirs is. */
static void F(axes)(const options *o, int axis[3])
{
    T v[3] = { 0, 1, 2 };
    int k;
    F(sh_convert_direction_to)(o->convention, v, v);
    for (k = 0; k < 3; k++) axis[k] = (int)v[k];
}

/* One component: "name:size ..." is what it is called and how long it is. Returns the value after it. */
static const T *F(print_component)(const options *o, const char *component, const T *value)
{
    static const char *const first[] = { "dx", "dy", "dz" }, *const second[] = { "xx", "xy", "xz", "yy", "yz", "zz" };
    static const int plane[3][3] = { { 0, 1, 2 }, { 1, 3, 4 }, { 2, 4, 5 } };
    const size_t length = strcspn(component, ":");
    const int n2 = o->bands * o->bands;
    int axis[3], i, k, at = 0;

    F(axes)(o, axis);
    switch (component[length + 1]) {
    case 'N':
        F(print_coeffs)(o, component, length, value);
        return value + n2;
    case 'V':
        for (k = 0; k < 3; k++) F(print_coeffs)(o, first[k], 2, value + axis[k] * n2);
        return value + 3 * n2;
    case 'H':
        for (i = 0; i < 3; i++)
            for (k = i; k < 3; k++, at++) F(print_coeffs)(o, second[at], 2, value + plane[axis[i]][axis[k]] * n2);
        return value + 6 * n2;
    default:
        at = component[length + 1] == 'n' ? o->bands : 1;
        F(print)(component, length, value, at);
        return value + at;
    }
}

/* Answers one query, or passes on the error of reading it. Returns 1 for a bad one. */
static int F(answer)(const options *o, const numbers *q, int status, long line)
{
    const char *component;
    const T *value = F(answers);

    if (status == SH_OK) status = F(call)(o, q, 0, line);
    if (status < 0) { printf("error,%s\n", sh_status_string(status)); return 1; }
    for (component = o->function->components; component; component = strchr(component, ' ')) {
        component += *component == ' ';
        value = F(print_component)(o, component, value);
    }
    return 0;
}
